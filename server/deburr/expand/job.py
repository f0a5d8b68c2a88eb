"""What an interpreter works in: programs, files, inputs, budget, and where its lines go. Knows no language, opens no file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from deburr.expand.held import Held
from deburr.fault import Fault, Frame, Halt
from deburr.inputs import Inputs
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.source_map import SourceMap
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.document import Document

SLICE = 500
"""Executed steps between two moments at which a run can be left."""
EXACT = 400
"""So many decimals hold the shortest text of every number that there is."""


class Program(NamedTuple):
    """A program to run: its path and its document."""

    file: str
    document: Document


class Budget(NamedTuple):
    """How much a run may do: executed steps and emitted lines; 0 is no limit."""

    steps: int = 1_000_000
    blocks: int = 1_000_000


class Sink(Protocol):
    """Where flat lines go."""

    def line(self, text: str) -> None:
        """One line, without its ending."""

    def keep(self, count: int) -> None:
        """Only so many of the lines were right: forget the others."""


class Kept:
    """Flat lines in memory."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.line = self.lines.append

    def keep(self, count: int) -> None:
        """Only the first so many."""
        del self.lines[count:]


class Job:
    """One run. An interpreter is `run(job)`, a generator that yields every ``pace`` steps; it ends by itself, or with a `Halt`."""

    def __init__(
        self,
        programs: Sequence[Program],
        ruleset: RuleSet,
        host: Host,
        sink: Sink,
        inputs: Inputs | None = None,
        budget: Budget | None = None,
        source_map: SourceMap | None = None,
        pace: int = SLICE,
    ) -> None:
        self.programs = tuple(programs)
        self.ruleset = ruleset
        self.host = host
        self.inputs = inputs or Inputs()
        self.budget = budget or Budget()
        self.faults: list[Fault] = []
        """What the run met, in order; each place and kind once."""
        self.emitted = 0
        self.steps = 0
        self.cut = False
        """Whether the budget ended the run."""
        self.halted = False
        """Whether the last fault ended the run."""
        self.where: Callable[[], str] = str
        """What the run is in, in words: a loop and its variable's last values; nothing outside of loops."""
        self.parts: list[object] = []
        """What the run is made of that refers to itself: lists, and objects with attributes."""
        self.unread: list[str] = []
        """What there is to say of values that were given by name for the run, and that nothing in its texts reads."""
        self.held = Held()
        """What is wrong with the texts and was not met yet."""
        self.pace = pace
        self._sink = sink
        self._line = sink.line
        self._map = source_map
        self._met: set[tuple[str, str, int, Span]] = set()

    @property
    def settings(self) -> Mapping[str, Any]:
        """The dialect's settings."""
        return self.ruleset.settings

    def emit(self, text: str, file: str, row: int, frame: Frame | None) -> None:
        """A flat line and where it comes from (0-based row)."""
        if self.emitted == self.budget.blocks and self.emitted:
            self.cut = True
            limit = f"the flat program has more than {self.emitted:,} lines{self._inside()}; {self.inputs.ways.blocks} sets another limit"
            raise Halt(Fault("limit", file, row, Span(0, 0), limit, frame))
        self.emitted += 1
        self._line(text)
        if self._map is not None:
            self._map.add(file, row, frame)

    def copy(self, texts: Sequence[str], file: str, rows: Sequence[int], frame: Frame | None) -> None:
        """Several flat lines of one file, as by `emit`."""
        room = self.budget.blocks - self.emitted if self.budget.blocks else len(texts)
        if len(texts) > room:
            self.copy(texts[:room], file, rows[:room], frame)
            self.emit(texts[room], file, rows[room], frame)
        self.emitted += len(texts)
        for text in texts:
            self._line(text)
        if self._map is not None:
            self._map.extend(file, rows, frame)

    def keep(self, count: int) -> None:
        """Take all flat lines back but the first so many."""
        if count < self.emitted:
            self.emitted = count
            self._sink.keep(count)
            if self._map is not None:
                self._map.keep(count)

    def slice(self, file: str, row: int, frame: Frame | None) -> int:
        """How many steps may be done before the next yield."""
        left = self.budget.steps - self.steps if self.budget.steps else self.pace
        if left <= 0:
            self.cut = True
            way = self.inputs.ways.steps
            limit = f"more than {self.budget.steps:,} lines were executed{self._inside()}; {way} sets another limit"
            raise Halt(Fault("limit", file, row, Span(0, 0), limit, frame))
        found = min(self.pace, left)
        self.steps += found
        return found

    def _inside(self) -> str:
        where = self.where()
        return f", last in {where}" if where else ""

    @contextmanager
    def silent(self) -> Iterator[None]:
        """While this is open, a line that is output ends the run instead."""
        line, self._line = self._line, _unheard
        emitted = self.emitted
        try:
            yield
        finally:
            self._line, self.emitted = line, emitted

    def unusable(self, kind: str, given: str, message: str) -> Halt:
        """The end of a run before its first line: a value that was given for it, `NAME=VALUE`, cannot be used."""
        said = f"{self.inputs.ways.misgiven.format(given)}: {message}"
        return Halt(Fault(kind, self.programs[0].file, 0, Span(0, 0), said, given=given))

    def meet(self, fault: Fault) -> None:
        """Report something that does not stop the run; the same at the same place is reported once."""
        if (key := _key(fault)) not in self._met:
            self._met.add(key)
            self.faults.append(fault)

    def dissolve(self) -> None:
        """Empty what the run was made of, so that it goes at once and not with the next look for garbage, of which there are few in an editor."""
        self.where = str
        for part in self.parts:
            (part if isinstance(part, list) else vars(part)).clear()
        self.parts.clear()

    def over(self) -> None:
        """Report what is wrong with the texts and was never met. What ended the run stays the last."""
        self.faults[:0] = [fault for fault in self.held.left() if _key(fault) not in self._met]


def _key(fault: Fault) -> tuple[str, str, int, Span]:
    return fault.kind, fault.file, fault.line, fault.span


def _unheard(text: str) -> None:
    """No line may be output now."""
    raise Halt(Fault("limit", "", 0, Span(0, 0), text))
