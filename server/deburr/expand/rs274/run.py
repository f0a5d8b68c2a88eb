"""RS274 programs run to flat G-code (spec/rs274.md §7): the loop that calls compiled lines. Compiles none, writes none."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from typing import TYPE_CHECKING

from deburr.expand.job import EXACT
from deburr.expand.rs274.compiling import Compiler
from deburr.expand.rs274.files import first_values, unread
from deburr.expand.rs274.following import follow
from deburr.expand.rs274.machine import Machine
from deburr.expand.rs274.output import Output
from deburr.expand.rs274.parts import last_values
from deburr.expand.rs274.reached import Reached
from deburr.expand.rs274.shapes import needs_run
from deburr.expand.rs274.state import State
from deburr.expand.rs274.turning import turns_by_radius
from deburr.expand.rs274.unit import COPIED, ELSEWHERE, END, PAUSED, Unit
from deburr.fault import Entered, Halt
from deburr_grammar.dialects.rs274.names import name_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document

_WATCHED = re.compile(
    r"#[ \t]*(?:5|#|\[)|[mM][ \t]*0*[ \t]*(?:7[ \t]*[03]|9[ \t]*8)|[mM][^a-zA-Z0-9]*[#\[]|[gG][ \t]*0*[ \t]*9[ \t]*1(?![ \t]*[.0-9])|[gG][ \t]*[#\[]"
)
"""What can read the position or bring modes back, moves in steps, or calls who knows what."""
_UNSURE = re.compile(r"(?m)^[ \t]*/|\(not_a_subfile\)")
"""What may be passed over at the machine, or is no program of its own."""
_GLOBAL = re.compile(r"#[ \t]*(<[ \t]*_[^<>\n]*>)")


def run(job: Job) -> Iterator[None]:
    """Run the job's programs, one after the other as one text would be."""
    for program in job.programs:
        yield from Run(job).all((yield from Unit.making(program.file, program.document)))


def worth_running(document: Document) -> bool:
    """Whether a run can find anything: without parameters, expressions, calls and saved modes there is nothing that a check has not seen."""
    for piece in document.pieces():
        for reading, _, shapes in piece.read():
            if reading.start is not None and any(needs_run(shape, reading) for shape in set(shapes)):
                return True
    return False


class Run:
    """One run: where it is, and the loop that calls its lines."""

    def __init__(self, job: Job) -> None:
        self.job = job
        job.where = self._where
        machine = Machine(job)
        self.state = State(job, machine)
        machine.state = self.state
        job.parts += (self, self.state, machine)
        self.reached = Reached(job, self.state)
        first_values(self.state)
        machine.started()
        self.out = Output(job, self.state)
        self._compiler = Compiler(self)

    def all(self, unit: Unit) -> Iterator[None]:
        """From the first line to the end."""
        self.main = self.unit = unit
        self.job.parts += (unit, unit.code)
        self.row = 0
        yield from self.reached.hold(unit, called=False)
        yield from self._prepare(unit)
        row, left, pace, compiled = 0, 0, self.job.pace, self._compiler.compiled
        try:
            while row != END:
                if row == ELSEWHERE:
                    unit, row = self.unit, self.row
                code, last = unit.code, len(unit.code)
                steps = left = self.job.slice(unit.file, min(row, last - 1), self.state.frame)
                while left and row >= 0:
                    if row >= last:
                        self.reached.ended(unit)
                        self._endless(unit)
                        row = END
                        break
                    left -= 1
                    row = (code[row] or compiled(unit, row))()
                if row == PAUSED:
                    row, left = self._compiler.next, left + 1
                    yield
                elif row == COPIED:
                    row, left = self._copied(unit, left + 1)
                self.job.steps -= left
                pace -= steps - left
                if pace <= 0:
                    pace = self.job.pace
                    self.out.settle()
                    yield
        except Halt:
            # A line that was written before may be wrong, too.
            self.out.finish()
            raise
        self.out.finish()

    def _prepare(self, unit: Unit) -> Iterator[None]:
        """What the text of a program decides of how it is run."""
        compiler = self._compiler
        yield from unit.calling()
        compiler.watch = yield from self._is_watched(unit)
        self.job.unread += unread(self.job, unit, compiler.flow.calls.load)
        if worth_running(unit.document) or self.reached.active:
            self.out.judged()
            if self.job.inputs.decimals is None and (yield from turns_by_radius(unit, compiler.flow.calls.load)):
                compiler.coordinates = EXACT

    def _copied(self, unit: Unit, left: int) -> tuple[int, int]:
        """Copy lines of the stretch that was found, as many as may be run; where the run goes on, and how many may still be run."""
        stretch = self._compiler.stretch
        part = stretch.part(0, left) if len(stretch.lines) > left else stretch
        if self._compiler.watch:
            follow(self.state.machine, part.lines, part.shapes)
        self.out.copy(part, unit)
        return part.first + len(part.lines), left - len(part.lines)

    def _endless(self, unit: Unit) -> None:
        """Stop behind the last line where a check could not know that the run comes by no end: a branch or a sub that has one did not run, a computed M code was another."""
        text = unit.document.text
        if self._compiler.percent or unit is not self.main or _UNSURE.search(text) or not unit.does_something:
            return
        row = text.rstrip().count("\n")
        met = "no computed M code was one" if self._compiler.computed else "this run met none"
        message = f"the program ends without M2, M30 or `%`: {met}; the control stops here"
        raise self.state.fault("program-end-missing", unit.file, row, Span(0, 0), message)

    def _is_watched(self, unit: Unit) -> Generator[None, None, bool]:
        """Whether anything may ask for the position or for modes: only then they are followed."""
        text, named = unit.document.text, self.state.machine.named
        if _WATCHED.search(text) or any(named(name_of(said)) for said in set(_GLOBAL.findall(text))):
            return True
        # A file that is called may ask as well.
        for label in unit.called:
            if label not in unit.subs or self._compiler.flow.calls.load(label) is not None:
                return True
            yield
        return False

    def _where(self) -> str:
        """The innermost loop and what it depends on, in the user's words."""
        loops, unit = self.state.loops, self.unit
        if not loops:
            return ""
        row, frame = loops[-1].first, self.state.frame
        line = unit.document.line(row).strip()
        passes = f" in pass {frame.number:,}" if frame is not None and frame.kind is Entered.LOOP else ""
        return f"`{line}` of line {row + 1}{passes}{last_values(self.state, unit, row)}"
