"""A scene as the attack draws, shrinks and writes it, with its rows and verify's options."""

import copy
import dataclasses
import fnmatch
import re

from .rounded import Format, number
from .trees import Graph, literal, reads, subtrees, table_file, text

NAMED_FORMATS = {"binary16": (11, 5), "bfloat16": (8, 8), "binary32": (24, 8), "binary64": (53, 11),
                 "binary128": (113, 15), "E5M2": (3, 5)}
LISTS = ("lanes", "references")  # sections that are lists of tables


def float_format(name, flush=False):
    """The format "sPeE", or one with a name."""
    if name == "E4M3":
        return Format(4, 4, flush, has_infinities=False)
    if name not in NAMED_FORMATS:
        precision, _, exponent_bits = name[1:].partition("e")
        return Format(int(precision), int(exponent_bits), flush)
    return Format(*NAMED_FORMATS[name], flush)


@dataclasses.dataclass
class Scene:
    seed: int
    kind: str
    parts: list  # pairs of trees, f and g
    rows: list  # dictionaries: column -> text of a number
    others: list = dataclasses.field(default_factory=list)  # the rows of `data.with`
    combine: str = ""  # "all" or "any"; needed with several parts or an index
    index: tuple = ()  # ("k", 0, 2): `for` of the scene
    lets: dict = dataclasses.field(default_factory=dict)
    sections: dict = dataclasses.field(default_factory=dict)  # section -> key -> value
    inputs: dict = dataclasses.field(default_factory=dict)  # pattern -> the table as TOML
    options: dict = dataclasses.field(default_factory=dict)  # of verify: name -> value
    widest: str = ""  # holds all operands, where the reference's format is "exact" or such as "q20"

    def copy(self):
        return copy.deepcopy(self)

    def get(self, section, key, default=None):
        return self.sections.get(section, {}).get(key, default)

    def set(self, section, **values):
        self.sections.setdefault(section, {}).update(values)

    @property
    def engine(self):
        return self.get("engine", "kind", "none")

    @property
    def pairs(self):
        return self.get("data", "pairs", "")

    def lane_count(self):
        return self.get("system", "lanes") or sum(kind["count"] for kind in self.sections["lanes"])

    def reference_format(self):
        return float_format(self.widest or self.get("reference", "format"),
                            self.get("reference", "subnormals") == "flush")

    def operand_format(self, name):
        """The format in floating point to which an input's numbers are rounded when read."""
        own = re.search(r'format = "(s[0-9]+e[0-9]+|E[0-9]M[0-9])"', self.input_table(name))
        return float_format(own[1]) if own else self.reference_format()

    def input_table(self, name):
        """What the scene declares of an input, as TOML."""
        tables = [self.inputs[key] for key in self.inputs if fnmatch.fnmatchcase(name, key)]
        return self.inputs.get(name, tables[0] if tables else "")

    def keeps_promises(self, name, value):
        """Whether a fraction is in the range and on the grid that an input declares in numbers."""
        table = self.input_table(name)
        ends = re.search(r'range = \["?([^",]+)"?, "?([^",]+)"?\]', table)
        grid = re.search(r'grid = "?([^",} ]+)', table)
        inside = not ends or literal(ends[1]) <= value <= literal(ends[2])
        return inside and (not grid or (value / literal(grid[1])).denominator == 1)

    def graph(self):
        made = Graph(self.lets)
        indices = [{}]
        if self.index:
            name, first, last = self.index
            indices = [{name: k} for k in range(first, last + 1)]
        for f, g in self.parts:
            for values in indices:
                made.add_part(f, g, values)
        return made

    def used_lets(self):
        """The lets that f and g need, those of other lets included."""
        used = {}
        waiting = [side for part in self.parts for side in part]
        while waiting:
            tree = waiting.pop()
            for name, let in self.lets.items():
                if name not in used and _mentions(tree, name):
                    used[name] = let
                    waiting.append(let)
        return used

    def tables(self):
        """The files of points that f and g need, and what they hold."""
        sides = [*(side for part in self.parts for side in part), *self.used_lets().values()]
        return {table_file(tree): "x,y\n" + tree[2].replace(";", "\n") + "\n"
                for side in sides for _, tree in subtrees(side) if tree[0] == "table"}

    def pruned(self):
        """The scene without lets, ranges and columns that nothing reads any more."""
        pruned = self.copy()
        pruned.lets = self.used_lets()
        names = pruned.graph().inputs()
        pruned.inputs = {pattern: table for pattern, table in self.inputs.items()
                         if any(fnmatch.fnmatchcase(name, pattern) for name in names)}
        if not self.pairs:
            pruned.rows = [{name: row[name] for name in names} for row in self.rows]
        return pruned

    def toml(self):
        lines = ["[comparison]", f'name = "{self.kind}"']
        sides = [[text(part[k]) for part in self.parts] for k in (0, 1)]
        for key, side in zip("fg", sides):
            lines.append(f"{key} = {_toml(side if len(side) > 1 else side[0])}")
        if self.index:
            lines.append('for = "{} in {}..{}"'.format(*self.index))
        if self.combine:
            lines.append(f'combine = "{self.combine}"')
        _add_section(lines, "let", {name: text(tree) for name, tree in self.lets.items()})
        if self.inputs:
            lines += ["", "[inputs]"]
            lines += [f'"{pattern}" = {table}' for pattern, table in self.inputs.items()]
        for section, values in self.sections.items():
            if section in LISTS:
                for table in values:
                    _add_section(lines, f"[{section}]", table)
            else:
                _add_section(lines, section, values)
        return "\n".join(lines) + "\n"

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.toml").write_text(self.toml())
        (folder / "rows.csv").write_text(_csv(self.rows))
        if self.others:
            (folder / "others.csv").write_text(_csv(self.others))
        for name, points in self.tables().items():
            (folder / name).write_text(points)


def _mentions(tree, let):
    return reads(tree, "let") and (tree == ("let", let) or any(
        isinstance(part, tuple) and _mentions(part, let) for part in tree))


def _toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def _add_section(lines, name, values):
    if values:
        lines += ["", f"[{name}]"] + [f"{key} = {_toml(value)}" for key, value in values.items()]


def _csv(rows):
    columns = list(rows[0])
    lines = [columns] + [[row[name] for name in columns] for row in rows]
    return "".join(",".join(line) + "\n" for line in lines)


def comparisons(scene, graph):
    """Each comparison's number, items (i, j) or None, and its inputs as numbers of the format.

    An arg-min engine's comparisons depend on verdicts; see judge.py.
    """
    names = graph.inputs()
    forms = {name: scene.operand_format(name) for name in names}
    if not scene.pairs:
        for k, row in enumerate(scene.rows):
            yield k, None, {name: number(row[name], forms[name]) for name in names}
        return
    if scene.pairs == "all":
        count = len(scene.rows)
        pairs = [(i, j) for i in range(count) for j in range(i + 1, count)]
        others = scene.rows
    else:
        pairs = [(i, j) for i in range(len(scene.rows)) for j in range(len(scene.others))]
        others = scene.others
    for k, (i, j) in enumerate(pairs):
        yield k, (i, j), {name: number(_item_text(name, scene.rows[i], others[j]), forms[name])
                          for name in names}


def contest(scene, graph, row, i, j):
    """The inputs of an arg-min engine's comparison of candidates i and j for a row."""
    inputs = {}
    for name in graph.inputs():
        column, item = item_column(name)
        table = {"i": scene.others[i], "j": scene.others[j]}.get(item)
        inputs[name] = number(table[column] if table else scene.rows[row][name],
                              scene.operand_format(name))
    return inputs


def item_column(name):
    """The column and the item's letter of an input: cxi is column cx of item i, ci_2 column c_2."""
    base, bar, subscript = name.partition("_")
    return base[:-1] + bar + subscript, base[-1]


def _item_text(name, i, j):
    column, item = item_column(name)
    return (i if item == "i" else j)[column]


