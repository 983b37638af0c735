"""Functions with parameters, enclosed: powers, jumps, angles of directions, tables of points.

A parameter is the exponent of "power", the divisor of "mod", (points, degree) of "table".
"""

import bisect
import math
from fractions import Fraction

from .elementary import MOST, Undefined, Undetermined, at, decimal_value

PARAMETRIC = ("power", "sign", "mod", "atan2", "table")


def applied(operation, parameter, operands, bits):
    """An enclosure of the values; `operands` are enclosures (low, high)."""
    low, high = operands[0]
    if operation == "sign":
        if low < 0 <= high:
            raise Undetermined
        return (Fraction(1 if low >= 0 else -1),) * 2
    if operation == "mod":
        k = math.floor(low / parameter)
        if math.floor(high / parameter) != k:
            raise Undetermined
        return low - k * parameter, high - k * parameter
    if operation == "power":
        return _powers(parameter, low, high, bits)
    if any(first != last for first, last in operands):
        raise Undetermined
    if operation == "table":
        return (interpolated(*parameter, low),) * 2
    return _direction(low, operands[1][0], bits)


def points_of(written):
    """The points (x, y) of a table that is written "x,y;x,y;..."; files hold binary64."""
    return tuple(tuple(Fraction(float(word)) for word in point.split(","))
                 for point in written.split(";"))


def interpolated(points, degree, x):
    """Lagrange's polynomial through the points around x."""
    places = [point[0] for point in points]
    if not places[0] <= x <= places[-1]:
        raise Undefined
    left = max(bisect.bisect_right(places, x) - 1, 0)
    first = min(max(left - (degree - 1) // 2, 0), len(points) - 1 - degree)
    near, total = points[first:first + degree + 1], Fraction(0)
    for place, value in near:
        for other, _ in near:
            value *= (x - other) / (place - other) if other != place else 1
        total += value
    return total


def _powers(power, low, high, bits):
    is_whole = power.denominator == 1
    if power < 0 and low <= 0 <= high:
        raise Undefined if low == high else Undetermined
    if not is_whole and low < 0:
        raise Undefined if high < 0 else Undetermined
    ends = [_power(power, end, bits) for end in (low, high)]
    least, most = min(first for first, _ in ends), max(last for _, last in ends)
    is_valley = low < 0 < high and power.numerator % 2 == 0
    return (Fraction(0) if is_valley else least), most


def _power(power, x, bits):
    top, bottom = power.as_integer_ratio()
    if x == 0:
        return Fraction(0), Fraction(0)
    roots = [_whole_root(part, bottom) for part in x.as_integer_ratio()]
    if all(root ** bottom == part for root, part in zip(roots, x.as_integer_ratio())):
        value = Fraction(*roots) ** top
        return value, value
    exponent = abs(float(power) * math.log(x)) if x < 1 << 1000 else MOST
    if exponent > MOST:
        raise Undetermined
    digits = bits * 31 // 100 + 40
    value = decimal_value("power", x, digits, power)
    error = value * MOST / 10 ** (digits - 20)
    return value - error, value + error


def _whole_root(number, degree):
    """The whole part of a root of an integer, whose sign it keeps if the degree is 1."""
    if degree == 1:
        return number
    low, high = 0, 1 << number.bit_length() // degree + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle ** degree <= number else (low, middle)
    return low


def _direction(y, x, bits):
    """The angle of (x, y), above -pi and at most pi."""
    if y == 0 and x >= 0:
        if x == 0:
            raise Undefined
        return Fraction(0), Fraction(0)
    eighth = at("atan", Fraction(1), bits)
    turns = (4 if y >= 0 else -4) if abs(x) >= abs(y) and x < 0 else 0  # in eighths
    if abs(x) >= abs(y):
        angle = at("atan", y / x, bits)
    else:
        turns, angle = (2 if y > 0 else -2), [-end for end in at("atan", x / y, bits)[::-1]]
    ends = [turns * end for end in eighth]
    return min(ends) + angle[0], max(ends) + angle[1]


def nearly(operation, parameter, x, other=0.0):
    """The value in doubles."""
    if operation == "atan2":
        return math.atan2(x, other)
    if operation == "sign":
        return 1.0 if x >= 0 else -1.0
    if operation == "mod":
        return x % float(parameter)
    if operation == "power":
        return math.pow(x, parameter)
    try:
        return float(interpolated(*parameter, Fraction(x)))
    except Undefined as outside:
        raise ValueError from outside
