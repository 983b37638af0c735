"""Makes a failing scene smaller while it fails in the same way."""

import time

from .trees import exchanged, replaced, size, subtrees

SECONDS = 480  # that shrinking one scene may take


class Interrupted(Exception):
    """No further scene will be judged."""


def shrunken(scene, outcome, attack):
    """The smallest scene found and its outcome; `attack` judges a scene, or is interrupted."""
    search = Search(scene, outcome, attack)
    try:
        for shrink in (search.drop_rows, search.drop_options, search.shrink_expressions,
                       search.drop_options, search.drop_rows):
            shrink()
    except Interrupted:
        pass
    return search.scene, search.outcome


class Search:
    def __init__(self, scene, outcome, attack):
        self.scene, self.outcome, self.attack = scene, outcome, attack
        self.end = time.monotonic() + SECONDS
        self.tried = set()

    def keeps(self, candidate):
        """Takes the candidate if it fails in the same way."""
        if time.monotonic() > self.end:
            return False
        try:
            candidate = candidate.pruned()
            if repr(candidate) in self.tried:
                return False
            self.tried.add(repr(candidate))
            outcome = self.attack(candidate)
        except (KeyError, IndexError, ValueError, ArithmeticError):
            return False  # the rest is no scene
        if outcome.way != self.outcome.way:
            return False
        self.scene, self.outcome = candidate, outcome
        return True

    def drop_rows(self):
        count = len(self.scene.rows)
        likely = [k for k in self.outcome.worst if k < count][:2] + [0, count // 2]
        if not self.scene.pairs and any(self.keeps(with_rows(self.scene, [k])) for k in likely):
            return
        part = count // 2
        while part:
            first = 0
            while first < len(self.scene.rows):
                kept = [k for k in range(len(self.scene.rows)) if not first <= k < first + part]
                if not (kept and self.keeps(with_rows(self.scene, kept))):
                    first += part
            part //= 2

    def drop_options(self):
        """Leaves out one key of one section at a time, and one table of a list."""
        for name in list(self.scene.options):
            if name != "simulator" or self.scene.options[name] == "verilator":
                self.keeps(without_option(self.scene, name))
        for section, values in list(self.scene.sections.items()):
            if isinstance(values, list):
                self.drop_tables(section)
                continue
            for key in list(values):
                self.keeps(without_key(self.scene, section, key))
        for section, key, value in (("system", "lanes", 1), ("system", "references", 1)):
            if self.scene.get(section, key, value) != value:
                candidate = self.scene.copy()
                candidate.set(section, **{key: value})
                self.keeps(candidate)
        if self.scene.inputs:
            candidate = self.scene.copy()
            candidate.inputs = {}
            self.keeps(candidate)

    def drop_tables(self, section):
        place = 0
        while place < len(self.scene.sections[section]) > 1:
            candidate = self.scene.copy()
            del candidate.sections[section][place]
            if not self.keeps(candidate):
                place += 1

    def shrink_expressions(self):
        while len(self.scene.parts) > 1 and any(self.keeps(without_part(self.scene, k))
                                                for k in range(len(self.scene.parts))):
            continue
        for name in list(self.scene.lets):
            self.keeps(without_let(self.scene, name))
        while any(self.keeps(candidate) for candidate in smaller_expressions(self.scene)):
            continue


def with_rows(scene, kept):
    candidate = scene.copy()
    candidate.rows = [scene.rows[k] for k in kept]
    return candidate


def without_option(scene, name):
    candidate = scene.copy()
    if name == "simulator":
        candidate.options[name] = "icarus"
    else:
        del candidate.options[name]
    return candidate


def without_key(scene, section, key):
    candidate = scene.copy()
    del candidate.sections[section][key]
    if not candidate.sections[section]:
        del candidate.sections[section]
    return candidate


def without_part(scene, place):
    candidate = scene.copy()
    del candidate.parts[place]
    if len(candidate.parts) == 1 and not candidate.index:
        candidate.combine = ""
    return candidate


def without_let(scene, name):
    """The scene with a let's expression in the place of its name."""
    candidate = scene.copy()
    tree = candidate.lets.pop(name)
    candidate.parts = [tuple(exchanged(side, ("let", name), tree) for side in part)
                       for part in candidate.parts]
    return candidate


def smaller_expressions(scene):
    """Scenes with one subtree replaced by an operand of it, another leaf or a constant."""
    for place, part in enumerate(scene.parts):
        for side in (0, 1):
            for path, tree in subtrees(part[side]):
                for new in simpler(tree):
                    candidate = scene.copy()
                    sides = list(part)
                    sides[side] = replaced(part[side], path, new)
                    candidate.parts[place] = tuple(sides)
                    yield candidate


def simpler(tree):
    """Trees that are smaller than this one, the smallest first."""
    leaves = [below for _, below in subtrees(tree) if below[0] in ("input", "element")]
    found = leaves[:1] + [("constant", "1")] if size(tree) > 1 else []
    operands = [part for part in tree if isinstance(part, tuple)]
    found += sorted((part for part in operands if size(part) > 1), key=size)
    if len(operands) > 2:
        found.append((tree[0], *operands[:-1]))
    if tree[0] == "^" and tree[2] > 2:
        found.append(("^", tree[1], 2))
    return found
