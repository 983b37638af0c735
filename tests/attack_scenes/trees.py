"""Expressions as trees: their text in a scene, and the graph that they stand for.

A tree is a tuple: an operation and its operands.

    ("input", "a") ("element", "p", tree) ("constant", "0x1.8p-3") ("let", "d") ("index", "k")
    ("neg", x) ("abs", x) ("sqrt", x) ("exp", x) ("^", x, 3) ("+", x, y)
    ("-", x, y) ("*", x, y) ("/", x, y)
    ("min", x, y, ...) ("max", ...) ("sum", ...) ("product", ...) ("within", x, "-4", "4")
    ("over", "sum", "k", 0, 2, x) ("power", x, "-1/3") ("sign", x) ("mod", x, "360") ("atan2", y, x)
    ("table", x, "0,1;0.5,2;1,0", 1), whose points stand in a file beside the scene

Graphs follow docs/scene_file.md, "Expressions": constants are folded exactly, equal subexpressions
are one node, powers are squares and products, reductions are joined pairwise.
"""

import dataclasses
import math
import zlib
from fractions import Fraction

from . import elementary, further
from .elementary import FUNCTIONS

LEVELS = {"+": 1, "-": 1, "*": 2, "/": 2, "neg": 3, "^": 4, "power": 4}
REDUCED_BY = {"sum": "+", "product": "*", "min": "min", "max": "max"}
IRRATIONAL = ("sqrt", *FUNCTIONS, *further.PARAMETRIC)  # constants are not folded
COMMUTATIVE = ("+", "*", "min", "max")


def literal(text):
    """The value of a literal of the scene file: decimal or hex-float, with a sign or without."""
    sign, digits = (-1, text[1:]) if text.startswith("-") else (1, text)
    if not digits.lower().startswith("0x"):
        return sign * Fraction(digits)
    number, _, exponent = digits[2:].lower().partition("p")
    whole, _, fraction = number.partition(".")
    scale = int(exponent or 0) - 4 * len(fraction)
    return sign * int(whole + fraction, 16) * Fraction(2) ** scale


def dyadic_text(value):
    """A hex-float that names a fraction whose denominator is a power of two."""
    sign = "-" if value < 0 else ""
    places = value.denominator.bit_length() - 1
    number = abs(value.numerator)
    zeros = (number & -number).bit_length() - 1 if number else 0
    return f"{sign}0x{number >> zeros:x}p{zeros - places}"


def text(tree, least=0):
    """The tree as a scene writes it, in parentheses if its operator binds less than `least`."""
    operation, *operands = tree
    level = LEVELS.get(operation, 5)
    if operation in ("input", "let", "index", "constant"):
        written = operands[0]
        level = 3 if written.startswith("-") else 5
    elif operation == "element":
        written = f"{operands[0]}[{text(operands[1])}]"
    elif operation == "neg":
        written = "-" + text(operands[0], 3)
    elif operation == "^":
        written = f"{text(operands[0], 5)}^{operands[1]}"
    elif operation == "power":
        written = f"{text(operands[0], 5)}^({operands[1]})"
    elif operation == "mod":
        written = f"mod({text(operands[0])}, {operands[1]})"
    elif operation == "table":
        written = f"table('{table_file(tree)}', {text(operands[0])}, {operands[2]})"
    elif operation in LEVELS:
        written = f"{text(operands[0], level)} {operation} {text(operands[1], level + 1)}"
    elif operation == "within":
        written = f"within({text(operands[0])}, {operands[1]}, {operands[2]})"
    elif operation == "over":
        function, index, first, last, term = operands
        written = f"{function}({index} in {first}..{last}, {text(term)})"
    else:
        written = f"{operation}({', '.join(text(operand) for operand in operands)})"
    return f"({written})" if level < least else written


def table_file(tree):
    return f"points{zlib.crc32(tree[2].encode())}.csv"


def parameter_of(tree):
    """What a function takes beside its operands (further.py); None for most operations."""
    operation, *rest = tree
    if operation == "table":
        return further.points_of(rest[1]), rest[2]
    return literal(rest[1]) if operation in ("power", "mod") else None


def children(tree):
    """The places of a tree's operands that are trees."""
    return [k for k, part in enumerate(tree) if isinstance(part, tuple)]


def subtrees(tree):
    """Pairs of a path (places from the root down) and the tree there, the root first."""
    yield (), tree
    for place in children(tree):
        for path, below in subtrees(tree[place]):
            yield (place, *path), below


def replaced(tree, path, new):
    """The tree with `new` at the path."""
    if not path:
        return new
    place, *rest = path
    return (*tree[:place], replaced(tree[place], rest, new), *tree[place + 1:])


def exchanged(tree, old, new):
    """The tree with each subtree that equals `old` replaced."""
    if tree == old:
        return new
    return tuple(exchanged(part, old, new) if isinstance(part, tuple) else part for part in tree)


def size(tree):
    return 1 + sum(size(tree[place]) for place in children(tree))


def reads(tree, operation):
    """Whether an operation (or leaf) of this kind is in the tree."""
    return any(below[0] == operation for _, below in subtrees(tree))


@dataclasses.dataclass(frozen=True)
class Node:
    operation: str  # input, constant, neg, abs, +, -, *, /, min, max, IRRATIONAL
    operands: tuple = ()  # indices of nodes
    value: object = None  # an input's name, a constant's value, a function's parameter


class Graph:
    """The nodes of a comparison's sides. `parts` are pairs of nodes."""

    def __init__(self, lets):
        self.nodes = []
        self.parts = []
        self._known = {}
        self._lets = lets

    def add_part(self, f, g, indices):
        part = tuple(self._node(self._built(side, indices)) for side in (f, g))
        if part not in self.parts:
            self.parts.append(part)

    def inputs(self):
        return [node.value for node in self.nodes if node.operation == "input"]

    def below(self, root):
        """The nodes that a node needs, itself included, as a set."""
        needed = set()
        waiting = [root]
        while waiting:
            node = waiting.pop()
            if node not in needed:
                needed.add(node)
                waiting.extend(self.nodes[node].operands)
        return needed

    def readers(self, node):
        """How often operations and sides read a node."""
        return (sum(other.operands.count(node) for other in self.nodes)
                + sum(part.count(node) for part in self.parts))

    def _intern(self, operation, operands=(), value=None):
        node = Node(operation, operands, value)
        if node not in self._known:
            self._known[node] = len(self.nodes)
            self.nodes.append(node)
        return self._known[node]

    def _node(self, built):
        """The node of a result of _built; a constant gets one when an operation reads it."""
        return built if isinstance(built, int) else self._intern("constant", (), built)

    def _applied(self, operation, *built, parameter=None):
        if all(isinstance(value, Fraction) for value in built) and operation not in IRRATIONAL:
            return fold(operation, *built)
        divisor = built[-1]
        if operation == "/" and isinstance(divisor, Fraction) and is_power_of_two(abs(divisor)):
            return self._applied("*", built[0], 1 / divisor)
        operands = tuple(self._node(value) for value in built)
        if operation in COMMUTATIVE:
            operands = tuple(sorted(operands))
        return self._intern(operation, operands, parameter)

    def _joined(self, operation, values):
        while len(values) > 1:
            pairs = [self._applied(operation, a, b) for a, b in zip(values[::2], values[1::2])]
            values = pairs + values[2 * len(pairs):]
        return values[0]

    def _raised(self, base, power):
        if power == 1:
            return base
        if power % 2:
            return self._applied("*", self._raised(base, power - 1), base)
        root = self._raised(base, power // 2)
        return self._applied("*", root, root)

    def _built(self, tree, indices):
        """The node of a tree, or its value if it is constant (Fraction)."""
        operation, *operands = tree
        if operation == "input":
            return self._intern("input", (), operands[0])
        if operation == "constant":
            return literal(operands[0])
        if operation == "let":
            return self._built(self._lets[operands[0]], {})
        if operation == "index":
            return Fraction(indices[operands[0]])
        if operation == "element":
            return self._intern("input", (), f"{operands[0]}_{self._built(operands[1], indices)}")
        if operation == "^":
            return self._raised(self._built(operands[0], indices), operands[1])
        if operation == "within":
            return self._built(operands[0], indices)
        if operation == "over":
            function, index, first, last, term = operands
            values = [self._built(term, {**indices, index: k}) for k in range(first, last + 1)]
            return self._joined(REDUCED_BY[function], values)
        values = [self._built(tree[place], indices) for place in children(tree)]
        if operation in REDUCED_BY:
            return self._joined(REDUCED_BY[operation], values)
        return self._applied(operation, *values, parameter=parameter_of(tree))


def is_power_of_two(value):
    return value > 0 and all(part & (part - 1) == 0 for part in value.as_integer_ratio())


def fold(operation, a, b=None):
    if operation == "neg":
        return -a
    if operation == "abs":
        return abs(a)
    if operation == "+":
        return a + b
    if operation == "-":
        return a - b
    if operation == "*":
        return a * b
    if operation == "/":
        return a / b
    return min(a, b) if operation == "min" else max(a, b)


def nearly(node, *operands):
    """A node's value in doubles, of operations that are not folded."""
    if node.operation == "sqrt":
        return math.sqrt(*operands)
    if node.operation in FUNCTIONS:
        return elementary.nearly(node.operation, *operands)
    return further.nearly(node.operation, node.value, *operands)
