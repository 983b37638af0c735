"""Operands: small integers, ties and near ties, ends of ranges and formats, infinities, NaNs."""

import dataclasses
from fractions import Fraction
import math

from .rounded import TWO, exponent_of, number
from .trees import IRRATIONAL, dyadic_text, fold, literal, nearly

DECIMALS = ("0.1", "1.3", "-2.7", "0.3333", "1e-3", "-0.7", "3.14159265358979", "5e-7")


class Operands:
    """Draws the texts of operands in a format, each input within its range."""

    def __init__(self, rng, form, ranges, allows_specials):
        self.rng = rng
        self.form = form.gradual()
        self.ranges = ranges  # name -> (low, high) as Fractions
        self.allows_specials = allows_specials
        self.scale = TWO ** rng.choice((0, 0, 0, -3, 2, 5))
        self.styles = {"small": self.small, "few": self.few, "random": self.random,
                       "ends": self.end, "wide": self.wide, "decimal": self.decimal}

    def row(self, names):
        """A row by one style, or by a style for each operand."""
        rng = self.rng
        weights = {"small": 4, "few": 2, "random": 5, "ends": 1, "wide": 1, "decimal": 0.5}
        style, = rng.choices(list(weights), list(weights.values()))
        row = {}
        for name in names:
            own = rng.choice(list(weights)) if rng.random() < 0.15 else style
            row[name] = self.kept(self.styles[own](name), name)
        if self.allows_specials and rng.random() < 0.07:
            row[rng.choice(names)] = rng.choice(("inf", "-inf", "nan"))
        return row

    def kept(self, written, name):
        """The text, or the nearest end of the range if it is outside; at times it stays outside."""
        if name not in self.ranges or (self.allows_specials and self.rng.random() < 0.03):
            return written
        low, high = self.ranges[name]
        value = literal(written)
        return written if low <= value <= high else self.nearest(min(max(value, low), high))

    def nearest(self, value):
        """The text of the number of the format that is nearest to a fraction."""
        negative, magnitude = self.form.rounded(value < 0, min(abs(value), self.form.largest))
        return ("-" if negative else "") + dyadic_text(magnitude)

    def small(self, _):
        return self.nearest(self.rng.randint(-4, 8) * min(self.scale, self.form.largest / 8))

    def few(self, _):
        return self.nearest(self.rng.choice((0, 1, 1, 2, -1)) * self.scale)

    def random(self, name):
        low, high = self.ranges.get(name, (-8 * self.scale, 8 * self.scale))
        part = Fraction(self.rng.getrandbits(130), 1 << 130)
        return self.nearest(low + (high - low) * part)

    def wide(self, name):
        """Any exponent."""
        low, high = self.ranges.get(name, (-self.form.largest, self.form.largest))
        limit = max(abs(low), abs(high), self.form.last_place(0))
        significand = 1 + Fraction(self.rng.getrandbits(60), 1 << 60)
        least = self.form.least_exponent - self.form.precision
        exponent = self.rng.randint(least, max(least, exponent_of(limit)))
        sign = -1 if low < 0 and self.rng.random() < 0.5 else 1
        return self.nearest(sign * significand * TWO ** exponent)

    def end(self, name):
        form, rng = self.form, self.rng
        if name in self.ranges and rng.random() < 0.7:
            value = rng.choice(self.ranges[name])
            return self.beside(name, value, rng.choice((0, 0, 1, -1)))
        tiny, normal = form.last_place(0), TWO ** form.least_exponent
        value = rng.choice((Fraction(0), tiny, 3 * tiny, normal, normal - tiny, normal + tiny,
                            form.largest, TWO ** exponent_of(form.largest), Fraction(1)))
        if value == 0:
            return rng.choice(("0", "-0"))
        return self.nearest(value * rng.choice((1, -1)))

    def decimal(self, _):
        return self.rng.choice(DECIMALS)

    def beside(self, name, value, places):
        """The number of the input's column `places` last places away from a value."""
        return self.nearest(value + places * self.form.last_place(abs(value)))

    def near_tie(self, row, name, difference):
        """The row with an operand changed so that `difference`, f - g in doubles, is near 0."""
        ends = [self.styles[self.rng.choice(("random", "small"))](name) for _ in (0, 1)]
        low, high = (float_of(self.kept(end, name)) for end in ends)
        below, above = (difference({**row, name: end}) for end in (low, high))
        if below is None or above is None or below * above > 0:
            return row
        for _ in range(60):
            middle = (low + high) / 2
            value = difference({**row, name: middle})
            if value is None:
                return row
            if (value > 0) == (above > 0):
                high = middle
            else:
                low = middle
        if not math.isfinite(high):
            return row
        return {**row, name: self.kept(self.nearest(Fraction(high)), name)}

    def turning_point(self, row, name, verdicts):
        """The row with an operand moved to a place where the reference changes its verdicts."""
        if "n" in row[name]:  # infinities and NaNs have no neighbours
            return row
        near = [{**row, name: self.beside(name, literal(row[name]), places)}
                for places in range(-5, 6)]
        found = [verdicts(other) for other in near]
        turns = [k for k in range(len(near) - 1) if found[k] != found[k + 1]]
        if not turns:
            return self.rng.choice(near[3:8])
        chosen = near[self.rng.choice(turns) + self.rng.choice((0, 1))]
        return {**chosen, name: self.kept(chosen[name], name)}

    def neighbour(self, row, names):
        """The row with one operand moved by a few places."""
        name = self.rng.choice(names)
        if row[name] in ("inf", "-inf", "nan"):
            return row
        moved = self.beside(name, literal(row[name]), self.rng.choice((1, -1, 1, -1, 2, -3)))
        return {**row, name: self.kept(moved, name)}


@dataclasses.dataclass(frozen=True)
class FixedFormat:
    """The numbers of an input: a format such as int8 or q3.12, or multiples of a promised grid."""

    name: str
    bits: int
    behind: int = 0  # bits behind the point
    is_signed: bool = True
    is_promised: bool = False  # operands arrive in floating point, and nearly all are its numbers
    coarser: int = 0  # a promised grid is 2^coarser units, which may be more than the range
    arrives_in: str = ""  # the format in floating point of promised operands, where they have one

    @property
    def declaration(self):
        if not self.is_promised:
            return f'{{ format = "{self.name}" }}'
        low, high = map(dyadic_text, self.ends)
        form = f'format = "{self.arrives_in}", ' if self.arrives_in else ""
        return f'{{ {form}range = ["{low}", "{high}"], grid = "{dyadic_text(self.grid)}" }}'

    @property
    def unit(self):
        return TWO ** -self.behind

    @property
    def grid(self):
        return self.unit * 2 ** self.coarser

    @property
    def ends(self):
        below = 2 ** (self.bits - 1 if self.is_signed else self.bits)
        return (-below * self.unit if self.is_signed else Fraction(0)), (below - 1) * self.unit

    def near(self, value):
        """The multiple of the grid within the range that is nearest to a fraction."""
        low, high = (round_to(end / self.grid) for round_to, end in
                     zip((math.ceil, math.floor), self.ends))
        return min(max(round(value / self.grid), low), high) * self.grid


class FixedOperands(Operands):
    """Draws operands of inputs in fixed point or on promised grids. One in 30 breaks a promise.

    `forms` has the FixedFormats of each column: of item i and item j, where both read it. An
    operand is a number of one of them.
    """

    def __init__(self, rng, form, forms):
        ranges = {name: (min(one.ends[0] for one in each), max(one.ends[1] for one in each))
                  for name, each in forms.items()}
        super().__init__(rng, form, ranges, allows_specials=False)
        self.forms = forms
        self.styles["decimal"] = self.random

    def kept(self, written, name):
        """The text of the nearest number of a format of the column."""
        form, value = self.rng.choice(self.forms[name]), literal(written)
        kept = form.near(value)
        if form.is_promised and self.rng.random() < 1 / 30:
            kept += self.rng.choice((form.grid / 2, -form.unit / 4, 2 * form.ends[1]))
        return written if kept == value else dyadic_text(kept)

    def nearest(self, value):
        """The text of the fraction: `kept` makes it a number of the column."""
        return dyadic_text(value)

    def beside(self, name, value, places):
        step = min(form.grid for form in self.forms[name])
        return self.kept(dyadic_text(value + places * step), name)


def float_of(written):
    return float(written) if "n" in written else as_float(literal(written))  # inf and nan


def as_float(value):
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def estimate(graph, inputs):
    """f - g of the first part in doubles; None where that is no number. For near ties only."""
    values = {}

    def value(index):
        if index not in values:
            node = graph.nodes[index]
            if node.operation == "input":
                values[index] = inputs[node.value]
            elif node.operation == "constant":
                values[index] = as_float(node.value)
            else:
                values[index] = apply(node, *map(value, node.operands))
        return values[index]

    try:
        f, g = map(value, graph.parts[0])
    except (ArithmeticError, ValueError):
        return None
    return f - g if math.isfinite(f - g) else None


def apply(node, a, b=0.0):
    if node.operation in IRRATIONAL:
        return nearly(node, a, b) if node.operation == "atan2" else nearly(node, a)
    return fold(node.operation, a, b)


def draw_rows(operands, reference, names, count):
    """Rows of a system of streams: each input is a column."""
    rng, graph = operands.rng, reference.graph
    rows = []

    def verdicts(row):
        return reference.verdicts({name: number(row[name], reference.form) for name in names})

    def difference(row):
        values = {name: word if isinstance(word, float) else float_of(word)
                  for name, word in row.items()}
        return estimate(graph, values)

    while len(rows) < count:
        draw = rng.random()
        if rows and draw < 0.2:
            rows.append(operands.neighbour(rng.choice(rows), names))
        elif draw < 0.6:
            name = rng.choice(names)
            row = operands.near_tie(operands.row(names), name, difference)
            rows.append(operands.turning_point(row, name, verdicts))
        else:
            rows.append(operands.row(names))
    return rows


def draw_items(operands, columns, count):
    """Items of an engine: some of them equal or near to each other."""
    rows = []
    for _ in range(count):
        if rows and operands.rng.random() < 0.4:
            rows.append(operands.neighbour(operands.rng.choice(rows), columns))
        else:
            rows.append(operands.row(columns))
    return rows
