"""Random sides with functions, whose arguments stay within the functions' domains."""

import math
from fractions import Fraction

from .elementary import FUNCTIONS, LEAST
from .trees import dyadic_text

# Arguments within which values stay moderate.
DOMAINS = {"exp": (-9, 4), "exp2": (-12, 5), "expm1": (-6, 3), "log": (0, 60), "log2": (0, 60),
           "log1p": (-1, 20), "sin": (-11, 11), "cos": (-11, 11), "tan": (-1.5, 1.5),
           "atan": (-30, 30), "sinh": (-4, 4), "cosh": (-4, 4), "tanh": (-7, 7)}
FACTORS = ("2", "0.5", "-1", "3", "0.25", "-0.75", "0.1", "1.5")


class FunctionSides:
    """Draws two sides, the first with a function. `range_of` gives an input's range (low, high) by its name."""

    def __init__(self, rng, leaves, range_of):
        self.rng = rng
        self.leaves = leaves
        self.range_of = range_of

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
        """A function of a linear expression that is scaled and moved into a part of the domain."""
        rng, function = self.rng, self.rng.choice(FUNCTIONS)
        first, last = map(Fraction, DOMAINS[function])
        size = (last - first) * rng.choice((1, 1, Fraction(1, 2), Fraction(1, 8), Fraction(1, 64)))
        low = first + (last - first - size) * Fraction(rng.randint(0, 64), 64)
        if rng.random() < 0.3:
            low = rng.choice((first, last - size))
        if function in LEAST:  # at the end there is no value: a lane's argument has a limit there
            low += rng.choice((0, Fraction(1, 1024), Fraction(1, 64), Fraction(1, 4), 1))
        tree = self.linear()
        least, most = self.bounds(tree)
        if low <= least and most <= low + size and rng.random() < 0.6:
            return (function, tree)
        scale = Fraction(2) ** math.floor(math.log2(size / (most - least))) if most > least else 1
        if scale != 1:
            tree = ("*", tree, ("constant", dyadic_text(scale)))
        moved = Fraction(math.ceil((low - least * scale) * 4096), 4096)
        return (function, ("+", tree, ("constant", dyadic_text(moved))) if moved else tree)

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
