"""What stops a run that only heeds what it reaches (spec/rs274.md §6): lines that are executed, what the control reads of those that it passes over, ends that it looks for. Executes nothing."""

from __future__ import annotations

import re
from bisect import bisect_right
from typing import TYPE_CHECKING

from deburr.expand.held import errors, fault_of
from deburr.fault import Fault, Halt
from deburr.steps import done
from deburr_grammar.dialects.rs274.outline import label_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Generator

    from deburr.expand.job import Job
    from deburr.expand.rs274.state import State
    from deburr.expand.rs274.unit import Op, Unit

_END = "program-end-missing"
_JUDGED = frozenset(("sub-file", "sub-unknown", "sub-before-definition", "sub-redefined"))
"""What depends on where calls lead, which the run finds out: its line is no fault by itself."""
_READ = frozenset(("comment-nested", "comment-unclosed", "line-too-long"))
"""What the control sees of a line before it asks whether the line is to be run."""
_UNREAD = frozenset(("o-condition", "o-extra-text", "bad-character"))
"""What may be wrong behind the command of an O-word that it passes over."""
_PAIRED = frozenset(("o-mismatch", "o-unopened"))
"""What a check says of ends that it pairs by their depth; the control goes by labels alone."""
_OF_LABELS = _PAIRED | {"o-label-duplicate"}
_O_LINE = re.compile(r"[ \t]*/?[ \t]*(?:[nN][ \t0-9.]*)?[oO]")
_NUMBERED = re.compile(r"[ \t]*/?[ \t]*[nN]")


class Reached:
    """The faults of one run's files, where they count."""

    def __init__(self, job: Job, state: State) -> None:
        self._job = job
        self._state = state
        self.active = job.inputs.reached_only
        self._known: set[Unit] = set()

    def hold(self, unit: Unit, called: bool) -> Generator[None, None, None]:
        """Hold what a check calls wrong in a file. What is wrong with a program is none with a file that is called."""
        if not self.active or unit in self._known:
            return
        self._known.add(unit)
        for finding in (yield from errors(self._job, unit.file, unit.document)):
            fault = fault_of(finding)
            if not (called and (fault.kind == _END or self._frames(unit, fault))):
                self._job.held.hold(fault)
        rows = self._job.held.in_file(unit.file)
        unit.faulty = frozenset(
            row
            for row, found in rows.items()
            if any(each.kind in _JUDGED or self._counts(unit, each) for each in found)
        )
        unit.seen = sorted(row for row in rows if self._read(unit, row) is not None)

    def enter(self, unit: Unit) -> None:
        """Hold the same of a file that is called."""
        done(self.hold(unit, called=True))

    def execute(self, unit: Unit, row: int) -> None:
        """Stop at a line that is wrong."""
        held, found = self._job.held, self._job.held.in_file(unit.file)[row]
        held.taken([fault for fault in found if fault.kind in _JUDGED])
        if self._deleted(unit, row):
            return
        counted = [fault for fault in found if self._counts(unit, fault)]
        if counted := [fault for fault in counted if fault.kind != "sub-nested" or not self.runs_nested]:
            raise held.stop(self._job, counted, self._state.frame)

    @property
    def runs_nested(self) -> bool:
        """Whether a `sub` on the way is nothing, and its `endsub` returns: so it is while another one runs."""
        return self.active and bool(self._state.calls)

    def guarded(self, unit: Unit, row: int, op: Op) -> Op:
        """A line that goes on elsewhere: what it passes over is read."""
        if not self.active:
            return op

        def executed() -> int:
            to = op()
            if to > row + 1:
                self.pass_to(unit, row, to)
            return to

        return executed

    def pass_to(self, unit: Unit, row: int, to: int) -> None:
        """Go from a row to one further down."""
        seen = unit.seen
        for at in seen[bisect_right(seen, row) :]:
            if at >= to:
                break
            if (fault := self._read(unit, at, row)) is not None:
                raise self._job.held.stop(self._job, [fault], self._state.frame)
        if to > len(unit.code):
            raise self._unclosed(unit, unit.blocks[row].open if row in unit.blocks else row)

    def ended(self, unit: Unit) -> None:
        """Stop behind the last line of a file."""
        if not self.active:
            return
        starts = [row for row, end in unit.ends.items() if end == len(unit.code)]
        if self._state.calls and starts:
            raise self._unclosed(unit, max(starts))
        found = (fault for faults in self._job.held.in_file(unit.file).values() for fault in faults)
        if missing := [fault for fault in found if fault.kind == _END or self._frames(unit, fault)]:
            raise self._job.held.stop(self._job, missing[:1], self._state.frame)

    def _unclosed(self, unit: Unit, row: int) -> Halt:
        """The end of a run that looks for an end that is not there."""
        found = self._job.held.in_file(unit.file).get(row, ())
        if missing := [fault for fault in found if fault.kind == "o-unclosed"]:
            return self._job.held.stop(self._job, missing, self._state.frame)
        text = unit.document.line(row)
        span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
        return Halt(Fault("o-unclosed", unit.file, row, span, f"`{text.strip()}` is never closed", self._state.frame))

    def _counts(self, unit: Unit, fault: Fault) -> bool:
        """Whether a fault stops the control at its own line."""
        if fault.kind in _PAIRED and fault.line in unit.blocks:
            return False
        return fault.kind not in (_END, "o-unclosed", *_JUDGED) and not self._frames(unit, fault)

    def _frames(self, unit: Unit, fault: Fault) -> bool:
        """Whether it is that the percent sign which starts a program has no other one."""
        first = unit.signs[:1]
        return fault.kind == "percent" and unit.is_framed and first == (fault.line,)

    def _deleted(self, unit: Unit, row: int) -> bool:
        """Whether the operator's switch passes over a line."""
        text = unit.document.line(row).lstrip(" \t")
        if self._job.inputs.block_delete is not True or not text.startswith("/"):
            return False
        return self._read(unit, row) is None

    def _read(self, unit: Unit, row: int, passing: int | None = None) -> Fault | None:
        """What the control minds of a line that it passes over; ``passing``: the row of what it does not run."""
        text = unit.document.line(row)
        starts_o, number = _O_LINE.match(text) is not None, _NUMBERED.match(text)
        for fault in self._job.held.in_file(unit.file).get(row, ()):
            at_number = number is not None and number.end() - 1 == fault.span.start
            if fault.kind in _READ or (fault.kind == "line-number" and at_number):
                return fault
            if starts_o and self._minds(unit, fault, passing):
                return fault
        return None

    def _minds(self, unit: Unit, fault: Fault, passing: int | None) -> bool:
        """Whether an O-word that is passed over stops the control: it reads labels and commands, and looks for those of the block that it passes."""
        if fault.kind == "o-unclosed" or fault.kind in _PAIRED and fault.line in unit.blocks:
            return False
        in_sub = passing is not None and passing in unit.ends
        if fault.kind in ("o-unknown", "sub-nested"):
            return passing is None or in_sub == (fault.kind == "sub-nested")
        node = unit.document.node(fault.line)
        label = next((each for each in node.find("label")), None)
        if node.problems:
            return fault.kind not in _UNREAD
        if label is None or label.start <= fault.span.start < label.end and fault.span.end <= label.end:
            return True
        own = unit.blocks.get(passing) if passing is not None and not in_sub else None
        said = label_of(node.text, label)
        return passing is None or (
            own is not None and fault.kind in _OF_LABELS and said is not None and said == own.label
        )
