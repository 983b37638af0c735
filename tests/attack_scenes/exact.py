"""The order of the real numbers f and g: by rationals, irrational numbers by enclosures."""

import math
from fractions import Fraction

from . import further
from .elementary import FUNCTIONS, Undefined, Undetermined, enclosed
from .further import PARAMETRIC
from .rounded import exponent_of, is_finite, value_of

PRECISIONS = (300, 2000, 8000)  # bits of an enclosure, tried in turn


def verdict(graph, part, inputs):
    """less, equal or greater; unordered if a side has no value; None if it is undetermined."""
    for bits in PRECISIONS:
        try:
            return _order(*(_value(graph, side, inputs, bits, {}) for side in part))
        except Undefined:
            return "unordered"
        except Undetermined:
            continue
    return None


def difference_within(graph, part, inputs, error):
    """Whether |f - g| is at most `error`; None if that is undetermined."""
    try:
        f, g = (_value(graph, side, inputs, PRECISIONS[0], {}) for side in part)
    except (Undefined, Undetermined):
        return None
    if f[0] - g[1] > error or g[0] - f[1] > error:
        return False
    return True if f[1] - g[0] <= error and g[1] - f[0] <= error else None


def _order(f, g):
    if f[1] < g[0]:
        return "less"
    if f[0] > g[1]:
        return "greater"
    if f[0] == f[1] == g[0] == g[1]:
        return "equal"
    raise Undetermined


def _value(graph, index, inputs, bits, values):
    """An enclosure (low, high) of a node's value, both ends equal where it is exact."""
    if index not in values:
        node = graph.nodes[index]
        if node.operation == "input":
            number = inputs[node.value]
            if not is_finite(number):
                raise Undefined
            values[index] = (value_of(number),) * 2
        elif node.operation == "constant":
            values[index] = (node.value,) * 2
        else:
            # All operands are computed, as any of them may have no value.
            operands = [_value(graph, operand, inputs, bits, values) for operand in node.operands]
            if node.operation == "*" and len(set(node.operands)) == 1:
                operands = [_applied("abs", None, operands[:1], bits)] * 2
            apply = further.applied if node.operation in PARAMETRIC else _applied
            values[index] = _widened(apply(node.operation, node.value, operands, bits), bits)
    return values[index]


def _widened(ends, bits):
    """Ends of an inexact enclosure, rounded outward to `bits` bits."""
    low, high = ends
    if low == high:
        return ends
    return _rounded(low, bits, math.floor), _rounded(high, bits, math.ceil)


def _rounded(value, bits, direction):
    if value == 0:
        return value
    place = Fraction(2) ** (exponent_of(abs(value)) - bits)
    return direction(value / place) * place


def _applied(operation, _, operands, bits):
    low, high = operands[0]
    if operation == "neg":
        return -high, -low
    if operation == "abs":
        least, most = sorted((abs(low), abs(high)))
        return (Fraction(0) if low < 0 < high else least), most
    if operation == "sqrt":
        return _roots(low, high, bits)
    if operation in FUNCTIONS:
        return enclosed(operation, low, high, bits)
    second = operands[1]
    if operation == "+":
        return low + second[0], high + second[1]
    if operation == "-":
        return low - second[1], high - second[0]
    if operation == "min":
        return min(low, second[0]), min(high, second[1])
    if operation == "max":
        return max(low, second[0]), max(high, second[1])
    if operation == "/":
        if second == (0, 0):
            raise Undefined
        if second[0] <= 0 <= second[1]:
            raise Undetermined
        second = (1 / second[1], 1 / second[0])
    products = [a * b for a in (low, high) for b in second]
    return min(products), max(products)


def _roots(low, high, bits):
    if high < 0:
        raise Undefined
    if low < 0:
        raise Undetermined
    return _root(low, bits)[0], _root(high, bits)[1]


def _root(value, bits):
    """An enclosure of a root, which is exact if the root is rational."""
    top, bottom = (math.isqrt(part) for part in value.as_integer_ratio())
    if (top ** 2, bottom ** 2) == value.as_integer_ratio():
        return (Fraction(top, bottom),) * 2
    place = Fraction(2) ** (exponent_of(value) // 2 - bits)
    low = math.isqrt(math.floor(value / place ** 2))
    return low * place, (low + 1) * place
