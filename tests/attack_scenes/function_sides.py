"""Random sides with functions, whose arguments stay within the functions' domains."""

import math
from fractions import Fraction

from .elementary import FUNCTIONS, LEAST
from .trees import dyadic_text

# Arguments within which values stay moderate.
DOMAINS = {"exp": (-9, 4), "exp2": (-12, 5), "expm1": (-6, 3), "log": (0, 60), "log2": (0, 60),
           "log1p": (-1, 20), "sin": (-11, 11), "cos": (-11, 11), "tan": (-1.5, 1.5),
           "atan": (-30, 30), "sinh": (-4, 4), "cosh": (-4, 4), "tanh": (-7, 7)}
POWERS = {"0.3": (0, 9), "5/11": (0, 2), "0.75": (0, 4), "1.01": (0, 9), "2.4": (0, 4),
          "17": (-1.25, 1.25), "20": (-1, 1), "-1/3": (0, 9), "-1.5": (0, 6), "-2": (0, 6),
          "-17": (0.5, 4)}
DIVISORS = ("1", "7", "0.75", "0.1", "2.5", "100", "0x1p-3", "6.28318530717959", "3600", "0.33333")
FACTORS = ("2", "0.5", "-1", "3", "0.25", "-0.75", "0.1", "1.5")


class FunctionSides:
    """Draws two sides, the first with a function. `range_of` gives an input's range (low, high) by
    its name. Functions that jump are drawn where inputs are exact."""

    def __init__(self, rng, leaves, range_of, are_exact):
        self.rng = rng
        self.leaves = leaves
        self.range_of = range_of
        self.kinds = {"smooth": 6, "power": 2, "quotient": 2, "table": 2, "decades": 3,
                      "formula": 4, "monomial": 4}
        if are_exact:
            self.kinds |= {"mod": 2, "sign": 1, "direction": 2}

    def drawn(self):
        other = self.rng.choice((self.value, self.linear, self.leaf, self.constant))
        return self.value(), other()

    def leaf(self):
        return self.rng.choice(self.leaves)

    def constant(self):
        return ("constant", self.rng.choice(FACTORS))

    def linear(self):
        """A linear expression of one or two inputs."""
        rng, tree = self.rng, self.leaf()
        if rng.random() < 0.5:
            tree = (rng.choice("+-"), tree, self.leaf())
        if rng.random() < 0.4:
            tree = ("*", tree, self.constant())
        return tree

    def value(self):
        """A function, or a product, sum, choice or function of one."""
        rng, tree = self.rng, self.function()
        kind = rng.choice(("plain", "plain", "plain", "factor", "product", "sum", "square", "choice",
                           "abs", "log"))
        if kind == "plain":
            return tree
        if kind == "factor":
            return ("*", self.constant(), tree)
        if kind == "square":
            return ("^", tree, 2)
        if kind == "abs":
            return ("abs", tree)
        if kind == "log":  # softplus and its kin
            return ("log", ("+", ("^", tree, 2), self.some("0.5", "1", "0x1p-7")))
        second = rng.choice((self.leaf, self.linear, self.function))()
        operation = {"product": "*", "sum": rng.choice("+-")}.get(kind) or rng.choice(("min", "max"))
        return (operation, tree, second)

    def some(self, *words):
        return ("constant", self.rng.choice(words))

    def function(self):
        kind, = self.rng.choices(list(self.kinds), list(self.kinds.values()))
        return getattr(self, kind)()

    def smooth(self):
        function = self.rng.choice(FUNCTIONS)
        return (function, self.moved(*DOMAINS[function], function in LEAST))

    def power(self):
        power = self.rng.choice(list(POWERS))
        return ("power", self.moved(*POWERS[power], power.startswith("-")), power)

    def quotient(self):
        divisor = self.moved(0, self.rng.choice((1, 4, 60)), True)
        if self.rng.random() < 0.3:
            divisor = ("neg", divisor)
        return ("/", self.rng.choice((self.leaf, self.linear))(), divisor)

    def decades(self):
        """A function that is steep near 0, of an input that is not negative."""
        tree = self.leaf()
        if self.bounds(tree)[0] < 0:
            return self.smooth()
        if self.rng.random() < 0.3:
            tree = ("*", tree, self.some("3", "0.25", "0.1"))
        kind = self.rng.choice(("log", "log2", "power", "quotient"))
        if kind == "quotient":
            return ("/", self.leaf(), tree)
        if kind == "power":
            return ("power", tree, self.rng.choice(("0.3", "0.75", "-1/3", "-1.5", "-2")))
        return (kind, tree)

    def formula(self):
        """Several operations on one number, which a lane makes one table of."""
        rng, t = self.rng, self.moved(-4, 4)
        inner = rng.choice((("exp", t), ("exp", ("neg", t)), ("^", t, 2), ("cosh", t)))
        positive = ("+", inner, self.some("1", "0.5", "0x1p-6"))
        outer = rng.choice(("log", "/", "sqrt", "power", "sin", "tanh", "bell", "square"))
        if outer == "/":
            return ("/", rng.choice((self.constant(), t, ("sin", t))), positive)
        if outer == "power":
            return ("power", positive, rng.choice(("0.3", "-1/3", "-1.5")))
        if outer == "bell":
            return ("*", t, ("exp", ("neg", ("^", t, 2))))
        if outer == "square":
            return ("-", ("^", ("sin", t), 2), ("*", self.constant(), ("cos", t)))
        return (outer, positive if outer in ("log", "sqrt") else ("tanh", inner))

    def monomial(self):
        """A function of a product or quotient of inputs above 0, which logarithms may add up to."""
        rng = self.rng
        leaves = [leaf for leaf in self.leaves if self.bounds(leaf)[0] > 0]
        if not leaves:
            return self.formula()
        a, b = rng.choice(leaves), rng.choice(leaves)
        tree = rng.choice((("/", a, b), ("*", a, b), ("*", ("^", a, 2), ("sqrt", b)),
                           ("/", ("*", a, rng.choice(leaves)), b)))
        if rng.random() < 0.4:
            tree = ("*", tree, self.some("3", "0.25", "0x1p-9"))
        function = rng.choice(("exp", "atan", "tanh", "log1p", "log"))
        return (function, ("neg", tree) if function == "exp" else tree)

    def exact(self):
        """An input or a difference of two."""
        return self.rng.choice((self.leaf(), ("-", self.leaf(), self.leaf())))

    def mod(self):
        return ("mod", self.exact(), self.rng.choice(DIVISORS))

    def sign(self):
        return ("*", ("sign", self.exact()), self.leaf())

    def direction(self):
        return ("atan2", self.leaf(), self.exact())

    def table(self):
        """Points over an argument's range or a part of it, on a grid or not."""
        rng, tree = self.rng, self.linear()
        low, high = map(float, self.bounds(tree))
        high = high if high > low else low + 1
        degree, count = rng.choice((1, 1, 2, 3)), rng.choice((4, 5, 9, 17, 40))
        places = [low + (high - low) * k / (count - 1) for k in range(count)]
        if rng.random() < 0.5:
            inner = {rng.uniform(low, high) for _ in range(count - 2)}
            places = sorted({low, high} | inner)
        if rng.random() < 0.3:
            places = places[1:] if degree < count - 1 else places
        steep = rng.choice((1, 1, 4, 0.01))
        points = ";".join(f"{x!r},{rng.uniform(-steep, steep):.4g}" for x in places)
        return ("table", tree, points, degree)

    def moved(self, first, last, is_open=False):
        """A linear expression that is scaled and moved into a part of a domain."""
        rng, first, last = self.rng, Fraction(first), Fraction(last)
        size = (last - first) * rng.choice((1, 1, Fraction(1, 2), Fraction(1, 8), Fraction(1, 64)))
        low = first + (last - first - size) * Fraction(rng.randint(0, 64), 64)
        if rng.random() < 0.3:
            low = rng.choice((first, last - size))
        if is_open:  # at the end there is no value: a lane's argument has a limit there
            low += rng.choice((0, Fraction(1, 1024), Fraction(1, 64), Fraction(1, 4), 1))
        tree = self.linear()
        least, most = self.bounds(tree)
        if low <= least and most <= low + size and rng.random() < 0.6:
            return tree
        scale = Fraction(2) ** math.floor(math.log2(size / (most - least))) if most > least else 1
        if scale != 1:
            tree = ("*", tree, ("constant", dyadic_text(scale)))
        moved = Fraction(math.ceil((low - least * scale) * 4096), 4096)
        return ("+", tree, ("constant", dyadic_text(moved))) if moved else tree

    def bounds(self, tree):
        """The range of a linear expression."""
        operation, *operands = tree
        if operation == "input":
            return self.range_of(operands[0])
        if operation == "*":
            low, high = self.bounds(operands[0])
            ends = [end * Fraction(operands[1][1]) for end in (low, high)]
            return min(ends), max(ends)
        (a, b), (c, d) = map(self.bounds, operands)
        if operands[0] == operands[1]:
            return (2 * a, 2 * b) if operation == "+" else (Fraction(0), Fraction(0))
        return (a + c, b + d) if operation == "+" else (a - d, b - c)
