"""Random expressions: any, homogeneous ones, polynomials, and those with relative bounds."""

from .trees import reads, subtrees

CONSTANTS = ("2", "3", "0.5", "4", "0.25", "1.5", "5", "0x1.8p-3", "0.1", "7", "1", "-2", "-0.75",
             "0")
FACTORS = tuple(word for word in CONSTANTS if word != "0")
POSITIVE = tuple(word for word in FACTORS if word[0] != "-")


def name(word):
    return ("input", word)


class Expressions:
    """Draws trees over some leaves. Earlier subtrees are used again, also on the other side."""

    def __init__(self, rng, leaves, weights=None):
        self.rng = rng
        self.leaves = leaves
        self.pool = []
        self.weights = {"+": 3, "-": 4, "*": 4, "square": 3, "^": 0.5, "scale": 1.5, "shift": 0.8,
                        "/": 0.5, "sqrt": 0.4, "min": 0.5, "max": 0.5, "abs": 0.5, "neg": 0.4,
                        "sum": 0.4, "product": 0.2, "choices": 0.2, "again": 1.5}
        self.weights.update(weights or {})

    def leaf(self):
        return self.rng.choice(self.leaves)

    def kept(self, tree):
        self.pool.append(tree)
        return tree

    def any(self, operations):
        """A tree of about `operations` operations."""
        rng = self.rng
        if operations <= 0:
            return self.leaf()
        kind, = rng.choices(list(self.weights), list(self.weights.values()))
        rest = operations - 1
        if kind == "again":
            return rng.choice(self.pool) if self.pool else self.any(operations)
        if kind in "+-*/" or kind in ("min", "max"):
            left = rng.randint(0, rest)
            return self.kept((kind, self.any(left), self.any(rest - left)))
        if kind == "square":
            return self.kept(("^", self.any(rest), 2))
        if kind == "^":
            return self.kept(("^", self.any(rest // 2), rng.choice((1, 3, 3, 4, 5, 6))))
        if kind == "scale":
            return self.kept((rng.choice("**/"), self.any(rest), self.constant(FACTORS)))
        if kind == "shift":
            return self.kept((rng.choice("+-"), self.any(rest), self.constant(CONSTANTS)))
        if kind == "sqrt":
            return self.kept(("sqrt", self.nonnegative(rest)))
        if kind in ("abs", "neg"):
            return self.kept((kind, self.any(rest)))
        count = rng.choice((2, 3, 3, 4, 5))
        function = rng.choice(("min", "max")) if kind == "choices" else kind
        return self.kept((function, *(self.any(rest // count) for _ in range(count))))

    def constant(self, words):
        return ("constant", self.rng.choice(words))

    def nonnegative(self, operations):
        """A tree for a root: a square, a sum of two, or an absolute value."""
        if self.rng.random() < 0.5:
            return ("abs", self.any(operations - 1))
        squares = [("^", self.any(operations // 2 - 1), 2) for _ in range(self.rng.choice((1, 2)))]
        return ("+", *squares) if len(squares) == 2 else squares[0]

    def positive(self, operations):
        """Products, quotients, roots and sums of nonnegative operands; differences of operands."""
        rng = self.rng
        if operations <= 0:
            return self.leaf()
        rest = operations - 1
        left = rng.randint(0, rest)
        kind = rng.choice(("+", "+", "*", "*", "/", "sqrt", "square", "min", "max", "difference",
                           "scale"))
        if kind == "difference":
            return self.kept(("^", ("-", self.leaf(), self.leaf()), 2))
        if kind == "square":
            return self.kept(("^", self.positive(rest), 2))
        if kind == "sqrt":
            return self.kept(("sqrt", self.positive(rest)))
        if kind == "scale":
            return self.kept(("*", self.constant(POSITIVE), self.positive(rest)))
        return self.kept((kind, self.positive(left), self.positive(rest - left)))

    def homogeneous(self, degree, operations):
        """A tree that grows by t^degree if all leaves grow by t."""
        rng = self.rng
        if degree == 1:
            return self.affine(operations)
        if operations <= 1:
            return self.kept(("*", self.homogeneous(degree - 1, 0), self.leaf()))
        rest = operations - 1
        kind = rng.choice(("+", "-", "+", "-", "product", "product", "square", "scale", "choice",
                           "sum"))
        if kind == "square" and degree % 2 == 0:
            return self.kept(("^", self.homogeneous(degree // 2, rest), 2))
        if kind == "scale":
            return self.kept(("*", self.homogeneous(degree, rest), self.constant(FACTORS)))
        if kind == "choice":
            kind = rng.choice(("min", "max"))
        if kind == "sum":
            return self.kept(("sum", *(self.homogeneous(degree, rest // 3) for _ in range(3))))
        left = rng.randint(0, rest)
        if kind in ("product", "square"):
            return self.kept(("*", self.homogeneous(degree - 1, left), self.affine(rest - left)))
        sides = self.homogeneous(degree, left), self.homogeneous(degree, rest - left)
        return self.kept((kind, *sides))

    def affine(self, operations):
        rng = self.rng
        if operations <= 0:
            return self.leaf()
        rest = operations - 1
        kind = rng.choice(("+", "-", "-", "-", "min", "max", "abs", "neg", "scale"))
        if kind in ("abs", "neg"):
            return self.kept((kind, self.affine(rest)))
        if kind == "scale":
            return self.kept(("*", self.affine(rest), self.constant(("2", "0.5", "-1", "4"))))
        left = rng.randint(0, rest)
        return self.kept((kind, self.affine(left), self.affine(rest - left)))

    def norms(self):
        """A sum of squares against a square, or against another sum of squares."""
        count = self.rng.choice((1, 2, 3))
        f = ("sum", *(self.squared_difference() for _ in range(count))) if count > 1 \
            else self.squared_difference()
        g = self.rng.choice((("^", ("+", self.leaf(), self.leaf()), 2), ("^", self.leaf(), 2),
                             self.squared_difference(),
                             ("+", self.squared_difference(), self.squared_difference())))
        return (f, g) if self.rng.random() < 0.7 else (g, f)

    def squared_difference(self):
        return self.kept(("^", ("-", self.leaf(), self.leaf()), 2))

    def identity(self, operations):
        """Two ways to write one value, so that only rounding tells them apart."""
        a, b, c = (self.any(operations // 3) for _ in range(3))
        two = ("constant", "2")

        def square(x):
            return ("^", x, 2)

        pairs = [
            (square(("-", a, b)), ("+", ("-", square(a), ("*", two, ("*", a, b))), square(b))),
            (("*", ("+", a, b), ("-", a, b)), ("-", square(a), square(b))),
            (("*", a, ("+", b, c)), ("+", ("*", a, b), ("*", a, c))),
            (("+", ("+", a, b), c), ("+", a, ("+", b, c))),
            (("sum", a, b, c, a), ("+", ("+", ("+", a, b), c), a)),
            (("abs", a), ("sqrt", square(a))),
            (("max", a, b), ("+", ("min", a, b), ("abs", ("-", a, b)))),
            (("/", a, ("constant", "3")), ("*", a, ("constant", "0.3333333"))),
            (("^", a, 3), ("product", a, a, a)),
        ]
        return self.rng.choice(pairs)

    def over(self, vectors, count):
        """A reduction over vectors of `count` elements."""
        rng = self.rng
        k = ("index", "k")
        elements = [("element", vector, k) for vector in vectors]
        weights = {"/": 0, "sqrt": 0.1, "again": 0}
        inner = Expressions(rng, elements + [rng.choice(self.leaves)], weights)
        term = inner.any(rng.choice((2, 3, 4)))
        if rng.random() < 0.2:
            term = ("*", term, k)
        function = rng.choice(("sum", "sum", "sum", "min", "max", "product"))
        return ("over", function, "k", 0, count - 1, term)


def candidates_for_let(tree):
    """Subtrees that a let may stand for: no leaves, and without an index."""
    return [below for _, below in subtrees(tree)
            if below[0] not in ("constant", "input", "index") and not reads(below, "index")]
