"""A scene drawn at random: formats, options, expressions, ranges and rows."""

import random

from .expressions import Expressions, candidates_for_let, name
from .function_sides import FunctionSides
from .rounded import INFINITE, NAN, Format, Reference, number
from .rows import FixedOperands, Operands, draw_items, draw_rows
from .scene import Scene, float_format, item_column
from .trees import IRRATIONAL, dyadic_text, exchanged, literal, replaced, subtrees

NAMES = ("a", "b", "c", "d", "e", "u", "v", "w", "x", "z")
PRECISIONS = (11, 11, 12, 12, 13, 14, 15, 16, 17, 18, 20, 23, 24, 25)
WIDE_PRECISIONS = (31, 32, 33, 47, 48, 52, 53, 54, 63, 64, 65, 66, 100, 112, 113)
DEVICES = ("virtex5-lx330t", "virtex6-lx760", "artix7-200t", "ultrascale+-vu9p", "ecp5-85k",
           "ice40-hx8k", "ice40-up5k")
RANGES = (("0", "4"), ("-4", "4"), ("1", "3"), ("0", "1"), ("-1", "1"), ("0.1", "7.3"), ("-8", "8"),
          ("0x1p-3", "5"), ("-2.5", "0"), ("2", "16"), ("0x1p-12", "1"), ("0.002", "30"))


class Draft:
    """A scene that is being drawn: each step reads the choices of earlier steps."""

    def __init__(self, seed, kind):
        self.rng = random.Random(f"mixcmp attack {seed}")
        self.scene = Scene(seed, kind, [], [])
        self.leaves = None
        self.sides = "any"  # how f and g are drawn: a method sides_... below
        self.ranges = {}
        self.wants_ranges = False
        self.fixed = None  # draws the FixedFormats of inputs by name; None: floating point
        self.forms = {}  # input -> its FixedFormat
        self.row_count = self.rng.choice((12, 20, 30, 45))
        self.formats()
        self.scene.set("system", lanes=self.rng.choice((1, 1, 1, 2, 3)),
                       references=self.rng.choice((1, 1, 1, 1, 2)))

    def chance(self, share):
        return self.rng.random() < share

    # The sections of a scene.

    def formats(self, wide=0.08):
        rng = self.rng
        precision = rng.choice(WIDE_PRECISIONS if self.chance(wide) else PRECISIONS)
        exponent_bits = rng.choice((4, 5, 5, 6, 7, 8, 8))
        if precision > 25:
            exponent_bits = rng.choice((8, 11, 11, 15))
        most = min(precision, 52)
        lane_precisions = (4, 4, 5, 6, 7, 8, 9, 11, 12, 15, 16, 17, 24)
        reduced = rng.choice([p for p in lane_precisions if p <= most])
        lane_bits = exponent_bits if self.chance(0.6) else rng.randint(3, exponent_bits + 1)
        self.scene.set("reference", format=f"s{precision}e{exponent_bits}")
        self.scene.set("reduced", format=f"s{reduced}e{min(lane_bits, 15)}")

    def precision(self):
        return self.scene.reference_format().precision

    def reference_options(self, share):
        rng, choices = self.rng, {
            "subnormals": lambda: "flush", "sums": lambda: "fused", "multipliers": lambda: "logic",
            "initiation_interval": lambda: rng.choice((2, 2, 3, 3, 4, 5, 7, 8, 9, 12, 16, 23, 64)),
            "target_mhz": lambda: rng.choice((1, 60, 150, 300, 500, 1000))}
        self.some("reference", choices, share)

    def lane_options(self, share):
        if not self.is_float():
            return
        rng, choices = self.rng, {
            "rounding": lambda: "toward_zero", "subnormals": lambda: "gradual",
            "multipliers": lambda: "logic", "inputs": lambda: rng.choice(("rounded", "digits")),
            "bound": lambda: "profiled" if self.chance(0.15) else "certified"}
        self.some("reduced", choices, share)
        if self.scene.get("reduced", "inputs") == "digits":
            most = self.precision()
            least = int(self.scene.get("reduced", "format")[1:].partition("e")[0])
            self.scene.set("reduced", inputs=rng.randint(min(least, most), most))

    def system_options(self, share):
        rng, choices = self.rng, {
            "device": lambda: rng.choice(DEVICES),
            "target_mhz": lambda: rng.choice((1, 50, 120, 350, 600)),
            "input_registers": lambda: rng.choice((1, 2)), "order": lambda: "in_order",
            "operands": lambda: "refetched", "operand_memory": lambda: "block",
            "tag_bits": lambda: rng.choice((9, 16, 33, 64)),
            "prefix": lambda: rng.choice(("", "x_", "Q9")),
            "counters": lambda: rng.choice(("none", "axi_lite", "axi_lite")),
            "counter_bits": lambda: rng.choice((16, 17, 40, 64))}
        if self.scene.engine != "none":  # the engine decides the others
            choices = {key: choices[key] for key in ("device", "target_mhz", "prefix", "counters",
                                                     "counter_bits")}
        self.some("system", choices, share)
        system = self.scene.sections["system"]
        if system.get("counters") == "none":
            system.pop("counter_bits", None)
        if system.get("operands") == "refetched":
            system.pop("operand_memory", None)
        elif self.scene.engine == "none" and self.chance(share):
            self.beats()

    def beats(self):
        beats = self.rng.choice((1, 2, 2, 4, 8, 16))
        interval = self.scene.get("reference", "initiation_interval", 1)
        if interval == 1 or interval >= 2 * beats:
            self.scene.set("system", request_beats=beats)

    def groups(self):
        group = self.rng.choice((2, 2, 3, 4))
        self.scene.set("system", lanes_per_group=group, lanes=group * self.rng.choice((1, 2)))

    def run_options(self):
        options = self.scene.options
        options["simulator"] = "verilator" if self.chance(0.03) else "icarus"
        if self.chance(0.35):
            options["traffic"] = "stressed"
            options["seed"] = self.rng.randint(1, 1000)
        if self.chance(0.2):
            options["resets"] = self.rng.choice((1, 2, 3))
        if self.chance(0.4):
            options["truth"] = "all"
        if self.chance(0.1):
            options["judge"] = "mpfr"
        if self.sides in ("functions", "quotients") and self.chance(0.4):
            options["variant"] = "moved_1"

    def some(self, section, choices, share):
        for key, value in choices.items():
            if self.chance(share):
                self.scene.set(section, **{key: value()})

    def is_float(self):
        return self.scene.get("reduced", "format")[0] == "s"

    # The comparison.

    def draw_leaves(self):
        rng, pairs = self.rng, self.scene.pairs
        count = rng.choice((2, 3, 3, 4, 4, 5, 6))
        if pairs:
            bases = rng.sample(("x", "y", "z", "r"), rng.choice((1, 2, 3)))
            names = [base + item for base in bases for item in "ij"]
            if pairs == "arg_min":
                names = [base + "i" for base in bases] + [f"p{base}" for base in bases[:2]]
        else:
            names = rng.sample(NAMES, count)
        self.leaves = [name(word) for word in names]

    def expressions(self, weights=None):
        return Expressions(self.rng, self.leaves, weights)

    def operations(self):
        return self.rng.choice((1, 2, 3, 3, 4, 4, 5, 5, 6, 7, 8, 10))

    def sides_any(self, weights=None):
        made = self.expressions(weights)
        if self.chance(0.15):
            return made.identity(self.operations())
        return made.any(self.operations()), made.any(self.operations())

    def sides_products(self):
        """Sums of products and squares, where folding and fusing have most to share."""
        return self.sides_any({"*": 8, "square": 6, "^": 1, "abs": 0.2, "min": 0.2, "max": 0.2,
                               "/": 0.2, "sqrt": 0.2, "sum": 1})

    def sides_dyadic(self):
        """Sums, products and choices, in which no operation rounds if there are digits enough."""
        return self.sides_any({"/": 0, "sqrt": 0, "^": 0, "product": 0, "scale": 0.5, "shift": 0.2,
                               "min": 1, "max": 1, "choices": 0.5})

    def sides_quotients(self):
        return self.sides_any({"/": 6, "sqrt": 5})

    def sides_choices(self):
        return self.sides_any({"min": 5, "max": 5, "abs": 4, "choices": 3, "neg": 2})

    def sides_polynomials(self):
        return self.sides_any({"/": 0})

    def sides_positive(self):
        made = self.expressions()
        return made.positive(self.operations()), made.positive(self.operations())

    def sides_homogeneous(self):
        made, degree = self.expressions(), self.rng.choice((1, 2, 2, 2, 3, 4))
        return tuple(made.homogeneous(degree, self.operations()) for _ in (0, 1))

    def sides_norms(self):
        return self.expressions().norms()

    def sides_vectors(self):
        """Reductions over the elements of vectors."""
        rng, count = self.rng, self.rng.choice((1, 2, 3, 3, 4, 5))
        made = self.expressions()
        vectors = rng.sample(("p", "q", "s"), 2)
        f = made.over(vectors, count)
        if self.chance(0.3):
            f = ("+", f, made.any(2))
        return f, made.over(vectors, count) if self.chance(0.4) else made.any(self.operations())

    def sides_functions(self):
        f, g = FunctionSides(self.rng, self.leaves, self.range_of, bool(self.fixed)).drawn()
        return (f, g) if self.scene.pairs == "arg_min" or self.chance(0.6) else (g, f)

    def range_of(self, word):
        """The range of an input, declared when it is first asked for. Items of a column share it."""
        if word not in self.ranges:
            base, item = item_column(word)
            like = [other for other in self.ranges if self.scene.pairs and item in "ij"
                    and item_column(other)[0] == base and item_column(other)[1] in "ij"]
            self.ranges[word] = self.ranges[like[0]] if like else tuple(
                map(literal, self.rng.choice(RANGES)))
            if not self.fixed:
                self.scene.inputs[word] = table_of(*map(exact_text, self.ranges[word]))
        return self.ranges[word]

    def draw_parts(self, count=1):
        draw = getattr(self, f"sides_{self.sides}")
        if self.leaves is None:
            self.draw_leaves()
        allowed = 1
        while not self.scene.parts or self.cost() > allowed:
            self.scene.parts = [self.for_items(draw) for _ in range(count)]
            allowed *= 1.02
        if count > 1:
            self.scene.combine = self.rng.choice(("all", "any"))
        if self.chance(0.12):
            self.add_let()

    def cost(self):
        """The size of the hardware; 1 is a size that Icarus simulates in a second or two."""
        weights = {"input": 0, "constant": 0, **dict.fromkeys(IRRATIONAL, 6), "/": 3, "sqrt": 3}
        units = sum(weights.get(node.operation, 1) for node in self.scene.graph().nodes)
        datapaths = self.scene.lane_count() / 2 + self.scene.get("system", "references", 2)
        return units * datapaths / max(6, min(30, 700 / self.precision()))

    def for_items(self, draw):
        """A part that reads the items of the data's pairs: i and j, or candidates and the row."""
        while True:
            part = draw()
            if self.scene.pairs == "arg_min":
                items, part = items_of(part[:1]), (part[0], other_item(part[0]))
                if "i" in items and len(items) > 1:
                    return part
            elif not self.scene.pairs or items_of(part) == {"i", "j"}:
                return part

    def add_let(self):
        sides = [side for part in self.scene.parts for side in part]
        found = [tree for side in sides for tree in candidates_for_let(side)]
        if found:
            tree = self.rng.choice(found)
            self.scene.lets["shared"] = tree
            self.scene.parts = [tuple(exchanged(side, tree, ("let", "shared")) for side in part)
                                for part in self.scene.parts]

    def limits(self):
        """Limits around some subtrees."""
        for k, part in enumerate(self.scene.parts):
            side = self.rng.choice((0, 1))
            found = [path for path, tree in subtrees(part[side])
                     if tree[0] not in ("constant", "index", "within")]
            path = self.rng.choice(found)
            low, high = self.rng.choice((("-4", "4"), ("-1", "2"), ("0", "8"), ("-0.3", "10"),
                                         ("-100", "100"), ("0x1p-2", "3")))
            tree = at(part[side], path)
            limited = replaced(part[side], path, ("within", tree, low, high))
            self.scene.parts[k] = (limited, part[1]) if side == 0 else (part[0], limited)

    def draw_ranges(self, names):
        """Declares ranges: one for all, one for each, or for some."""
        rng, form = self.rng, self.scene.reference_format()
        fitting = [ends for ends in RANGES
                   if max(abs(literal(end)) for end in ends) <= form.largest]
        if self.sides == "positive":
            fitting = [pair for pair in fitting if literal(pair[0]) >= 0]
        common = rng.choice(fitting)
        style = rng.choice(("common", "common", "each", "data"))
        if not self.wants_ranges and self.chance(0.3):
            style, names = "each", rng.sample(names, rng.randint(1, len(names)))
        if style == "data":
            common = rng.choice(fitting)
            self.scene.inputs["*"] = '{ range = "data" }'
            self.ranges = {word: tuple(map(literal, common)) for word in names}
            return
        for word in names:
            low, high = common if style == "common" else rng.choice(fitting)
            self.ranges[word] = literal(low), literal(high)
            if style == "each":
                self.scene.inputs[word] = table_of(low, high)
        if style == "common":
            self.scene.inputs["*"] = table_of(*common)

    # The data.

    def draw_data(self):
        graph = self.scene.graph()
        names = graph.inputs()
        if not names:
            self.scene.rows = [{"a": "1"}]
            return
        if self.fixed:
            self.declare_forms(names)
        elif self.sides == "functions":
            self.ranges = {word: self.range_of(word) for word in names}
            self.scene.inputs = {word: self.scene.inputs[word] for word in names}
        elif self.wants_ranges or self.chance(0.15):
            self.draw_ranges(names)
        allows_specials = not self.scene.inputs.get("*", "").count("data")
        form = self.scene.reference_format()
        if not self.scene.pairs:
            operands = self.operands({word: [word] for word in names}, self.ranges,
                                     allows_specials)
            reference = Reference(graph, form, self.scene.get("reference", "sums") == "fused")
            self.scene.rows = draw_rows(operands, reference, names, self.row_count)
            return
        self.draw_tables(names, allows_specials)

    def declare_forms(self, names):
        """Draws and declares the inputs' formats in fixed point and their promised grids."""
        self.forms = self.fixed(names)
        declared = {word: form.declaration for word, form in self.forms.items()}
        self.scene.inputs = declared if len(set(declared.values())) > 1 else {
            "*": declared[names[0]]}

    def operands(self, columns, ranges, allows_specials):
        """The operands of each column, which may be that of several inputs: column -> inputs."""
        form = self.scene.reference_format()
        if self.fixed:
            forms = {column: [self.forms[word] for word in words]
                     for column, words in columns.items()}
            return FixedOperands(self.rng, form, forms)
        return Operands(self.rng, form, ranges, allows_specials)

    def draw_tables(self, names, allows_specials):
        """The items of an engine. Inputs of one column share the range of the first."""
        def is_item(word):
            return item_column(word)[1] in "ij"

        ranges = {item_column(word)[0] if is_item(word) else word: self.ranges[word]
                  for word in self.ranges}
        for word in self.ranges:
            if is_item(word) and word in self.scene.inputs:
                low, high = ranges[item_column(word)[0]]
                self.scene.inputs[word] = table_of(exact_text(low), exact_text(high))
        rest = [word for word in names if not is_item(word)]
        columns = sorted({item_column(word)[0] for word in names if is_item(word)})
        of_column = {column: [word for word in names
                              if is_item(word) and item_column(word)[0] == column]
                     for column in columns}
        operands = self.operands({**of_column, **{word: [word] for word in rest}}, ranges,
                                 allows_specials)
        if self.scene.pairs == "arg_min":
            self.scene.others = draw_items(operands, columns, self.scene.lane_count() + 1)
            self.scene.rows = draw_items(operands, rest, self.rng.choice((4, 6, 9)))
            return
        self.scene.rows = draw_items(operands, columns, self.rng.choice((4, 6, 8)))
        if self.scene.pairs == "cross":
            self.scene.others = draw_items(operands, columns, self.rng.choice((3, 5)))

    def narrow_operands(self):
        """Gives some inputs formats of their own that the reference's holds. A column has one."""
        rng, form = self.rng, self.scene.reference_format()
        chosen = {}
        for word in self.scene.graph().inputs():
            base, item = item_column(word)
            column = base if self.scene.pairs and item in "ij" else word
            if column not in chosen:
                has_own = self.scene.widest or rng.random() < 0.7
                chosen[column] = self.narrower(form) if has_own else None
            if chosen[column]:
                table = self.scene.inputs.get(word, self.scene.inputs.get("*", "{ }"))
                rest = table.strip("{} ")
                table = f'format = "{chosen[column].name}"{", " + rest if rest else ""}'
                self.scene.inputs[word] = f"{{ {table} }}"
        if all(word in self.scene.inputs for word in self.scene.graph().inputs()):
            self.scene.inputs.pop("*", None)  # a key that decides nothing is refused
        for row in self.scene.rows + self.scene.others:
            for column in row:
                if chosen.get(column):
                    row[column] = self.within(chosen[column], row[column])

    def narrower(self, form):
        if form.exponent_bits > 4 and self.chance(0.25):
            return float_format("E4M3")
        exponent_bits = self.rng.randint(2, form.exponent_bits)
        if self.chance(0.4):
            exponent_bits = form.exponent_bits
        return Format(self.rng.randint(2, min(form.precision, 24)), exponent_bits)

    def within(self, form, written):
        """The text, or the largest number's where the format would round it to infinity. Without
        infinities the text stays, since it may become the NaN."""
        value = number(written, form)
        if "n" in written or value is NAN or value[1] is not INFINITE:
            return written
        return ("-" if value[0] else "") + dyadic_text(form.largest)

    def finished(self):
        if not self.scene.parts:
            self.draw_parts(2 if self.chance(0.08) else 1)
        self.scene.set("data", file="rows.csv")
        self.draw_data()
        if self.scene.others:
            self.scene.set("data", **{"with": "others.csv"})
        self.run_options()
        if not self.fixed and self.scene.inputs.keys() <= {"*", *self.scene.graph().inputs()}:
            if self.scene.widest or self.chance(0.3):
                self.narrow_operands()
        return self.scene


def exact_text(value):
    """A literal of a fraction: each of RANGES is a decimal or a hex-float."""
    return next(end for pair in RANGES for end in pair if literal(end) == value)


def table_of(low, high):
    quoted = [f'"{end}"' if "x" in end else end for end in (low, high)]
    return f"{{ range = [{quoted[0]}, {quoted[1]}] }}"


def at(tree, path):
    for place in path:
        tree = tree[place]
    return tree


def other_item(tree):
    """The same tree of item j."""
    if tree[0] == "input" and tree[1].endswith("i"):
        return ("input", tree[1][:-1] + "j")
    return tuple(other_item(part) if isinstance(part, tuple) else part for part in tree)


def items_of(sides):
    """The last letters of the inputs' names."""
    return {below[1][-1] for side in sides for _, below in subtrees(side) if below[0] == "input"}
