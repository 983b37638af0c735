"""Runs `mixcmp verify` on a scene and judges its output by arithmetic of its own.

A verdict that a certified lane decided must be the order of the real numbers f and g. A recomputed
verdict must be the order of the values that the reference computes.
"""

import collections
import csv
import dataclasses
import json
import re
import subprocess
from fractions import Fraction

from . import exact
from .rounded import Reference, is_finite, value_of
from .scene import comparisons, contest

SECONDS = 900  # that one run may take
# The comparison has the verdict of its parts that comes last in this order.
ORDERS = {"all": ("less", "equal", "unordered", "greater"),
          "any": ("greater", "equal", "unordered", "less")}


@dataclasses.dataclass
class Outcome:
    """The outcome of a scene. `way` says how it failed, for the shrinker to compare."""

    way: str = ""  # empty: it passed or was refused
    refusal: str = ""  # why the program refused the scene
    detail: str = ""
    comparisons: int = 0
    recomputed: int = 0
    unchecked: int = 0  # verdicts that this judge cannot check
    worst: tuple = ()  # numbers of the comparisons that are wrong


class Failure(Exception):
    def __init__(self, way, detail, worst=()):
        super().__init__(way)
        self.outcome = Outcome(way=way, detail=detail, worst=tuple(worst))


def attack(scene, folder, program):
    """Writes the scene into the folder, runs the program on it, and judges. If it asks for a move
    and has none, it is taken as it is written."""
    outcome = _attacked(scene, folder, program)
    if not outcome.refusal.startswith("comparison.variant"):
        return outcome
    del scene.options["variant"]
    return _attacked(scene, folder, program)


def _attacked(scene, folder, program):
    scene.write(folder)
    command = verify_command(scene, folder, program)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return Outcome(way="hangs", detail=f"no end after {SECONDS} s")
    try:
        return _judge(scene, folder, done, stated_error(scene, folder, program))
    except Failure as failure:
        return failure.outcome


def verify_command(scene, folder, program):
    command = [str(program), "verify", str(folder / "scene.toml"), "--json", "--quiet",
               "--no-counterexample", "--work", str(folder / "work"), "--jobs", "1",
               "--csv", str(folder / "verdicts.csv")]
    for name, value in scene.options.items():
        command += [f"--{name}", str(value)]
    return command


def stated_error(scene, folder, program):
    """How far f - g of a reference in fixed point may be from the real one, as `check` says."""
    said = re.search(r"where f - g errs by less than 2\^(\S+)", _checked(scene, folder, program))
    return Fraction(2) ** int(said[1]) if said else Fraction(0)


def _checked(scene, folder, program):
    if not scene.widest:
        return ""
    done = subprocess.run([str(program), "check", str(folder / "scene.toml")], capture_output=True,
                          text=True, timeout=SECONDS, check=False)
    return done.stdout


def _judge(scene, folder, done, error):
    if done.returncode not in (0, 1, 2):
        raise Failure(f"exit code {done.returncode}", done.stderr[-2000:])
    try:
        report = json.loads(done.stdout)
    except ValueError:
        raise Failure(f"no report, exit code {done.returncode}",
                      (done.stdout + done.stderr)[-2000:])
    if "error" in report:
        return _refusal(report["error"], done.returncode)
    try:
        outcome = check_verdicts(scene, folder, report, error)
    except Failure as failure:
        outcome = failure.outcome
    if report["passed"] is not True or done.returncode != 0:
        found = report["mismatches"] + report["violations"]
        outcome.way = "verify fails"
        outcome.detail += "\n" + json.dumps(found[:3], indent=1)
    return outcome


def _refusal(error, returncode):
    """The outcome of an error, which must name the field at fault, or a file of the scene."""
    said = error.get("text", "")
    if returncode != 1 or not said:
        raise Failure("an error without words", json.dumps(error))
    if not error.get("field") and not re.search(r"\.(toml|csv)", error.get("file") or ""):
        raise Failure("error: " + re.sub(r"\S*/\S*|\d+", "#", said)[:120], said)
    message = error.get("message") or said
    return Outcome(refusal=re.sub(r"\d+", "#", f'{error.get("field", "")}: {message}'), detail=said)


def check_verdicts(scene, folder, report, error=None):
    with open(folder / "verdicts.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    judge = Judge(scene)
    judge.error = error
    if scene.pairs == "arg_min":
        judge.check_chains(rows)
    elif scene.engine == "pairwise":
        judge.check_reports(rows, report)
    else:
        judge.check_all(rows)
        if report["recomputations"] != sum(row["recomputed"] == "1" for row in rows):
            raise Failure("recomputations are miscounted", f'{report["recomputations"]} reported')
        judge.check_truth(report)
    return judge.outcome


class Judge:
    def __init__(self, scene):
        self.scene = scene
        self.graph = scene.graph()
        self.order = ORDERS[scene.combine or "all"]
        self.reference = Reference(self.graph, scene.reference_format(),
                                   scene.get("reference", "sums") == "fused")
        tables = [scene.sections.get("reduced", {}), *scene.sections.get("lanes", [])]
        self.certified = all(table.get("bound") != "profiled" for table in tables)
        self.has_references = scene.get("system", "references", 1) != 0
        self.has_second_tier = scene.get("second_tier", "format", "none") != "none"
        form = scene.get("reference", "format")
        self.is_exact, self.is_fixed = form == "exact", bool(scene.widest) and form != "exact"
        self.error = None  # of f - g in a reference in fixed point
        # A reference in fixed point reads smaller operands as 0; ranges are within 2^6.
        self.least = Fraction(2) ** (6 - int(form[1:])) if self.is_fixed else 0
        self.outcome = Outcome()

    def truth(self, inputs):
        return self._strongest([exact.verdict(self.graph, part, inputs)
                                for part in self.graph.parts])

    def recomputed(self, inputs):
        """The verdict of a reference; None if this judge does not know it."""
        if "variant" in self.scene.options and not self.is_exact:
            return None  # a move rounds otherwise
        if not (self.is_exact or self.is_fixed):
            return self._combined(self.reference.verdicts(inputs))
        if self.is_exact and not all(map(is_finite, inputs.values())):
            return None
        if not all(self.scene.keeps_promises(name, value_of(number))
                   for name, number in inputs.items() if is_finite(number)):
            return None
        if self.is_exact:
            return self.truth(inputs)
        if (True, 0) in inputs.values():
            return None  # it is out of a range without negative numbers
        return self._strongest([self._by_fixed_point(part, inputs) for part in self.graph.parts])

    def _by_fixed_point(self, part, inputs):
        """A part's verdict by a reference in fixed point; None if its error may decide."""
        read = {self.graph.nodes[node].value for side in part for node in self.graph.below(side)
                if self.graph.nodes[node].operation == "input"}
        if not all(is_finite(inputs[name]) for name in read):
            return "unordered"
        if any(0 < abs(value_of(inputs[name])) < self.least for name in read):
            return None  # the reference may read 0, of which a quotient or a logarithm has no value
        if exact.difference_within(self.graph, part, inputs, self.error) is not False:
            return None
        return exact.verdict(self.graph, part, inputs)

    def _strongest(self, verdicts):
        """The last verdict of the order wins, even if another part is not determined."""
        if self.order[-1] in verdicts:
            return self.order[-1]
        return None if None in verdicts else self._combined(verdicts)

    def _combined(self, verdicts):
        return max(verdicts, key=self.order.index)

    def check_all(self, rows):
        """Systems of streams: every comparison once, in order."""
        expected = list(comparisons(self.scene, self.graph))
        if [row["index"] for row in rows] != [str(k) for k, _, _ in expected]:
            raise Failure("rows are missing", f"{len(rows)} rows of {len(expected)}")
        wrong = []
        for row, (k, _, inputs) in zip(rows, expected):
            complaint = self.complaint(row, inputs)
            if complaint:
                wrong.append((k, complaint))
        self._fail_if(wrong)

    def check_truth(self, report):
        """The count of wrong references that --truth reports, if all truths are determined."""
        said = report.get("truth")
        if not said or self.scene.pairs or len(self.graph.parts) > 1 or not self.has_references:
            return
        pairs = [(self.truth(inputs), self.recomputed(inputs))
                 for _, _, inputs in comparisons(self.scene, self.graph)]
        if said["not_checked"]["undetermined"] or any(None in pair for pair in pairs):
            return
        defined = [pair for pair in pairs if pair[0] != "unordered"]
        expected = len(defined), sum(truth != computed for truth, computed in defined)
        found = said["reference_alone_checked"], said["reference_alone_wrong"]
        if found != expected:
            raise Failure("truths differ",
                          f"references checked and wrong: {found}, expected {expected}")

    def check_reports(self, rows, report):
        """Pairwise engines: the pairs whose verdict is among engine.report, once each."""
        kept = self.scene.get("engine", "report", ["less", "equal", "unordered"]) + ["undecided"]
        listed = collections.defaultdict(list)
        for row in rows:
            listed[int(row["i"]), int(row["j"])].append(row)
        wrong, least, most = [], 0, 0
        for k, pair, inputs in comparisons(self.scene, self.graph):
            found = listed.pop(pair, [])
            self.outcome.comparisons += not found
            possible = {self.truth(inputs), self.recomputed(inputs)}
            least += possible <= set(kept)
            most += bool(possible & set(kept)) or None in possible
            if self.scene.get("engine", "report_as") == "count":
                continue
            if len(found) > 1:
                wrong.append((k, f"pair {pair} is reported {len(found)} times"))
            elif found:
                complaint = self.complaint(found[0], inputs)
                if not complaint and found[0]["verdict"] not in kept:
                    complaint = f'{found[0]["verdict"]} is reported'
                if complaint:
                    wrong.append((k, f"pair {pair}: {complaint}"))
            elif self.certified and None not in possible and possible <= set(kept):
                wrong.append((k, f"pair {pair}, {possible}, is not reported"))
        wrong += [(0, f"pair {pair} does not exist") for pair in listed]
        if self.certified and self.has_references:
            reported = report["engine"]["reported"]
            if not least <= reported <= most:
                wrong.append((0, f"{reported} pairs are counted, {least} to {most} expected"))
        self._fail_if(wrong)

    def check_chains(self, rows):
        """Each row's chain of contests, the winner meeting the next candidate.

        In an engine its own verdicts say who wins. For streams the reference's verdicts do.
        """
        wrong, best = [], 0
        contests = len(self.scene.others) - 1
        if len(rows) != contests * len(self.scene.rows):
            raise Failure("rows are missing", f"{len(rows)} rows")
        for k, row in enumerate(rows):
            number, j = k // contests, k % contests + 1
            best = 0 if j == 1 else best
            if (int(row["row"]), int(row["i"]), int(row["j"])) != (number, best, j):
                raise Failure("contests differ", f"{row}, expected {number}: {best} and {j}", [k])
            inputs = contest(self.scene, self.graph, number, best, j)
            complaint = self.complaint(row, inputs)
            if complaint:
                wrong.append((k, complaint))
            is_engine = self.scene.engine == "arg_min"
            verdict = row["verdict"] if is_engine else self.recomputed(inputs)
            best = j if verdict == "greater" else best
        self._fail_if(wrong)

    def complaint(self, row, inputs):
        """Words for the fault of a verdict; empty if it is right or cannot be checked."""
        self.outcome.comparisons += 1
        said = row["verdict"]
        if said == "undecided":
            return "undecided in spite of a reference" if self.has_references else ""
        if row["recomputed"] == "1":
            self.outcome.recomputed += 1
            expected = self.recomputed(inputs)
            if expected is None:
                self.outcome.unchecked += 1
                return ""
            if said == expected or (self.has_second_tier and said == self.truth(inputs)):
                return ""
            return f"{said} is recomputed, {expected} is right in the reference format"
        if not self.certified:
            self.outcome.unchecked += 1
            return ""
        truth = self.truth(inputs)
        if truth is None:
            self.outcome.unchecked += 1
            return ""
        return "" if said == truth else f"{said} is decided by a lane, {truth} is true"

    def _fail_if(self, wrong):
        if wrong:
            lines = [f"comparison {k}: {complaint}" for k, complaint in wrong[:3]]
            by_lane = any("by a lane" in complaint for _, complaint in wrong)
            way = "wrong verdicts of lanes" if by_lane else "wrong verdicts"
            raise Failure(way, f"{len(wrong)} of {self.outcome.comparisons}\n" + "\n".join(lines),
                          [k for k, _ in wrong])
