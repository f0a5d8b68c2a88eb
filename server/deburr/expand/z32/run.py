"""Z32 programs run to flat G-code (spec/z32.md §6): the loop that calls compiled lines. Values, blocks, fields and flow have files of their own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import shown
from deburr.expand.z32.blocks import Block, copied, optional, undecided
from deburr.expand.z32.endless import goes_round
from deburr.expand.z32.fields import advanced
from deburr.expand.z32.flow import Flow
from deburr.expand.z32.form import faults, refuse
from deburr.expand.z32.plain import plain_of
from deburr.expand.z32.setup import first_values
from deburr.expand.z32.state import ELSEWHERE, END, Loop, Place, State
from deburr.expand.z32.unit import Op, Unit
from deburr.expand.z32.values import Values
from deburr.fault import Entered, Fault, Frame, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_CALCULATES = frozenset(("advanced", "angle", "vector", "alias_name"))
_SILENT = frozenset(("PERCENT", "section", "config"))


def run(job: Job) -> Iterator[None]:
    """Run the job's programs, one after the other; each starts anew."""
    for program in job.programs:
        unit = Unit(program.file, program.document)
        found = list[Fault]()
        for fault in faults(job, unit):
            if fault is None:
                yield
            else:
                found.append(fault)
        refuse(job, found)
        yield from Run(job, unit).all()


def worth_running(document: Document) -> bool:
    """Whether a run can find anything: where nothing is calculated, jumped to or called, the check has seen it all."""
    for piece in document.pieces():
        for reading, _, shapes in piece.read():
            if reading.start is not None and any(
                not _CALCULATES.isdisjoint(shape.facts(reading).kinds) for shape in set(shapes)
            ):
                return True
    return False


class Run:
    """One run: the lines of its files as closures, and the loop that calls them."""

    def __init__(self, job: Job, unit: Unit) -> None:
        self._job = job
        job.where = self._where
        job.parts += (self, unit, unit.code)
        self._state = State(job, unit)
        self._flow = Flow(self._state)
        self._keep_n = job.inputs.keep_n
        self._reads = worth_running(unit.document)
        """Whether anything that is stored may be read."""
        first_values(self._state)

    def all(self) -> Iterator[None]:
        """From the first line to the end."""
        yield from self._state.program.unit.placing()
        state, job, row = self._state, self._job, self._state.row
        while row != END:
            if row == ELSEWHERE:
                row = state.row
            unit, _, last = state.program
            code = unit.code
            if row >= last:
                row = self._flow.run_off()
                continue
            left = self._slice(unit, row)
            while left and 0 <= row < last:
                left -= 1
                row = (code[row] or self._compiled(unit, row))()
            job.steps -= left
            if not left:
                yield
        self._flow.close()

    def _slice(self, unit: Unit, row: int) -> int:
        """How many lines may be run before the next pause. Where that is none, a loop that does nothing is called what it is."""
        job, state = self._job, self._state
        try:
            return job.slice(unit.file, row, state.frame)
        except Halt:
            found = goes_round(state, row, self._step)
            if found is None:
                raise
            job.cut = False
            raise self._endless(*found[1:]) from None

    def _step(self, row: int) -> int:
        """Run one line of the program that is under way."""
        unit, _, last = self._state.program
        return (unit.code[row] or self._compiled(unit, row))() if row < last else self._flow.run_off()

    def _endless(self, unit: Unit, row: int, loop: Loop | None, frame: Frame | None) -> Halt:
        back = unit.jumps_back[loop.first] if loop is not None else row
        start = f"from line {loop.first + 1} " if loop is not None and loop.first != back else ""
        said = unit.document.line(back).strip()
        values = self._last_values(unit, back)
        message = f"the loop {start}to `{said}` never ends{values}: all values come back to what they were, and nothing is output"
        return Halt(Fault("limit", unit.file, back, Span(0, 0), message, frame, self._state.unsure))

    def _compiled(self, unit: Unit, row: int) -> Op:
        """A line that is not kept yet. Most lines run once, so one is kept when it runs again."""
        if self._job.held:
            self._job.held.come(self._job, unit.file, row, self._state.frame)
        node = unit.document.node(row)
        op = self._flow.around(unit, row, self._compile(unit, row, node))
        if unit.ran[row]:
            unit.code[row] = op
        unit.ran[row] = 1
        return op

    def _compile(self, unit: Unit, row: int, node: LineNode) -> Op:
        behind, kinds = row + 1, node.kinds
        if node.reading.start is None or not node.text.strip() or not _SILENT.isdisjoint(kinds):
            return lambda: behind
        if node.shape.facts(node.reading).problems:
            problem = node.problems[0]
            place = Place(unit.file, row, Span(problem.start, problem.end))
            message = f"`{node.text[problem.start : problem.end]}` cannot be read here; the control stops"
            raise self._state.fault(problem.kind, place, message)
        found = plain_of(node)
        if found is not None and (read := found.read(node.text, self._keep_n, self._reads)) is not None:
            return copied(self._state, unit, row, *read)
        if "advanced" not in kinds:
            returns = next((word for word in node.find("g_word") if word.children[0].kind == "G26"), None)
            return Block(self._state, unit, row, node).op(self._flow.back(unit, row, returns))
        passed = optional(self._state, node)
        if passed is None:
            raise undecided(self._state, unit, row, node.text)
        return (lambda: behind) if passed else advanced(self._flow, unit, row, node)

    def _where(self) -> str:
        """The innermost loop and what it depends on, or the jump or call that led here, in the user's words."""
        loop, frame, unit = self._state.loop, self._state.frame, self._state.program.unit
        if frame is None:
            return ""
        if loop is None or frame.kind is not Entered.LOOP:
            jumped = frame.kind is Entered.JUMP or not self._state.calls
            said = unit.document.line(frame.row).strip() if jumped else self._state.calls[-1].said
            return f"what `{said}` of line {frame.row + 1} {'jumps to' if jumped else 'calls'}"
        row = unit.jumps_back[loop.first]
        text = unit.document.line(row).strip()
        return f"pass {frame.number:,} of the loop from line {loop.first + 1} to `{text}` of line {row + 1}{self._last_values(unit, row)}"

    def _last_values(self, unit: Unit, row: int) -> str:
        """The values in the conditions of a line that jumps back."""
        node = unit.document.node(row)
        values, said = Values(self._state, unit.file, row, node.text), dict[str, float]()
        for comparison in node.find("comparison"):
            for part in (comparison.children[0], comparison.children[-1]):
                try:
                    said[values.said(part)] = values.value(part)()
                except Halt:
                    continue
        known = [f"`{name}` = {shown(value)}" for name, value in said.items() if not name.replace(".", "").isdigit()]
        return f" with {' and '.join(known)}" if known else ""
