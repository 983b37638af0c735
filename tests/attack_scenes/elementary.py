"""Functions of rationals, enclosed: exponentials and logarithms by decimal arithmetic, whose exp and
ln are correctly rounded, angles by series.
"""

import decimal
import math
from fractions import Fraction

FUNCTIONS = ("exp", "exp2", "expm1", "log", "log2", "log1p", "sin", "cos", "tan", "atan", "sinh",
             "cosh", "tanh")
LEAST = {"log": 0, "log2": 0, "log1p": -1}  # arguments must be above
MOST = 1 << 12  # magnitude of an argument that is enclosed
DOUBLINGS = 20  # of an angle


class Undefined(Exception):
    """There is no value: an operand is no number, a divisor zero, an argument outside."""


class Undetermined(Exception):
    """More bits are needed to tell."""


def enclosed(function, low, high, bits):
    """An enclosure (low, high) of a function's values from low to high."""
    if function in LEAST and high <= LEAST[function]:
        raise Undefined
    if (function in LEAST and low <= LEAST[function]) or max(abs(low), abs(high)) > MOST:
        raise Undetermined
    if function == "tan":
        (s, t), (c, d) = (enclosed(name, low, high, bits) for name in ("sin", "cos"))
        if c <= 0 <= d:
            raise Undetermined
        quotients = [a / b for a in (s, t) for b in (c, d)]
        return min(quotients), max(quotients)
    if function in ("sin", "cos"):
        least, most = at(function, (low + high) / 2, bits)
        return least - (high - low) / 2, most + (high - low) / 2  # the slope is at most 1
    if function == "cosh" and low < 0:
        low, high = (Fraction(0) if high > 0 else -high), max(-low, high)
    return at(function, low, bits)[0], at(function, high, bits)[1]


def at(function, x, bits):
    """An enclosure of a function's value at a fraction; both ends are equal where it is rational."""
    value = rational(function, x)
    if value is not None:
        return value, value
    if function in ("sin", "cos"):
        value, error = _angle(function, x, bits), Fraction(1, 1 << bits)
    else:
        digits = bits * 31 // 100 + 40
        value = decimal_value(function, x, digits)
        error = (abs(value) + 1) / 10 ** (digits - 20)  # a few roundings, at arguments up to MOST
    return value - error, value + error


def rational(function, x):
    """The value at a fraction if it is rational, as few are (theorems of Lindemann and Gelfond)."""
    if function in ("log", "log2"):
        top, bottom = x.as_integer_ratio()
        is_power = top & (top - 1) == bottom & (bottom - 1) == 0
        if x == 1 or (function == "log2" and is_power):
            return Fraction(top.bit_length() - bottom.bit_length())
        return None
    if x == 0:
        return Fraction(function in ("exp", "exp2", "cos", "cosh"))
    return Fraction(2) ** x.numerator if function == "exp2" and x.denominator == 1 else None


def _angle(function, x, bits):
    """The sine or cosine in units of 2^-(bits + 160). Each doubling of the angle takes two bits."""
    places = bits + 160
    one = 1 << places
    angle = math.floor(x * one) >> DOUBLINGS
    sine, cosine, term, k = 0, 0, one, 0
    while term not in (0, -1):
        sign = -1 if k % 4 > 1 else 1
        sine, cosine = (sine + sign * term, cosine) if k % 2 else (sine, cosine + sign * term)
        k += 1
        term = (term * angle >> places) // k
    for _ in range(DOUBLINGS):
        sine, cosine = 2 * sine * cosine >> places, (2 * cosine * cosine >> places) - one
    return Fraction(sine if function == "sin" else cosine, one)


def decimal_value(function, x, digits, power=1):
    context = decimal.Context(prec=digits, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN)
    with decimal.localcontext(context):
        d = decimal.Decimal
        a, one, two = d(x.numerator) / d(x.denominator), d(1), d(2)
        if function == "atan":
            value = _arctangent(a)
        elif function == "power":
            value = ((d(x.numerator) / d(x.denominator)).ln() * power.numerator
                     / power.denominator).exp()
        elif function == "exp2":
            value = (a * two.ln()).exp()
        elif function in ("log", "log2", "log1p"):
            x = x + 1 if function == "log1p" else x
            value = (d(x.numerator) / d(x.denominator)).ln()
            value = value / two.ln() if function == "log2" else value
        else:
            up, down = a.exp(), (-a).exp()
            value = {"exp": up, "expm1": up - one, "sinh": (up - down) / two,
                     "cosh": (up + down) / two}.get(function)
            if function == "tanh":
                value = one - two / (up * up + one)
        return Fraction(value)


def _arctangent(a):
    """The series, of an argument that is halved eight times."""
    for _ in range(8):
        a = a / (1 + (1 + a * a).sqrt())
    value, term, k = a, a, 1
    while abs(term) > decimal.Decimal(10) ** -decimal.getcontext().prec:
        term, k = -term * a * a, k + 2
        value += term / k
    return value * 256


def nearly(function, a):
    """A function in doubles."""
    return 2.0 ** a if function == "exp2" else getattr(math, function)(a)
