# SPDX-License-Identifier: MIT
"""Reads, verifies, simulates, draws and tests GRAFCET charts (IEC 60848) and their plants.

    import grafverif
    file = grafverif.read("station.grafcet")
    report = file.loop().check()
    print(report)

Errors in a chart are raised as GrafverifError, with positions. Long operations release the interpreter lock and raise
KeyboardInterrupt at Ctrl-C. Durations are in seconds, as arguments and in results; arguments may also be
`datetime.timedelta`. Attributes that end in `_ms` are in milliseconds.
"""

from __future__ import annotations

import html
import importlib
import json
import os
import re
from dataclasses import dataclass, field
from datetime import timedelta
from typing import Any, Iterable, Iterator, Mapping, NamedTuple, Sequence, TypeVar, Union

from . import _core

__all__ = ["Analysis", "Automaton", "Box", "Chart", "Choice", "Diagnostic", "Drawing", "Fault", "FaultAnalysis",
           "FaultCombination", "FaultedProperty", "File", "Finding", "GrafverifError", "Loop", "Margin", "Mealy",
           "NotFoundError", "Recording", "RecordingReport", "RecordingVerdict", "Report", "SimulationError",
           "Simulation", "Step", "TestSequence", "TestStep", "Trace", "TunedProperty", "Tuning", "Verdict",
           "__version__", "parse", "read"]

__version__: str = _core.__version__

Duration = Union[float, timedelta]  #: seconds


class Diagnostic(NamedTuple):
    """A diagnostic. `line` and `column` start at 1; `column` counts bytes. Without a position, `file`, `line` and
    `column` have the value None."""

    severity: str
    code: str
    message: str
    file: str | None
    line: int | None
    column: int | None


class GrafverifError(Exception):
    """Raised if a chart or a request is invalid. The text of the exception is the message that the program prints."""

    def __init__(self, text: str, diagnostics: Iterable[tuple[Any, ...]] = ()):
        super().__init__(text)
        self.diagnostics = [Diagnostic(*each) for each in diagnostics]

    def __str__(self) -> str:
        return str(self.args[0])


class SimulationError(GrafverifError):
    """Raised if a command of a simulation cannot be executed."""


class NotFoundError(GrafverifError, KeyError):
    """Raised if a chart, closed loop or property does not exist."""


def _seconds(duration: Duration) -> float:
    return duration.total_seconds() if isinstance(duration, timedelta) else duration


def _shown_seconds(seconds: float) -> str:
    return f"{seconds:.3f}".rstrip("0").rstrip(".") + " s"


def _html_table(headings: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    def row(cells: Sequence[Any], tag: str) -> str:
        texts = ("" if cell is None else html.escape(str(cell)) for cell in cells)
        return "<tr>" + "".join(f'<{tag} style="text-align: left">{text}</{tag}>' for text in texts) + "</tr>"

    return (f"<table><thead>{row(headings, 'th')}</thead><tbody>"
            + "".join(row(each, "td") for each in rows) + "</tbody></table>")


def _dataframe(rows: list[dict[str, Any]]) -> Any:
    try:
        pandas: Any = importlib.import_module("pandas")
    except ImportError as error:
        raise ImportError(
            "tables require pandas, which is not installed; install it (Debian: python3-pandas)") from error
    return pandas.DataFrame(rows)


class _Tabular:
    def to_dataframe(self) -> Any:
        raise NotImplementedError

    def frame(self) -> Any:
        """The former name of `to_dataframe`."""
        return self.to_dataframe()


@dataclass(frozen=True)
class Drawing:
    """An SVG picture. Notebooks display it."""

    svg: str = field(repr=False)

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str | os.PathLike[str]) -> None:
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)


@dataclass(frozen=True)
class Step:
    """One row of a trace: the event and the state after it. In an untimed trace, `time` and `time_ms` count steps."""

    time: float  #: seconds
    kind: str
    component: str | None
    fired: tuple[str, ...]
    situation: tuple[str, ...]
    inputs: dict[str, bool | int]
    outputs: dict[str, bool | int]
    time_ms: int = field(repr=False, compare=False, default=0)


class Trace(_Tabular):
    """A trace of a loop or chart. If the trace is a lasso, the steps from `loop_from` on repeat forever."""

    def __init__(self, document: dict[str, Any], text: str, svg: str):
        run = document["run"]
        times = [run["moments"][each["moment"]]["time"] for each in document["steps"]]
        unit = 1000 if run["timed"] else 1
        self.steps = [Step(time / unit, each["kind"], each["component"], tuple(each["fired"]),
                           tuple(each["situation"]), each["inputs"], each["outputs"], time)
                      for each, time in zip(document["steps"], times)]
        self.loop_from: int | None = document["loop_from"]
        self.run: dict[str, Any] = run  #: all data of the trace, see docs/reference/trace-format.md
        self.drawing = Drawing(svg)  #: a timing diagram
        self._text = text

    def __len__(self) -> int:
        return len(self.steps)

    def __iter__(self) -> Iterator[Step]:
        return iter(self.steps)

    def __getitem__(self, index: int) -> Step:
        return self.steps[index]

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<Trace of {len(self.steps)} steps>"

    def _repr_svg_(self) -> str:
        return self.drawing.svg

    def _repr_html_(self) -> str:
        rows = [(each.time, each.component, " ".join(each.fired), " ".join(each.situation),
                 " ".join(name for name, value in each.outputs.items() if value)) for each in self.steps]
        return self.drawing.svg + _html_table(("time", "component", "cleared", "situation", "outputs"), rows)

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per step and one column per input and output; times are in
        seconds."""
        return _dataframe([{"time": each.time, "kind": each.kind, "component": each.component,
                        "fired": " ".join(each.fired), "situation": " ".join(each.situation), **each.inputs,
                        **each.outputs} for each in self.steps])


class Verdict:
    """The verdict on one property. It has no truth value; use `holds`, `violated` or `unknown`."""

    def __init__(self, document: dict[str, Any], report: _core.Report, index: int):
        self.name: str = document["name"]
        self.text: str | None = document["text"]  #: the sentence of the property
        self.verdict: str = document["verdict"]  #: `holds`, `violated` or `unknown`
        self.expected: str = document["expected"]
        self.declared: bool = document["declared"]
        self.reason: str | None = document["reason"]  #: the reason for an unknown verdict; otherwise None
        self.vacuous: bool = document["vacuous"]
        self.notes: list[str] = document["notes"]
        #: position of the declaration of the property, or of the loop if the property is not declared; line and column
        #: start at 1, and columns count bytes
        self.file: str | None = document["file"]
        self.line: int | None = document["line"]
        self.column: int | None = document["column"]
        self.document = document  #: the complete verdict in the format of `check --format json`
        self._report, self._index = report, index

    @property
    def holds(self) -> bool:
        return self.verdict == "holds"

    @property
    def violated(self) -> bool:
        return self.verdict == "violated"

    @property
    def unknown(self) -> bool:
        return self.verdict == "unknown"

    @property
    def as_expected(self) -> bool:
        return self.verdict == self.expected

    @property
    def trace(self) -> Trace | None:
        """The trace of the verdict: a counterexample or a witness."""
        if self.document["trace"] is None:
            return None
        return Trace(self.document["trace"], self._report.trace_text(self._index), self._report.trace_svg(self._index))

    def __bool__(self) -> bool:
        raise TypeError("a verdict has no truth value; use .holds, .violated, .unknown or .as_expected")

    def __repr__(self) -> str:
        return f"<Verdict {self.name}: {self.verdict}>"


def _write_files(folder: str, files: Iterable[tuple[str, str]]) -> None:
    """Writes files into `folder`, which is created if it does not exist."""
    for path, content in files:
        name = os.path.join(folder, path)
        os.makedirs(os.path.dirname(name), exist_ok=True)
        with open(name, "w", encoding="utf-8", newline="") as file:
            file.write(content)


class Report(_Tabular):
    """All verdicts on a loop or chart, in the order of the properties."""

    def __init__(self, core: _core.Report):
        document = json.loads(core.json())
        self.model: str = document["model"]
        self.verdicts = [Verdict(each, core, index) for index, each in enumerate(document["properties"])]
        self.errors: list[dict[str, Any]] = document.get("errors", [])  #: errors of the model itself
        #: `folder`, `certified` (names of properties) and `omitted` (properties with reasons); None without certificate
        self.certificate: dict[str, Any] | None = None
        self.document: dict[str, Any] = document
        self._core = core

    @property
    def as_expected(self) -> bool:
        """True if every verdict is as expected and the model has no model error."""
        return not self.errors and all(each.as_expected for each in self.verdicts)

    def __len__(self) -> int:
        return len(self.verdicts)

    def __iter__(self) -> Iterator[Verdict]:
        return iter(self.verdicts)

    def __getitem__(self, name: str) -> Verdict:
        return _property(self.verdicts, name)

    def __str__(self) -> str:
        return self._core.text()

    def __repr__(self) -> str:
        return f"<Report on {self.model}: {', '.join(f'{each.name} {each.verdict}' for each in self.verdicts)}>"

    def _repr_html_(self) -> str:
        rows = [(each.name, each.text, each.verdict + (", vacuously" if each.vacuous else ""), each.expected,
                 each.reason) for each in self.verdicts]
        heading = f"<p><b>{html.escape(self.model)}</b>: {'as expected' if self.as_expected else 'not as expected'}</p>"
        return heading + _html_table(("property", "sentence", "verdict", "expected", "reason"), rows)

    def to_html(self, *, date: str = "", timeout: Duration | None = None, memory: int | None = None) -> str:
        """Returns the page that `grafverif report` writes: verdicts, a player of all traces, charts, analysis,
        equations.
        `timeout` in seconds and `memory` in bytes limit the analysis of the charts. If a limit is reached, the
        page contains the results found so far."""
        return self._core.html(date, _bounds(timeout, memory))

    def save(self, path: str | os.PathLike[str], *, date: str = "", timeout: Duration | None = None,
             memory: int | None = None) -> None:
        """Writes the page of `to_html` to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.to_html(date=date, timeout=timeout, memory=memory))

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per property."""
        return _dataframe([{key: value for key, value in each.document.items() if key not in ("trace", "notes")}
                       for each in self.verdicts])


@dataclass(frozen=True)
class Finding:
    """A finding about a chart. `document` is the finding in JSON form, with its trace."""

    code: str
    level: str
    subject: str | None
    message: str
    line: int | None
    accepted: str | None
    document: dict[str, Any] = field(repr=False, compare=False)


class Analysis(_Tabular):
    """Defects and dead elements of a chart."""

    def __init__(self, text: str, document: dict[str, Any]):
        self.findings = [Finding(each["code"], each["level"], each["subject"], each["message"], each.get("line"),
                                 each["accepted"], each) for each in document["findings"]]
        self.complete: bool = document["complete"]  #: True if the analysis was completed, False if it reached a limit
        self.document = document
        self._text = text

    def __len__(self) -> int:
        return len(self.findings)

    def __iter__(self) -> Iterator[Finding]:
        return iter(self.findings)

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<Analysis: {len(self.findings)} findings>"

    def _repr_html_(self) -> str:
        return _html_table(("level", "code", "line", "message"),
                           [(each.level, each.code, each.line, each.message) for each in self.findings])

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per finding."""
        return _dataframe([{"code": each.code, "level": each.level, "subject": each.subject, "message": each.message,
                        "line": each.line, "accepted": each.accepted} for each in self.findings])


_Shown = tuple[str, str, list[tuple[str, str]]]  #: text, JSON, and the text and drawing of each trace
_Named = TypeVar("_Named", "Verdict", "TunedProperty", "FaultedProperty")


def _property(properties: Iterable[_Named], name: str) -> _Named:
    for each in properties:
        if each.name == name:
            return each
    raise NotFoundError(f"unknown property `{name}`; choose one of {', '.join(each.name for each in properties)}")


@dataclass(frozen=True)
class Box:
    """Points of a grid with the same verdict: for each constant, the first and the last value. Durations are strings
    such as `3s`."""

    constants: dict[str, tuple[int | str, int | str]]
    points: int
    verdict: str
    reason: str | None  #: the reason for an unknown verdict


@dataclass(frozen=True)
class Margin:
    """The nearest value of a constant with another verdict, while all other constants have their current values."""

    constant: str
    direction: str  #: `down` or `up`
    value: int | str
    distance: int | str
    verdict: str


class TunedProperty:
    """The verdicts on one property for all values of the constants. It has no truth value."""

    def __init__(self, document: dict[str, Any], constants: list[dict[str, Any]]):
        self._constants = constants
        self.name: str = document["name"]
        self.text: str | None = document["text"]
        self.expected: str = document["expected"]
        self.current: str = document["current"]  #: the verdict for the current values
        self.boxes = [Box({name: (low, high) for name, (low, high) in each["constants"].items()}, each["points"],
                          each["verdict"], each["reason"]) for each in document["boxes"]]
        self.margins = [Margin(each["constant"], each["direction"], each["value"], each["distance"], each["verdict"])
                        for each in document["margins"]]
        self.document = document

    def at(self, **values: int | str | timedelta) -> str:
        """The verdict at a point of the grid: `holds`, `violated` or `unknown`. `values` contains a value of each
        constant, such as `N=3, FILL="500ms"`. A duration is a str or a timedelta, and any other constant is an int."""
        constants = {each["name"]: each for each in self._constants}
        if set(values) != set(constants):
            raise NotFoundError(f"give a value of each constant: {', '.join(constants)}")

        def measure(name: str, value: Any) -> int:
            return _measure(name, value, isinstance(constants[name]["step"], str))

        point = {name: measure(name, value) for name, value in values.items()}
        on_grid = all((point[name] - measure(name, each["low"])) % measure(name, each["step"]) == 0
                      for name, each in constants.items())
        for box in self.boxes:
            if on_grid and all(measure(name, low) <= point[name] <= measure(name, high)
                               for name, (low, high) in box.constants.items()):
                return box.verdict
        raise NotFoundError("the values are not a point of the grid")

    def __bool__(self) -> bool:
        raise TypeError("the verdicts on a property have no truth value; use .at(), .boxes or .current")

    def __repr__(self) -> str:
        return f"<TunedProperty {self.name}: {', '.join(f'{each.verdict} at {each.points}' for each in self.boxes)}>"


def _milliseconds(name: str, duration: timedelta) -> int:
    count, rest = divmod(duration, timedelta(milliseconds=1))
    if rest:
        raise ValueError(f"`{name}` must be a multiple of 1 ms; got {duration}")
    return count


def _measure(name: str, value: Any, is_duration: bool) -> int:
    """Returns the value of a constant: the number, or the duration in milliseconds."""
    if not is_duration and isinstance(value, int) and not isinstance(value, bool):
        return value
    if is_duration and isinstance(value, timedelta):
        return _milliseconds(name, value)
    if is_duration and isinstance(value, str):
        match = re.fullmatch(r"([0-9]+) *(ms|s|min)", value)
        if not match:
            raise ValueError(f"`{name}` must be a duration such as '3s'; got `{value}`")
        return int(match[1]) * {"ms": 1, "s": 1000, "min": 60_000}[match[2]]
    kind = "a timedelta, or a str such as '3s'" if is_duration else "an int"
    raise TypeError(f"`{name}` must be {kind}; got {type(value).__name__}")


class Tuning(_Tabular):
    """The verdicts on the properties of a closed loop for all values of some of its constants."""

    def __init__(self, shown: _Shown):
        self._text = shown[0]
        self.document: dict[str, Any] = json.loads(shown[1])
        self.model: str = self.document["model"]
        self.points: int = self.document["points"]
        self.checks: int = self.document["checks"]  #: number of models that were checked
        constants = self.document["constants"]
        self.properties = [TunedProperty(each, constants) for each in self.document["properties"]]

    def __iter__(self) -> Iterator[TunedProperty]:
        return iter(self.properties)

    def __getitem__(self, name: str) -> TunedProperty:
        return _property(self.properties, name)

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<Tuning of {self.model}: {self.points} points, {self.checks} models checked>"

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per property and box."""
        return _dataframe([{"property": each.name, **{name: f"{low}..{high}" if low != high else low
                                                      for name, (low, high) in box.constants.items()},
                            "points": box.points, "verdict": box.verdict, "reason": box.reason}
                           for each in self.properties for box in each.boxes])


@dataclass(frozen=True)
class Fault:
    """A fault and its effects."""

    name: str
    instance: str
    component: str
    violates: tuple[str, ...]  #: properties that are violated with this fault and without other faults
    newly_true: tuple[str, ...]  #: steps and outputs that are true in some state with this fault, but never without
    never_true: tuple[str, ...]  #: steps and outputs that are never true if the fault is present from power-on
    #: True if an element of `newly_true` becomes true in every run with the fault from power-on; None if unknown
    always_shown: bool | None
    #: True if an element of `newly_true` becomes true after the fault in every run with the fault; None if unknown
    detected: bool | None
    within: float | None  #: the longest time from the fault to such an element, in seconds
    #: `property` (a declaration), `in_every_run` and `within`: a property that reveals the fault; None if there is none
    observer: dict[str, Any] | None = field(hash=False)
    decided: bool  #: False if `newly_true` and `never_true` are incomplete


@dataclass(frozen=True)
class FaultCombination:
    """A combination of faults that leads to a violation of a property, with a trace if one is given."""

    faults: tuple[str, ...]
    from_power_on: tuple[str, ...]  #: faults that are present from power-on in the run
    minimal: bool  #: False if the verdict for a subset is unknown
    #: a run that violates the property; None for `reachable`, which no single run violates, or if no trace is given
    trace: Trace | None = field(repr=False, compare=False)


class FaultedProperty:
    """The combinations of faults that lead to a violation of one property. It has no truth value. The property holds
    for all combinations of at most `order` faults only if `without_faults` is `holds`, and both `combinations` and
    `unknown` are empty."""

    def __init__(self, document: dict[str, Any], traces: Iterator[tuple[str, str]]):
        self.name: str = document["name"]
        self.text: str | None = document["text"]
        self.declared: bool = document["declared"]
        self.without_faults: str = document["without_faults"]  #: the verdict without faults
        self.combinations = [FaultCombination(
            tuple(each["faults"]), tuple(each["from_power_on"]), not each["unknown_subsets"],
            None if each["trace"] is None else Trace(each["trace"], *next(traces))) for each in document["minimal"]]
        #: combinations with an unknown verdict, and the reason
        self.unknown = [(tuple(each["faults"]), each["reason"]) for each in document["unknown"]]
        self.document = document

    def __bool__(self) -> bool:
        raise TypeError("the combinations have no truth value; use .combinations, .unknown or .without_faults")

    def __repr__(self) -> str:
        names = ", ".join(" + ".join(each.faults) for each in self.combinations) or "none"
        return f"<FaultedProperty {self.name}: {names}>"


class FaultAnalysis(_Tabular):
    """The minimal combinations of faults that lead to violations, and the effects of each fault (FMEA)."""

    def __init__(self, shown: _Shown):
        self._text = shown[0]
        self.document: dict[str, Any] = json.loads(shown[1])
        self.model: str = self.document["model"]
        self.order: int = self.document["order"]  #: maximum number of faults in a combination
        self.faults = [Fault(each["name"], each["instance"], each["component"], tuple(each["violates"]),
                             tuple(each["newly_true"]), tuple(each["never_true"]), each["always_shown"],
                             each["detected"], each["within"], each["observer"],
                             each["decided"])
                       for each in self.document["faults"]]
        traces = iter(shown[2])
        self.properties = [FaultedProperty(each, traces) for each in self.document["properties"]]
        self.errors: list[dict[str, Any]] = self.document["errors"]  #: model errors

    def __iter__(self) -> Iterator[FaultedProperty]:
        return iter(self.properties)

    def __getitem__(self, name: str) -> FaultedProperty:
        return _property(self.properties, name)

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<FaultAnalysis of {self.model}: {len(self.faults)} faults, at most {self.order} in a combination>"

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per fault (FMEA)."""
        return _dataframe([{"fault": each.name, "instance": each.instance, "component": each.component,
                            "violates": " ".join(each.violates), "newly_true": " ".join(each.newly_true),
                            "never_true": " ".join(each.never_true), "always_shown": each.always_shown,
                            "within": each.within, "observer": each.observer and each.observer["property"]}
                           for each in self.faults])


class RecordingVerdict:
    """The verdict on one chart. It has no truth value."""

    def __init__(self, document: dict[str, Any], traces: Iterator[tuple[str, str]]):
        self.chart: str = document["chart"]
        self.verdict: str = document["verdict"]  #: `conforms`, `deviates` or `unknown`
        self.reason: str | None = document["reason"]  #: the reason for an unknown verdict
        deviation = document["deviation"]
        self.time: float | None = deviation and deviation["time"]  #: time of the deviation in seconds
        self.output: str | None = deviation and deviation["output"]  #: the output that deviates
        #: for each clock of `skew`: `columns`, `bound`, and the range `low`, `high` of its offset in seconds
        self.offsets: list[dict[str, Any]] = document["offsets"]
        #: the timing that agrees with the longest part of the recording
        self.trace = Trace(deviation["trace"], *next(traces)) if deviation else None
        self.document = document

    def __bool__(self) -> bool:
        raise TypeError("a verdict has no truth value; use .verdict")

    def __repr__(self) -> str:
        return f"<RecordingVerdict {self.chart}: {self.verdict}>"


class RecordingReport:
    """The verdicts on a recording."""

    def __init__(self, shown: _Shown):
        self._text = shown[0]
        self.document: dict[str, Any] = json.loads(shown[1])
        self.samples: int = self.document["samples"]
        traces = iter(shown[2])
        self.verdicts = [RecordingVerdict(each, traces) for each in self.document["charts"]]
        self.properties: list[dict[str, Any]] = self.document["properties"]  #: recorded state properties of the loops

    def __iter__(self) -> Iterator[RecordingVerdict]:
        return iter(self.verdicts)

    def __getitem__(self, chart: str) -> RecordingVerdict:
        for each in self.verdicts:
            if each.chart == chart:
                return each
        raise NotFoundError(f"unknown chart `{chart}`; choose one of {', '.join(each.chart for each in self.verdicts)}")

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<RecordingReport: {', '.join(f'{each.chart} {each.verdict}' for each in self.verdicts)}>"


class Recording:
    """Checks samples of the inputs and outputs of a real controller against charts as they arrive, as `grafverif
    monitor` does."""

    def __init__(self, core: _core.Samples):
        self._core = core
        self._report: RecordingReport | None = None

    def add(self, time: Duration, values: Mapping[str, bool | int] | None = None, **more: bool | int) -> bool:
        """Adds a sample. `time` must not decrease. Values with the same time belong to one sample. The first sample
        contains a value of each recorded variable; later samples contain at least the values that changed. Returns
        False if the check has ended, because the verdict on each chart is final or, with `stop_early`, after the first
        deviation or violated property. Further samples are then ignored: the results for properties concern only the
        samples that were added before."""
        sample = {**(values or {}), **more}
        for name, value in sample.items():
            if not isinstance(value, int):
                raise TypeError(f"`{name}` must be a bool or an int; got {type(value).__name__}")
        fields = ", ".join(f"{json.dumps(name)}: {json.dumps(value)}" for name, value in sample.items())
        return self._core.add(f'{{"time": {_seconds(time):.6f}{", " if fields else ""}{fields}}}')

    def finish(self) -> RecordingReport:
        """The verdicts on all samples. No sample can be added afterwards."""
        if self._report is None:
            self._report = RecordingReport(self._core.finish())
        return self._report


class _Machine:
    def __init__(self, shown: tuple[str, str, str]):
        self._text, text, svg = shown
        self.document: dict[str, Any] = json.loads(text)  #: the document that the program writes with `--format json`
        self.drawing = Drawing(svg) if svg else None  #: SVG; None if the automaton or machine is too large to draw

    def __str__(self) -> str:
        return self._text

    def _repr_svg_(self) -> str | None:
        return self.drawing.svg if self.drawing else None


class Automaton(_Machine, _Tabular):
    """The location automaton of a chart: the behaviour of a controller that executes the chart, cycle by cycle."""

    @property
    def locations(self) -> list[dict[str, Any]]:
        table: list[dict[str, Any]] = self.document["location_table"]
        return table

    @property
    def evolutions(self) -> list[dict[str, Any]]:
        table: list[dict[str, Any]] = self.document["evolution_table"]
        return table

    def __repr__(self) -> str:
        return f"<Automaton of {len(self.locations)} locations, {len(self.evolutions)} evolutions>"

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per evolution."""
        return _dataframe(self.evolutions)


class Mealy(_Machine):
    """The Mealy machine of a chart."""

    def __repr__(self) -> str:
        return f"<Mealy machine {self.document['name']}>"


@dataclass(frozen=True)
class TestStep:
    """A test step: wait, apply the inputs for `cycles` scans, and compare the outputs in each scan."""

    __test__ = False  # prevents pytest from collecting this class as a test
    sequence: int
    step: int
    wait: float  #: seconds
    cycles: int
    inputs: dict[str, bool | int]
    outputs: dict[str, bool | int]
    situation: str
    wait_ms: int = field(repr=False, compare=False, default=0)


class TestSequence(_Tabular):
    """Inputs for an implementation of a chart and the expected outputs, in one or several sequences from power-on."""

    __test__ = False

    def __init__(self, document: dict[str, Any]):
        self.document = document
        self.steps = [TestStep(number, each["step"], each["wait_ms"] / 1000, each["cycles"], each["inputs"],
                               each["outputs"], each["situation"], each["wait_ms"])
                      for number, sequence in enumerate(document["sequences"], 1) for each in sequence]
        self.proven_least: bool = document["proven_least"]

    def __len__(self) -> int:
        return len(self.steps)

    def __iter__(self) -> Iterator[TestStep]:
        return iter(self.steps)

    def __repr__(self) -> str:
        return f"<TestSequence of {len(self.steps)} steps>"

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with one row per step; times are in seconds."""
        return _dataframe([{"sequence": each.sequence, "step": each.step, "wait": each.wait, "cycles": each.cycles,
                        **each.inputs, **{f"{name} (expected)": value for name, value in each.outputs.items()},
                        "situation": each.situation} for each in self.steps])


class Choice(NamedTuple):
    """An available command and its effect."""

    command: str
    words: str


class Simulation:
    """Simulation of a loop or chart with the commands of `grafverif simulate`."""

    def __init__(self, core: _core.Simulator):
        self._core = core
        if core.problem():
            raise SimulationError(core.problem())

    def do(self, *commands: str) -> Simulation:
        """Executes commands such as `START = true`, `wait 3s`, `do Gate open` or `back`, and the automatic
        moves that follow."""
        for command in commands:
            problem = self._core.execute(command)
            if problem:
                raise SimulationError(f"{command}: {problem}")
        return self

    def set(self, **inputs: bool | int) -> Simulation:
        """Sets inputs. In the simulation of a chart alone, all inputs change simultaneously."""
        words = [f"{name} = {str(value).lower()}" for name, value in inputs.items()]
        return self.do(", ".join(words)) if words else self

    def wait(self, duration: Duration | None = None) -> Simulation:
        """Lets time pass for `duration`, or by default until an automatic event occurs or a new choice becomes
        available."""
        return self.do("wait" if duration is None else f"wait {round(1000 * _seconds(duration))}ms")

    @property
    def choices(self) -> list[Choice]:
        return [Choice(*each) for each in self._core.choices()]

    @property
    def trace(self) -> Trace:
        """The trace of all rows since power-on."""
        wrong = self._core.disagreement()
        if wrong:
            raise RuntimeError(wrong)
        return Trace(json.loads(self._core.json()), self._core.text(), self._core.svg())

    @property
    def is_trial(self) -> bool:
        """True if the user forced a step, so that the following rows are not a run of the model."""
        return self._core.what_if_row() is not None

    @property
    def now(self) -> Step:
        return self.trace.steps[-1]

    def __str__(self) -> str:
        return self._core.text()

    def __repr__(self) -> str:
        now = self.now
        return f"<Simulation after {_shown_seconds(now.time)}: {', '.join(now.situation)}>"

    def _repr_html_(self) -> str:
        return self.trace._repr_html_()


def _bounds(timeout: Duration | None, memory: int | None, states: int | None = None) -> _core.Bounds:
    return _core.Bounds(timeout=None if timeout is None else _seconds(timeout), memory=memory, states=states)


class Chart:
    """A chart of a file."""

    def __init__(self, file: _core.File, name: str):
        self._file = file
        self.name = name

    def __repr__(self) -> str:
        return f"<Chart {self.name}>"

    def _repr_svg_(self) -> str:
        return self.draw().svg

    def draw(self, *, notation: str = "iec") -> Drawing:
        """Draws the chart as SVG in the notation of IEC 60848. With `notation="text"`, conditions are in the
        text language."""
        return Drawing(self._file.draw(self.name, notation))

    def check_untimed(self, *, mode: str | None = None, timeout: Duration | None = None, memory: int | None = None,
                      states: int | None = None) -> Report:
        """Checks the chart alone, with free inputs: each step must be reachable and, with stability search, the
        situation must become stable for all inputs."""
        return Report(self._file.check_chart(self.name, _core.How(mode=mode),
                                             _bounds(timeout, memory, states)))

    def analyse(self, *, mode: str | None = None, timeout: Duration | None = None,
                memory: int | None = None) -> Analysis:
        text, document = self._file.analyse(self.name, _core.How(mode=mode),
                                            _bounds(timeout, memory))
        return Analysis(text, json.loads(document))

    def automaton(self, *, mode: str | None = None, timeout: Duration | None = None, memory: int | None = None,
                  states: int | None = None) -> Automaton:
        return Automaton(self._file.automaton(self.name, _core.How(mode=mode),
                                              _bounds(timeout, memory, states)))

    def mealy(self, *, mode: str | None = None, minimise: bool = False, timeout: Duration | None = None,
              memory: int | None = None, states: int | None = None) -> Mealy:
        return Mealy(self._file.mealy(self.name, _core.How(mode=mode),
                                      _bounds(timeout, memory, states), minimise))

    def test_sequence(self, *, mode: str | None = None, cover: str = "transitions", one_cycle_each: bool = False,
                      timeout: Duration | None = None, memory: int | None = None,
                      states: int | None = None) -> TestSequence:
        """Generates a test sequence. `cover` is `transitions`, `evolutions` or `locations`."""
        return TestSequence(json.loads(self._file.test_sequence(
            self.name, _core.How(mode=mode), _bounds(timeout, memory, states), cover,
            one_cycle_each)))

    def simulate(self, *, mode: str | None = None) -> Simulation:
        return Simulation(self._file.simulate_chart(self.name, _core.How(mode=mode)))

    def run(self, commands: str | Iterable[str], *, mode: str | None = None) -> Trace:
        """Runs a script or commands of `grafverif simulate`."""
        return self.simulate(mode=mode).do(*_lines(commands)).trace

    def structured_text(self, *, mode: str | None = None, plcopen_xml: bool = False) -> str:
        """Returns the chart as a function block for a PLC (IEC 61131-3)."""
        return self._file.structured_text(self.name, _core.How(mode=mode), plcopen_xml)


class Loop:
    """A closed loop of a file: controllers and their plant."""

    def __init__(self, file: _core.File, name: str, constants: Iterable[str] = ()):
        self._file = file
        self.name = name
        self._constants = frozenset(constants)  # constants whose values were given when the file was read

    @property
    def properties(self) -> list[str]:
        return self._file.properties(self.name)

    def __repr__(self) -> str:
        return f"<Loop {self.name}>"

    def check(self, *properties: str, mode: str | None = None, grain: str | None = None,
              timeout: Duration | None = None, memory: int | None = None, states: int | None = None,
              whole: bool = False, certificate: str | os.PathLike[str] | None = None) -> Report:
        """Checks the given properties, or by default all, with the timed engine. `timeout` is in seconds and
        `memory` in bytes. If a limit is reached, the remaining verdicts are unknown. `certificate` is a folder, into
        which a certificate of the verdicts is written; the program `grafverif-certify` checks it."""
        core = self._file.check(self.name, _core.How(mode=mode, grain=grain), list(properties),
                                _bounds(timeout, memory, states), whole, False, certificate is not None)
        report = Report(core)
        if certificate is not None and core.certificate is not None:
            folder = os.fspath(certificate)
            files, certified, omitted = core.certificate
            _write_files(folder, files)
            report.certificate = {"folder": folder, "certified": certified,
                                  "omitted": [{"property": name, "reason": reason} for name, reason in omitted]}
        return report

    def check_untimed(self, *properties: str, mode: str | None = None, plant: str | None = None,
                      schedule: str | None = None, time: str | None = None, fairness: bool = False,
                      timeout: Duration | None = None, memory: int | None = None, states: int | None = None,
                      whole: bool = False) -> Report:
        """Checks the untimed model. Each verdict states its implication for the real plant."""
        how = _core.How(mode=mode, plant=plant or ("automata" if schedule or time or fairness else None),
                        schedule=schedule, time=time, fairness=fairness)
        return Report(self._file.check(self.name, how, list(properties),
                                       _bounds(timeout, memory, states), whole, True, False))

    def tune(self, over: Mapping[str, str | tuple[int | str, ...]], *properties: str, mode: str | None = None,
             grain: str | None = None, timeout: Duration | None = None, memory: int | None = None,
             every_point: bool = False) -> Tuning:
        """Decides the given properties, or by default all, for ranges of constants of the loop, as `grafverif tune`
        does. `over` contains the values of each constant: `(low, high)`, `(low, high, step)`, or text such as
        `1s..20s:500ms`. If a limit is reached, the remaining verdicts are unknown."""
        if not over:
            raise ValueError("over must contain a constant")
        for name in over:
            if name in self._constants:
                raise ValueError(f"`{name}` is in both over and constants; remove it from one of them")
        return Tuning(self._file.tune(self.name, _core.How(mode=mode, grain=grain), _ranges(over), list(properties),
                                      _bounds(timeout, memory), every_point))

    def faults(self, *properties: str, order: int = 1, mode: str | None = None, grain: str | None = None,
               timeout: Duration | None = None, memory: int | None = None) -> FaultAnalysis:
        """Finds the minimal combinations of at most `order` declared faults that lead to violations of the given
        properties, or by default of any property, as `grafverif faults` does."""
        if not 1 <= order <= _core.most_faults:
            raise ValueError(f"order must be in 1..{_core.most_faults}; got {order}")
        return FaultAnalysis(self._file.faults(self.name, _core.How(mode=mode, grain=grain), order, list(properties),
                                               _bounds(timeout, memory)))

    def simulate(self, *, mode: str | None = None, grain: str | None = None) -> Simulation:
        return Simulation(self._file.simulate_loop(self.name, _core.How(mode=mode, grain=grain)))

    def run(self, commands: str | Iterable[str], *, mode: str | None = None, grain: str | None = None) -> Trace:
        """Runs a script or commands of `grafverif simulate`."""
        return self.simulate(mode=mode, grain=grain).do(*_lines(commands)).trace

    def uppaal(self, *, mode: str | None = None, grain: str | None = None) -> str:
        """Returns the UPPAAL project with queries."""
        return self._file.uppaal(self.name, _core.How(mode=mode, grain=grain))

    def nusmv(self, *, mode: str | None = None, plant: str | None = None, schedule: str | None = None,
              time: str | None = None, fairness: bool = False) -> str:
        return self._file.nusmv(self.name, _core.How(mode=mode, plant=plant, schedule=schedule, time=time,
                                                     fairness=fairness))


def _ranges(over: Mapping[str, str | tuple[int | str, ...]]) -> list[str]:
    """Converts ranges to values of `--over`."""
    ranges = []
    for name, values in over.items():
        if not isinstance(values, str):
            if len(values) not in (2, 3):
                raise ValueError(f"`{name}` must have a range (low, high) or (low, high, step)")
            values = f"{values[0]}..{values[1]}" + (f":{values[2]}" if len(values) == 3 else "")
        ranges.append(f"{name}={values}")
    return ranges


_Thing = TypeVar("_Thing")


def _lines(commands: str | Iterable[str]) -> list[str]:
    return commands.splitlines() if isinstance(commands, str) else list(commands)


class File:
    """A file and the files that it includes."""

    def __init__(self, core: _core.File, constants: Iterable[str] = ()):
        self._core = core
        self.charts = {name: Chart(core, name) for name in core.charts()}
        self.loops = {name: Loop(core, name, constants) for name in core.loops()}
        self.warnings = [Diagnostic(*each) for each in core.warnings()]

    def chart(self, name: str | None = None) -> Chart:
        """The chart called `name`, or by default the only chart of the file."""
        return self._one(self.charts, "chart", name)

    def loop(self, name: str | None = None) -> Loop:
        """The closed loop called `name`, or by default the only closed loop of the file."""
        return self._one(self.loops, "closed loop", name)

    def recording(self, *charts: str, mode: str | None = None, jitter: Duration = 0.02,
                  skew: Mapping[str | tuple[str, ...], Duration] | None = None,
                  map: Mapping[str, str] | None = None, stop_early: bool = False) -> Recording:
        """Begins the check of a recording against the given charts, or by default all charts of the file. The recorded
        times differ from the times in the controller by at most `jitter`. `skew` maps a name in samples, or a tuple of
        names, to the maximum offset of their clock. `map` maps names in samples to names of inputs and outputs. With
        `stop_early`, the check ends at the first deviation or violated property, as `grafverif monitor` does."""
        return Recording(self._core.recording(list(charts) or list(self.charts), _core.How(mode=mode),
                                              round(1000 * _seconds(jitter)),
                                              [([names] if isinstance(names, str) else list(names),
                                                round(1_000_000 * _seconds(bound)))
                                               for names, bound in (skew or {}).items()],
                                              dict(map or {}), stop_early))

    @staticmethod
    def _one(things: dict[str, _Thing], what: str, name: str | None) -> _Thing:
        if name is not None and name in things:
            return things[name]
        if name is None and len(things) == 1:
            return next(iter(things.values()))
        if not things:
            raise NotFoundError(f"the file has no {what}")
        there = ", ".join(things)
        raise NotFoundError(f"unknown {what} `{name}`; choose one of {there}" if name is not None
                            else f"the file has several {what}s; name one of {there}")

    def __repr__(self) -> str:
        return f"<File: charts {', '.join(self.charts) or 'none'}; loops {', '.join(self.loops) or 'none'}>"


Constants = Mapping[str, Union[bool, int, str, timedelta]]


def _written(constants: Constants | None) -> dict[str, str]:
    """Converts values of constants to the text language."""
    written = {}
    for name, value in (constants or {}).items():
        if isinstance(value, timedelta):
            written[name] = f"{_milliseconds(name, value)}ms"
        elif not isinstance(value, (bool, int, str)):
            raise TypeError(f"`{name}` must be a bool, an int, a timedelta, or a str such as '3s'; "
                            f"got {type(value).__name__}")
        else:
            written[name] = str(value).lower() if isinstance(value, bool) else str(value)
    return written


def read(path: str | os.PathLike[str], *, include: Iterable[str | os.PathLike[str]] = (), lossy: bool = False,
         constants: Constants | None = None) -> File:
    """Reads a file of any supported format and its included files, which are also searched for in the folders
    `include`.

    `constants` sets constants of closed loops as `--set` does, in every loop that declares them.
    """
    core = _core.File.read(os.fspath(path), [os.fspath(each) for each in include], lossy, _written(constants))
    return File(core, constants or ())


def parse(text: str, name: str = "text", *, include: Iterable[str | os.PathLike[str]] = (), lossy: bool = False,
          constants: Constants | None = None) -> File:
    """Reads a text; `name` is its file name in errors. The other arguments are those of `read`."""
    core = _core.File.parse(text, name, [os.fspath(each) for each in include], lossy, _written(constants))
    return File(core, constants or ())
