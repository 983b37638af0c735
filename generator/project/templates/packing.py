@HEAD@
"""@MODULE@: numbers to the bytes of its streams and back, for NumPy.

@EXAMPLE@

Floating point: numbers become doubles, and these are rounded to nearest, ties to even; overflow gives
infinity. Fixed point: the format must hold the number. Unpacked numbers are integers where the format
has no digits behind the point, otherwise doubles, which round formats of more than 53 bits.
@IF NO_INFINITIES@

E4M3 has no infinities: they, and numbers that round to more than 448, become its NaN.
@END@
"""

import numpy as np

ROWS_AT_A_TIME = 1 << 14  # bounds the memory: a byte for each bit of a row

# Each table lists the operands of a record, the lowest first: name, then ("float", digits, exponent
# bits, whether it lacks infinities) or ("fixed", bits, signed, bits behind the point).
@TABLES@


@FUNCTIONS@


def _pack(record, values):
    columns = [_column(values[name]) for name, _ in record]
    rows = len(columns[0])
    for (name, _), column in zip(record, columns):
        if column.shape != (rows,):
            raise ValueError(f"{name}: received an array of shape {column.shape}; expected ({rows},)")
    parts = [np.empty((0, _bytes_of(record)), np.uint8)]
    for first in range(0, rows, ROWS_AT_A_TIME):
        bits = [_bits_of(operand, column[first:first + ROWS_AT_A_TIME], first)
                for operand, column in zip(record, columns)]
        parts.append(np.packbits(np.concatenate(bits, axis=1), axis=1, bitorder="little"))
    return np.concatenate(parts)


def _unpack(record, tdata):
    if isinstance(tdata, (bytes, bytearray, memoryview)):
        tdata = np.frombuffer(tdata, np.uint8)
    tdata = np.asarray(tdata)
    if tdata.dtype != np.uint8:
        raise ValueError(f"tdata: received an array of {tdata.dtype}; expected uint8")
    tdata = tdata.reshape(-1, _bytes_of(record))
    parts = {name: [] for name, _ in record}
    for first in range(0, max(len(tdata), 1), ROWS_AT_A_TIME):
        bits = np.unpackbits(tdata[first:first + ROWS_AT_A_TIME], axis=1, bitorder="little")
        at = 0
        for name, form in record:
            width = _width_of(form)
            value_of = _float_of if form[0] == "float" else _fixed_of
            parts[name].append(value_of(bits[:, at:at + width], *form[1:]))
            at += width
    return {name: np.concatenate(part) for name, part in parts.items()}


def _column(values):
    """An array. Integers that NumPy would make doubles of, as in [1, 2**63], stay integers."""
    column = np.atleast_1d(np.asarray(values))
    if column.dtype.kind == "f" and not hasattr(values, "dtype"):
        objects = np.atleast_1d(np.asarray(values, dtype=object))
        if all(isinstance(value, (int, np.integer)) for value in objects.flat):
            return objects
    return column


def _width_of(form):
    return form[1] + form[2] if form[0] == "float" else form[1]


def _bytes_of(record):
    return (sum(_width_of(form) for _, form in record) + 7) // 8


def _bits_of(operand, values, first_row):
    name, form = operand
    if form[0] == "float":
        return _float_bits(np.asarray(values, np.float64), *form[1:])
    try:
        return _fixed_bits(values, *form[1:])
    except _NotHeld as wrong:
        raise ValueError(f"{name}, row {first_row + wrong.row}: received {_plain(values[wrong.row])!r}; "
                         f"expected {_accepted(*form[1:])}") from None


def _plain(value):
    return value.item() if hasattr(value, "item") else value


class _NotHeld(ValueError):
    """The first row with a number that its format lacks."""

    def __init__(self, held):
        super().__init__()
        self.row = int(np.argmin(held))


def _accepted(bits, is_signed, fraction_bits):
    least, most = _range_of(bits, is_signed)
    if fraction_bits == 0:
        return f"an integer from {least} to {most}"
    limit = most + 1 >> fraction_bits
    return f"a multiple of 2^-{fraction_bits} from {-limit if is_signed else 0} to less than {limit}"


def _range_of(bits, is_signed):
    most = (1 << (bits - is_signed)) - 1
    return (-most - 1 if is_signed else 0), most


def _word_bits(words, count):
    """The low bits of words, lowest first: a row of them for each word."""
    octets = np.ascontiguousarray(words.astype("<u8"))[:, None].view(np.uint8)
    return np.unpackbits(octets, axis=1, count=count, bitorder="little")


def _words_of(bits):
    octets = np.zeros((len(bits), 8), np.uint8)
    packed = np.packbits(bits, axis=1, bitorder="little")
    octets[:, :packed.shape[1]] = packed
    return octets.view("<u8")[:, 0].astype(np.uint64)


def _fixed_bits(values, bits, is_signed, fraction_bits):
    least, most = _range_of(bits, is_signed)
    if values.dtype.kind == "O" or (values.dtype.kind in "iub" and fraction_bits > 0):
        integers = [int(value) << fraction_bits for value in values]
        held = np.array([least <= value <= most for value in integers], bool)
        steps = np.array([value if one else 0 for value, one in zip(integers, held)],
                         np.int64 if is_signed else np.uint64)
    elif values.dtype.kind in "iub":
        steps = values.astype(np.uint64 if values.dtype.kind == "u" else np.int64)
        info = np.iinfo(steps.dtype)
        held = (steps >= max(least, info.min)) & (steps <= min(most, info.max))
    else:
        with np.errstate(over="ignore", invalid="ignore"):
            steps = np.ldexp(np.asarray(values, np.float64), fraction_bits)
            held = (steps == np.rint(steps)) & (steps >= least) & (steps < most + 1)
    if not held.all():
        raise _NotHeld(held)
    return _word_bits(steps.astype(np.int64 if is_signed else np.uint64).view(np.uint64), bits)


def _fixed_of(bits, count, is_signed, fraction_bits):
    words = _words_of(bits)
    if is_signed:
        unused = np.uint64(64 - count)
        words = (words << unused).view(np.int64) >> np.int64(64 - count)
    return words if fraction_bits == 0 else np.ldexp(words.astype(np.float64), -fraction_bits)


def _float_bits(values, digits, exponent_bits, has_infinities):
    """As IEEE 754 packs: the fraction lowest, then the exponent, then the sign. Without infinities
    the NaN is all ones below the sign, and stands for all that the format lacks."""
    largest = (1 << exponent_bits) - 1  # of the exponent's field
    least = 1 - largest // 2            # exponent of the least normal number
    is_finite = np.isfinite(values)
    magnitudes = np.where(is_finite, np.abs(values), 0)
    _, exponents = np.frexp(magnitudes)
    places = np.where(magnitudes > 0, np.maximum(exponents - 1, least), least).astype(np.intc)
    steps = np.rint(np.ldexp(magnitudes, digits - 1 - places))
    leading = np.floor(np.ldexp(steps, 1 - digits))
    fractions = steps - np.ldexp(leading, digits - 1)
    fields = places - least + leading
    if has_infinities:
        nan_fraction = 2.0 ** (digits - 2)
        is_nan = np.isnan(values)
        is_over = ~is_finite | (fields >= largest)
    else:
        nan_fraction = 2.0 ** (digits - 1) - 1
        is_last = (fields == largest) & (fractions == nan_fraction)
        is_nan = is_over = ~is_finite | (fields > largest) | is_last
    fields = np.where(is_over, largest, fields)
    fractions = np.where(is_over, np.where(is_nan, nan_fraction, 0), fractions)
    high = np.floor(np.ldexp(fractions, -64))
    low = fractions - np.ldexp(high, 64)
    return np.concatenate([_word_bits(low, min(digits - 1, 64)),
                           _word_bits(high, max(digits - 65, 0)),
                           _word_bits(fields, exponent_bits),
                           (np.signbit(values) & ~is_nan)[:, None].astype(np.uint8)], axis=1)


def _float_of(bits, digits, exponent_bits, has_infinities):
    """The nearest double. Below 2^-1022 it is rounded twice and may be off by one place."""
    largest = (1 << exponent_bits) - 1
    fractions = bits[:, :digits - 1]
    fields = _words_of(bits[:, digits - 1:-1]).astype(np.int64)
    leading = (fields > 0)[:, None].astype(np.uint8)
    words, dropped = _leading_64(np.concatenate([fractions, leading], axis=1))
    exponents = np.maximum(fields, 1) - largest // 2 - (digits - 1) + dropped
    with np.errstate(over="ignore", under="ignore"):
        values = np.ldexp(words.astype(np.float64), exponents.astype(np.intc))
    special = np.where(fractions.any(axis=1), np.nan, np.inf)
    is_special = (fields == largest) & (fractions.all(axis=1) | has_infinities)
    values = np.where(is_special, special, values)
    return np.where(bits[:, -1] > 0, -values, values)


def _leading_64(bits):
    """The words of the leading 64 bits, and how many bits of each row are below. The last bit of a word
    keeps whether these are zeros."""
    width = bits.shape[1]
    if width <= 64:
        return _words_of(bits), 0
    length = width - np.argmax(bits[:, ::-1], axis=1)
    dropped = np.maximum(length - 64, 0)[:, None]
    words = _words_of(np.take_along_axis(bits, dropped + np.arange(64), axis=1))
    is_below = (bits > 0) & (np.arange(width) < dropped)
    return words | is_below.any(axis=1).astype(np.uint64), dropped[:, 0]
