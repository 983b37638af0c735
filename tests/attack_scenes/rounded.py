"""Computes as a reference does: floating point, each operation correctly rounded, on rationals.

A number is a pair (negative, magnitude) with a Fraction or INFINITE as magnitude, or NAN. The rules
are those of docs/scene_file.md (formats, subnormals, sums) and docs/error_bounds.md (theorem 12).
"""

import dataclasses
import math
from fractions import Fraction

from .trees import IRRATIONAL, is_power_of_two, literal, nearly

INFINITE = "infinite"
NAN = None
TWO = Fraction(2)


def exponent_of(magnitude):
    """The exponent e of a positive fraction: 2^e <= magnitude < 2^(e+1)."""
    top, bottom = magnitude.as_integer_ratio()
    guess = top.bit_length() - bottom.bit_length()
    return guess if TWO ** guess <= magnitude else guess - 1


def value_of(number):
    """The number, which is finite, as a Fraction."""
    return -number[1] if number[0] else number[1]


def is_finite(number):
    return number is not NAN and number[1] is not INFINITE


@dataclasses.dataclass(frozen=True)
class Format:
    precision: int
    exponent_bits: int
    flush: bool = False
    has_infinities: bool = True  # False: as E4M3, whose NaN stands for all beyond its largest

    @property
    def name(self):
        return (f"s{self.precision}e{self.exponent_bits}" if self.has_infinities
                else f"E{self.exponent_bits}M{self.precision - 1}")

    @property
    def least_exponent(self):
        return 2 - 2 ** (self.exponent_bits - 1)

    @property
    def largest(self):
        if not self.has_infinities:
            return (2 - TWO ** (2 - self.precision)) * TWO ** (2 ** (self.exponent_bits - 1))
        return (2 - TWO ** (1 - self.precision)) * TWO ** (2 ** (self.exponent_bits - 1) - 1)

    def last_place(self, magnitude):
        """The value of the last digit of a number of this magnitude."""
        exponent = self.least_exponent if magnitude == 0 else exponent_of(magnitude)
        return TWO ** (max(exponent, self.least_exponent) - self.precision + 1)

    def rounded(self, negative, magnitude):
        """To nearest, ties to even."""
        if magnitude == 0:
            return negative, magnitude
        if self.flush:
            place = TWO ** (exponent_of(magnitude) - self.precision + 1)
        else:
            place = self.last_place(magnitude)
        nearest = round(magnitude / place) * place  # Fractions round ties to even
        if nearest > self.largest:
            return self.infinity(negative)
        if self.flush and nearest < TWO ** self.least_exponent:
            return negative, Fraction(0)
        return negative, nearest

    def infinity(self, negative):
        return (negative, INFINITE) if self.has_infinities else NAN

    def read(self, number):
        """An operand as an operation takes it."""
        if self.flush and is_finite(number) and number[1] < TWO ** self.least_exponent:
            return number[0], Fraction(0)
        return number

    def gradual(self):
        return dataclasses.replace(self, flush=False)


def number(written, form):
    """An operand of a data file, rounded to the format in which it arrives."""
    word = written.strip().lstrip("+-").lower()
    negative = written.strip().startswith("-")
    if word == "nan":
        return NAN
    if word == "inf":
        return form.infinity(negative)
    return form.gradual().rounded(negative, abs(literal(word)))


def negated(a):
    return NAN if a is NAN else (not a[0], a[1])


def add(form, a, b):
    if a is NAN or b is NAN:
        return NAN
    if a[1] is INFINITE or b[1] is INFINITE:
        if a[1] is INFINITE and b[1] is INFINITE and a[0] != b[0]:
            return NAN
        return a if a[1] is INFINITE else b
    total = value_of(a) + value_of(b)
    if total == 0:
        return a[0] and b[0], Fraction(0)
    return form.rounded(total < 0, abs(total))


def multiply(form, a, b):
    if a is NAN or b is NAN:
        return NAN
    negative = a[0] != b[0]
    if a[1] is INFINITE or b[1] is INFINITE:
        return NAN if a[1] == 0 or b[1] == 0 else (negative, INFINITE)
    return form.rounded(negative, a[1] * b[1])


def divide(form, a, b):
    if a is NAN or b is NAN:
        return NAN
    negative = a[0] != b[0]
    if a[1] is INFINITE:
        return NAN if b[1] is INFINITE else (negative, INFINITE)
    if b[1] is INFINITE:
        return negative, Fraction(0)
    if b[1] == 0:
        return NAN if a[1] == 0 else (negative, INFINITE)
    return form.rounded(negative, a[1] / b[1])


def square_root(form, a):
    if a is NAN or a[1] == 0:
        return a
    if a[0]:
        return NAN
    if a[1] is INFINITE:
        return a
    # The root in eighths of its last place. The last bit is set if the root has further digits.
    place = TWO ** (exponent_of(a[1]) // 2 - form.precision + 1)
    scaled = a[1] / place ** 2 * 16
    quarters = math.isqrt(math.floor(scaled))
    eighths = 2 * quarters + (quarters ** 2 != scaled)
    return form.rounded(False, Fraction(eighths, 8) * place)


def function_near(form, node, operands):
    """A function's value by doubles: only rows are drawn by it, since no format in floating point
    computes functions."""
    try:
        value = Fraction(nearly(node, *(float(value_of(operand)) for operand in operands)))
    except (ArithmeticError, TypeError, ValueError):  # no numbers, or no finite value
        return NAN
    return form.rounded(value < 0, abs(value))


def choice(a, b, larger):
    """IEEE 754-2019 minimum and maximum."""
    if a is NAN or b is NAN:
        return NAN
    a_is_less = order_key(a) < order_key(b)
    return b if a_is_less == larger else a


def order_key(number):
    """Numbers are in the order of their keys; -0 is below +0."""
    negative, magnitude = number
    key = (1, 0) if magnitude is INFINITE else (0, magnitude)
    return (-key[0], -key[1], -1) if negative else (*key, 1)


def compare(a, b):
    if a is NAN or b is NAN:
        return "unordered"
    if a[1] == 0 and b[1] == 0:
        return "equal"
    keys = order_key(a), order_key(b)
    return "less" if keys[0] < keys[1] else "greater" if keys[0] > keys[1] else "equal"


def cut_sum(form, terms):
    """The sum of terms (negated, a, b), each cut as theorem 12 says; it is not rounded."""
    products, exponents = [], [] if form.flush else [form.least_exponent]
    for is_negated, a, b in terms:
        product = exact_product(a, b)
        if product is NAN:
            return NAN
        products.append(negated(product) if is_negated else product)
        if is_finite(product) and product[1] != 0:
            exponents.append(exponent_of(a[1]) + exponent_of(b[1]))
    signs = {product[0] for product in products if product[1] is INFINITE}
    if signs:
        return NAN if len(signs) == 2 else (signs.pop(), INFINITE)
    guard = 5 + (len(terms) - 1).bit_length()
    place = TWO ** (max(exponents, default=0) - form.precision - guard)
    total = sum(math.trunc(value_of(product) / place) for product in products) * place
    negative = total < 0 if total else all(product[0] for product in products)
    return negative, abs(total)


def exact_product(a, b):
    if a is NAN or b is NAN:
        return NAN
    if INFINITE in (a[1], b[1]):
        return NAN if 0 in (a[1], b[1]) else (a[0] != b[0], INFINITE)
    return a[0] != b[0], a[1] * b[1]


def apply(form, operation, operands):
    operands = [form.read(operand) for operand in operands]
    if operation == "neg":
        return negated(operands[0])
    if operation == "abs":
        return NAN if operands[0] is NAN else (False, operands[0][1])
    if operation == "sqrt":
        return square_root(form, operands[0])
    a, b = operands
    if operation == "+":
        return add(form, a, b)
    if operation == "-":
        return add(form, a, negated(b))
    if operation == "*":
        return multiply(form, a, b)
    if operation == "/":
        return divide(form, a, b)
    return choice(a, b, operation == "max")


class Reference:
    """Computes a graph's parts in a format; with `fused` as `reference.sums = "fused"` says."""

    ONE = (False, Fraction(1))
    MOST_TERMS = 63

    def __init__(self, graph, form, fused):
        self.graph = graph
        self.form = form
        self.fused = [self._sum_terms(node) if fused else [] for node in range(len(graph.nodes))]
        self.differences = [self._difference(part) if fused else [] for part in graph.parts]

    def verdicts(self, inputs):
        """The verdict of each part; `inputs` has a number for each name."""
        values = {}
        verdicts = []
        for (f, g), difference in zip(self.graph.parts, self.differences):
            if difference:
                total = cut_sum(self.form, self._numbers(difference, inputs, values))
                verdicts.append(compare(total, (False, Fraction(0))))
            else:
                sides = [self.form.read(self._value(side, inputs, values)) for side in (f, g)]
                verdicts.append(compare(*sides))
        return verdicts

    def _value(self, index, inputs, values):
        if index not in values:
            values[index] = self._computed(index, inputs, values)
        return values[index]

    def _computed(self, index, inputs, values):
        node = self.graph.nodes[index]
        if node.operation == "input":
            return inputs[node.value]
        if node.operation == "constant":
            return self.form.gradual().rounded(node.value < 0, abs(node.value))
        if self.fused[index]:
            total = cut_sum(self.form, self._numbers(self.fused[index], inputs, values))
            return self.form.rounded(*total) if is_finite(total) else total
        operands = [self._value(operand, inputs, values) for operand in node.operands]
        if node.operation in IRRATIONAL and node.operation != "sqrt":
            return function_near(self.form, node, operands)
        return apply(self.form, node.operation, operands)

    def _numbers(self, terms, inputs, values):
        def read(node):
            return self.form.read(self._value(node, inputs, values))

        return [(is_negated, read(a), self.ONE if b is None else read(b))
                for is_negated, a, b in terms]

    def _terms(self, index, is_negated=False):
        """The terms (negated, a, b or None) that a node adds up, sums in it included."""
        node = self.graph.nodes[index]
        if node.operation in ("+", "-"):
            first, second = node.operands
            return (self._terms(first, is_negated)
                    + self._terms(second, is_negated != (node.operation == "-")))
        if node.operation == "neg":
            return self._terms(node.operands[0], not is_negated)
        if node.operation == "*":
            return [(is_negated, *node.operands)]
        return [(is_negated, index, None)]

    def _rounds(self, term):
        """Whether a term is a product that is not exact anyway, as one by a power of two is."""
        _, a, b = term
        if b is None:
            return False
        constants = [abs(self.graph.nodes[factor].value) for factor in (a, b)
                     if self.graph.nodes[factor].operation == "constant"]
        return not any(map(is_power_of_two, constants))

    def _sum_terms(self, index):
        """The terms of a node that is a fused sum; empty for other nodes."""
        if self.graph.nodes[index].operation not in ("+", "-"):
            return []
        terms = self._terms(index)
        return terms if len(terms) > 2 or any(map(self._rounds, terms)) else []

    def _side_terms(self, side):
        """The terms of a side that is not rounded: a sum or product without other readers."""
        if self.graph.readers(side) > 1:
            return []
        node = self.graph.nodes[side]
        if node.operation == "neg":
            return [(not is_negated, a, b)
                    for is_negated, a, b in self._side_terms(node.operands[0])]
        terms = self._sum_terms(side) or self._terms(side)
        is_sum = bool(self._sum_terms(side))
        return terms if is_sum or (len(terms) == 1 and self._rounds(terms[0])) else []

    def _difference(self, part):
        f, g = (self._side_terms(side) for side in part)
        if not f and not g:
            return []
        f = f or [(False, part[0], None)]
        g = g or [(False, part[1], None)]
        terms = f + [(not is_negated, a, b) for is_negated, a, b in g]
        return terms if len(terms) <= self.MOST_TERMS else []
