"""Numerical comparisons as verified Verilog, from Python.

A scene says which comparison, the sign of f(x) - g(y), is to become hardware. This module checks
it, runs the bit-exact emulator of the hardware on NumPy arrays, simulates the hardware, counts what each precision does to
the data, finds the best plan for a device, and writes the Verilog:

    import mixcmp
    scene = mixcmp.Scene.from_file("scene.toml")
    answers = mixcmp.System(scene).emulate(rows)
    print((answers.verdict == mixcmp.Verdict.LESS).sum(), "less")

Mistakes raise ``mixcmp.Error``, whose text is the message that the program would print. Rows are
arrays of shape (comparisons, inputs), in the order of ``scene.inputs``; each number is rounded to
the reference format.
"""

from __future__ import annotations

import enum
import json
import operator
import os
from dataclasses import dataclass, fields
from typing import Any, Callable, Mapping, Optional, Sequence, Type, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._error import Error

__all__ = ["Answers", "Error", "LaneGroup", "Plan", "PlanPoint", "Profile", "Scene", "Scheme",
           "System", "Verdict", "Verification", "plan", "profile", "verify"]
__version__: str = _core.version

Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[str, float], None]


class Verdict(enum.IntEnum):
    """The order of f and g. The values are those of the two verdict bits in hardware."""

    LESS = 0
    EQUAL = 1
    GREATER = 2
    UNORDERED = 3


class Scene:
    """A validated scene: functions, inputs, formats, system and data. It never changes."""

    def __init__(self, core: _core.Scene) -> None:
        self._core = core

    @classmethod
    def from_file(cls, file: Path, settings: Sequence[str] = ()) -> Scene:
        """Reads a scene, or a plan with its scene.

        ``settings`` are texts "section.key=value" that override keys, as --set of the program.
        """
        return cls(_core.Scene.from_file(os.fspath(file), list(settings)))

    @classmethod
    def from_text(cls, toml: str, settings: Sequence[str] = (), folder: Path = ".") -> Scene:
        """Reads a scene from a text in TOML. Files that it names are seen from ``folder``."""
        return cls(_core.Scene.from_text(toml, list(settings), os.fspath(folder)))

    def with_operands(self, rows: ArrayLike) -> Scene:
        """The same scene with these comparisons as its data, in place of what [data] names."""
        return Scene(self._core.with_operands(self._rows(rows)))

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def inputs(self) -> list[str]:
        """The names of the inputs, in the order of the columns of rows."""
        return self._core.inputs

    @property
    def f(self) -> str:
        """f as written; of several parts all, separated by semicolons."""
        return self._core.f

    @property
    def g(self) -> str:
        return self._core.g

    @property
    def reference_format(self) -> str:
        """The format of references, such as "s53e8"."""
        return self._core.reference_format

    @property
    def reduced_format(self) -> str:
        """The format of lanes: "s17e8", "q13", "block13" or "auto"."""
        return self._core.reduced_format

    @property
    def notes(self) -> list[str]:
        """Remarks, such as on constants that the reference format rounds."""
        return self._core.notes

    @property
    def comparison_count(self) -> int:
        """How many comparisons the data make; 0 without data."""
        return self._core.comparison_count

    def operands(self, first: int = 0, count: Optional[int] = None) -> NDArray[np.float64]:
        """The rows of ``count`` comparisons of the data from number ``first`` on; all by default.

        Numbers of a reference format beyond double that a double does not hold are an Error.
        """
        begin = _natural("first", first)
        rest = max(self.comparison_count - begin, 0)
        return self._core.operands(begin, rest if count is None else _natural("count", count))

    def true_verdicts(self, rows: ArrayLike) -> NDArray[np.int8]:
        """The order of the real numbers f and g of each row, as values of Verdict.

        It is -1 where intervals of the highest precision do not tell.
        """
        return self._core.true_verdicts(self._rows(rows))

    def check(self) -> Mapping[str, Any]:
        """What ``mixcmp check --json`` says of the scene, but for what generate would write."""
        return json.loads(self._core.summary_json())

    def summary(self) -> str:
        """What ``mixcmp check`` says of the scene, as text."""
        return self._core.summary()

    def _rows(self, rows: ArrayLike) -> NDArray[np.float64]:
        return _as_rows(rows, len(self.inputs))

    def __repr__(self) -> str:
        return f"<mixcmp.Scene {self.name}: {self.f} against {self.g}>"


def _mistake(field: str, message: str, received: str, accepted: str) -> Error:
    text = f"{field}: {message}: received {received}; accepted {accepted}"
    return Error(text, field=field, message=message, received=received, accepted=accepted)


def _natural(name: str, value: int, most: int = 2**64 - 1) -> int:
    """The value, which must be an integer from 0 to ``most``."""
    number = operator.index(value)
    if 0 <= number <= most:
        return number
    raise _mistake(name, "no such number", str(number), f"0 to {most}")


def _as_doubles(rows: ArrayLike) -> NDArray[np.float64]:
    """The array in doubles; it must have real numbers. NumPy would take texts, too, and drop the
    imaginary parts of complex numbers."""
    try:
        given = np.asanyarray(rows)
        if np.ma.is_masked(given):
            raise TypeError("masked elements")
        no_numbers = (str, bytes, type(None))
        texts = given.dtype.kind == "O" and any(isinstance(x, no_numbers) for x in given.flat)
        if given.dtype.kind not in "biufO" or texts:
            raise TypeError(f"elements of type {given.dtype}")
        return np.ascontiguousarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise _mistake("rows", "no real numbers", str(error),
                       "an array of real numbers, none of them masked") from None


def _as_rows(rows: ArrayLike, width: int) -> NDArray[np.float64]:
    array = _as_doubles(rows)
    if array.ndim == 2 and array.shape[1] == width:
        return array
    raise _mistake("rows", "not the shape of rows", str(array.shape),
                   f"(comparisons, {width}), one column for each input")


@dataclass(frozen=True)
class Answers:
    """The answers of a system to rows: an array element for each."""

    verdict: NDArray[np.uint8]  #: values of Verdict; without meaning where ``undecided``
    recomputed: NDArray[np.bool_]  #: a reference gave the verdict
    undecided: NDArray[np.bool_]  #: nothing decided; only in systems without references

    @classmethod
    def _from_bits(cls, bits: NDArray[np.uint8]) -> Answers:
        return cls(bits & 3, (bits & 4) != 0, (bits & 8) != 0)


Record = TypeVar("Record")


def _copied(record: Type[Record], core: Any) -> Record:
    """A record with the attributes of the same names."""
    return record(**{each.name: getattr(core, each.name) for each in fields(record)})


@dataclass(frozen=True)
class LaneGroup:
    """Lanes of one kind."""

    format: str  #: "s17e8" or "q13"
    count: int
    latency_cycles: int
    certified: bool
    decision: str  #: when such a lane decides, in words


class System:
    """The system that ``mixcmp generate`` writes for a scene: its files, and its answers."""

    def __init__(self, scene: Scene) -> None:
        self._core = _core.System(scene._core)
        self._width = len(scene.inputs)

    @property
    def top(self) -> str:
        """The name of the top module."""
        return self._core.top

    @property
    def certified(self) -> bool:
        """Whether no lane can decide wrongly."""
        return self._core.certified

    @property
    def lane_count(self) -> int:
        return self._core.lane_count

    @property
    def reference_count(self) -> int:
        return self._core.reference_count

    @property
    def lanes(self) -> list[LaneGroup]:
        """The kinds of lanes, in the order of their group numbers."""
        return [_copied(LaneGroup, each) for each in self._core.lanes]

    @property
    def notes(self) -> list[str]:
        return self._core.notes

    def emulate(self, rows: ArrayLike, group: int = 0) -> Answers:
        """The answers of a lane of group number ``group``, bit for bit those of the hardware."""
        number = _natural("group", group)
        return Answers._from_bits(self._core.emulate(_as_rows(rows, self._width), number))

    def evaluate(self, rows: ArrayLike, group: int = 0) -> Answers:
        """The same answers by the golden model in MPFR, which shares no arithmetic with it."""
        number = _natural("group", group)
        return Answers._from_bits(self._core.evaluate(_as_rows(rows, self._width), number))

    def files(self) -> dict[str, str]:
        """The generated files by name: Verilog, signature, file list, constraint."""
        return self._core.files()

    def generate(self, folder: Path) -> None:
        """Writes the files as the whole content of ``folder``.

        An existing folder is replaced only where it is empty or holds an earlier output.
        """
        self._core.write(os.fspath(folder))

    def __repr__(self) -> str:
        return f"<mixcmp.System {self.top}>"


@dataclass(frozen=True)
class Scheme:
    """One kind of lane: its error bound, and its counts where it exists, an element a precision."""

    name: str
    certified: bool
    precision: NDArray[np.int64]
    undecided: NDArray[np.int64]  #: comparisons that a reference recomputes
    wrong: NDArray[np.int64]  #: verdicts that differ from the order of the real f and g
    wrong_by_lane: NDArray[np.int64]  #: of these, those that a lane decided


@dataclass(frozen=True)
class Profile:
    """Errors, recomputations and wrong verdicts of a scene's data at every precision.

    The arrays of relative errors have an element for each of ``precision``. They are NaN where
    nothing could be measured, or where no bound exists.
    """

    comparisons: int
    reference_wrong: int  #: wrong verdicts of the reference format alone
    undetermined: int  #: comparisons whose true verdict is not known
    precision: NDArray[np.int64]
    f_error: NDArray[np.float64]
    g_error: NDArray[np.float64]
    f_bound: NDArray[np.float64]
    g_bound: NDArray[np.float64]
    schemes: dict[str, Scheme]  #: by name: "lanes_alone", "relative", "running_4", ...


def _column(items: Sequence[Any], name: str) -> NDArray[Any]:
    return np.array([getattr(item, name) for item in items], dtype=np.int64)


def _optional_column(items: Sequence[Any], name: str) -> NDArray[np.float64]:
    values = (getattr(item, name) for item in items)
    return np.array([np.nan if value is None else value for value in values], dtype=np.float64)


def _scheme(core: Any) -> Scheme:
    names = ("precision", "undecided", "wrong", "wrong_by_lane")
    return Scheme(core.name, core.certified, *(_column(core.counts, name) for name in names))


def profile(scene: Scene, *, first_precision: Optional[int] = None,
            last_precision: Optional[int] = None, error_samples: int = 1_000_000,
            threads: int = 0, progress: Optional[Progress] = None) -> Profile:
    """Counts what lanes of each precision do with the scene's data.

    Precisions are by default all that the scene can have. ``threads``: 0 is one a processor, and
    results do not depend on it. ``error_samples``: comparisons that relative errors are measured
    on; 0 measures none, and leaves out lanes with a profiled bound. ``progress`` is called with a
    step's name and a share, 0 to 1.
    """
    core = _core.profile(scene._core, first_precision, last_precision,
                         _natural("error_samples", error_samples),
                         _natural("threads", threads, 2**32 - 1), progress)
    return Profile(comparisons=core.comparisons, reference_wrong=core.reference_wrong,
                   undetermined=core.undetermined, precision=_column(core.errors, "precision"),
                   f_error=_optional_column(core.errors, "f"),
                   g_error=_optional_column(core.errors, "g"),
                   f_bound=_optional_column(core.errors, "f_bound"),
                   g_bound=_optional_column(core.errors, "g_bound"),
                   schemes={each.name: _scheme(each) for each in core.schemes})


@dataclass(frozen=True)
class PlanPoint:
    """The best plan at one precision."""

    precision: int
    lanes: int  #: p_L; 0: nothing fits
    references: int  #: p_H
    clock_mhz: float
    recomputation_rate: float
    throughput_per_s: float
    kinds: str  #: "95 x s12e8 exact relative embedded"; where nothing fits, why


@dataclass(frozen=True)
class Plan:
    """The plans of a scene on its device."""

    best: Optional[PlanPoint]  #: None: no plan fits the device
    points: list[PlanPoint]  #: by precision
    baseline_per_s: float  #: of the device filled with references alone
    notes: list[str]
    text: str  #: what ``mixcmp optimise`` prints
    toml: str  #: a plan file; empty where no plan fits, and for a scene from a text


def _plan(core: Any) -> Plan:
    return Plan(best=None if core.best is None else _copied(PlanPoint, core.best),
                points=[_copied(PlanPoint, each) for each in core.points],
                baseline_per_s=core.baseline_per_s, notes=core.notes, text=core.text,
                toml=core.toml)


def plan(scene: Scene, *, table: Optional[Path] = None, first_precision: Optional[int] = None,
         last_precision: Optional[int] = None, lane_mhz: Optional[float] = None,
         reference_mhz: Optional[float] = None, plan_file: Optional[Path] = None,
         progress: Optional[Progress] = None) -> Plan:
    """Finds L, p_L, p_H and the kinds of lanes with the highest throughput on the scene's device.

    ``table`` holds areas and clocks, made by ``mixcmp characterise``; by default it is the one
    beside the scene. ``best`` of the result is None where no plan fits. ``toml`` is the text of a
    plan file; where it is to be written to any place but plan.toml beside the scene, that place is
    ``plan_file``. Clocks that are given replace the table's.
    """
    return _plan(_core.plan(scene._core, os.fspath(table or ""), first_precision, last_precision,
                            lane_mhz, reference_mhz, os.fspath(plan_file or ""), progress))


@dataclass(frozen=True)
class Verification:
    """The findings of a simulation."""

    passed: bool  #: each result came back once, right, and no stream broke its contract
    comparisons: int  #: results compared with the model
    recomputations: int
    undecided: int
    mismatches: int  #: results that differ from the model's
    violations: int  #: of the streams' contract
    not_done: list[str]  #: parts beside the verdicts that failed, with reasons
    text: str  #: the output of ``mixcmp verify``
    report: Mapping[str, Any]  #: its output with --json


def _choice(name: str, choices: Any, word: str) -> Any:
    """The member of an enumeration of the core that this word names."""
    members = choices.__members__
    if word in members:
        return members[word]
    raise _mistake(name, "no such choice", repr(word), ", ".join(members))


def verify(scene: Scene, *, simulator: str = "verilator", traffic: str = "full_rate",
           truth: str = "off", first: Optional[int] = None, sample: Optional[int] = None,
           only: Optional[int] = None, seed: int = 1, resets: int = 0, jobs: int = 0,
           find_counterexample: bool = True, work: Optional[Path] = None,
           progress: Optional[Callable[[str], None]] = None) -> Verification:
    """Simulates the scene's system on the scene's data, and compares each result with the model.

        scene = mixcmp.Scene.from_file("scene.toml")
        run = mixcmp.verify(scene, first=1000, work="simulation")
        print(run.comparisons, "comparisons,", run.mismatches, "mismatches")
        if not run.passed:
            print(run.text)

    ``simulator`` is "verilator" or, for small systems, "icarus"; ``traffic`` is "full_rate" or
    "stressed", with random gaps and backpressure; ``truth`` says which verdicts are also compared
    with exact arithmetic: "off", "recomputed" or "all". ``first``, ``sample`` and ``only`` select
    comparisons: the first N, N spread over all, or number N; at most one of them is given. ``jobs``
    simulators run side by side, 0: one a processor. ``work`` is the folder for Verilog, builds and
    logs, by default TOP_simulation. ``progress`` is called with a line on the current action.

    It is an Error if the scene has no data or if the simulator is not installed; then
    ``error.missing_tool`` is True. Wrong results are no Error: see ``passed``.
    """
    numbers = {name: None if value is None else _natural(name, value)
               for name, value in (("first", first), ("sample", sample), ("only", only))}
    core = _core.verify(scene._core, _choice("simulator", _core.Simulator, simulator),
                        _choice("traffic", _core.Traffic, traffic),
                        _choice("truth", _core.Truth, truth), *numbers.values(),
                        _natural("seed", seed), _natural("resets", resets, 1_000_000),
                        _natural("jobs", jobs, 1024), find_counterexample, os.fspath(work or ""),
                        progress)
    names = [each.name for each in fields(Verification) if each.name != "report"]
    return Verification(report=json.loads(core.json),
                        **{name: getattr(core, name) for name in names})
