"""RS274 programs run to flat G-code (spec/rs274.md §7): the loop that calls compiled lines. Values, lines, flow and the machine have files of their own."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.expand.job import EXACT
from deburr.expand.numbers import written
from deburr.expand.rs274.files import first_values
from deburr.expand.rs274.flow import ELSEWHERE, END, Flow
from deburr.expand.rs274.lines import DECIMALS, Line, Piece, text_of
from deburr.expand.rs274.machine import Machine
from deburr.expand.rs274.state import State
from deburr.expand.rs274.unit import Op, Unit
from deburr.expand.rs274.values import Values
from deburr.fault import Entered, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_NUMBERED = re.compile(r"[ \t]*[nN][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?")
_WATCHED = re.compile(r"#[ \t]*(?:5|#|\[|<[ \t]*_)")
_RUNS = frozenset(("param", "setting", "group", "function", "atan", "exists", "CALL", "active"))
_NOT_PLAIN = _RUNS | {"o_line", "PERCENT", "DELETE", "NUMBER_USED", "NAME_USED"}
_FLOW_CODES = frozenset(("M2", "M30", "M98", "M99", "M73"))


def run(job: Job) -> Iterator[None]:
    """Run the job's programs, one after the other as one text would be."""
    for program in job.programs:
        yield from Run(job).all(Unit(program.file, program.document))


def worth_running(document: Document) -> bool:
    """Whether a run can find anything: without parameters, expressions and calls there is nothing that a check has not seen."""
    for piece in document.pieces():
        for reading, _, shapes in piece.read():
            if reading.start is not None and any(not _RUNS.isdisjoint(s.facts(reading).kinds) for s in set(shapes)):
                return True
    return False


class Run:
    """One run: the lines of its files as closures, and the loop that calls them."""

    def __init__(self, job: Job) -> None:
        self.job = job
        machine = Machine(job)
        self.state = State(job, machine)
        machine.state = self.state
        first_values(self.state)
        machine.started()
        self._flow = Flow(self)
        self._percent = False
        decimals = job.inputs.decimals
        self._decimals = DECIMALS if decimals is None else decimals
        self._minus_zero = self._decimals >= EXACT

    def all(self, unit: Unit) -> Iterator[None]:
        """From the first line to the end."""
        self.main = self.unit = unit
        self.row = 0
        self._watch = _WATCHED.search(unit.document.text) is not None
        row = ELSEWHERE
        while row != END:
            if row == ELSEWHERE:
                unit, row = self.unit, self.row
            code, last = unit.code, len(unit.code)
            left = self.job.slice(unit.file, min(row, last - 1), self.state.frame, self._where(unit))
            while left and row >= 0:
                if row >= last:
                    row = END
                    break
                left -= 1
                row = (code[row] or self._compiled(unit, row))()
            self.job.steps -= left
            if not left:
                yield

    def _where(self, unit: Unit) -> str:
        """The innermost loop and what it depends on, in the user's words."""
        loops = self.state.loops
        if not loops:
            return ""
        row, frame = loops[-1].first, self.state.frame
        line = unit.document.line(row).strip()
        passes = f" in pass {frame.number}" if frame is not None and frame.kind is Entered.LOOP else ""
        return f"`{line}` of line {row + 1}{passes}{self._last_values(unit, row)}"

    def _last_values(self, unit: Unit, row: int) -> str:
        node = unit.document.node(row)
        values = Values(self.state, unit.file, row, node.text)
        said = []
        for param in node.find("param"):
            try:
                said.append(f"`{values.said(param)}` = {values.value(param)():g}")
            except Halt:
                continue
        return f" with {', '.join(said)}" if said else ""

    def _compiled(self, unit: Unit, row: int) -> Op:
        op = unit.code[row] = self._compile(unit, row)
        return op

    def _compile(self, unit: Unit, row: int) -> Op:
        node = unit.document.node(row)
        if node.problems:
            problem = node.problems[0]
            message = f"`{node.text[problem.start : problem.end]}` cannot be read here; the control stops"
            raise self.state.fault(problem.kind, unit.file, row, Span(problem.start, problem.end), message)
        if node.reading.start is None:
            return lambda: END
        kinds = node.kinds
        if not node.text.strip() or (kinds.isdisjoint(_NOT_PLAIN) and not self._watch):
            return self._plain(unit, row, node)
        if "PERCENT" in kinds:
            return self._percent_line(unit, row, node)
        return self._flow.compiled(unit, row, node) if "o_line" in kinds else self._block(unit, row, node)

    def _plain(self, unit: Unit, row: int, node: LineNode) -> Op:
        """A line that is copied: nothing in it is to be calculated, and nobody asks for modes."""
        flow = node.shape.memo.get("rs274 flow")
        if flow is None:
            flow = node.shape.memo["rs274 flow"] = not _FLOW_CODES.isdisjoint(Line(self.state, "", 0, node).codes())
        if flow:
            return self._block(unit, row, node)
        text = node.text
        if "line_number" in node.kinds and not self.job.inputs.keep_n:
            match = _NUMBERED.match(text)
            text = text[match.end() :] if match is not None else text
            if not text.strip():
                return lambda: row + 1
        emit, file, state, behind = self.job.emit, unit.file, self.state, row + 1

        def copied() -> int:
            emit(text, file, row, state.frame)
            return behind

        return copied

    def _percent_line(self, unit: Unit, row: int, node: LineNode) -> Op:
        """The first frames the program, the second ends it."""

        def sign() -> int:
            self.job.emit(node.text, unit.file, row, self.state.frame)
            first, self._percent = not self._percent, True
            return row + 1 if first else END

        return sign

    def _block(self, unit: Unit, row: int, node: LineNode) -> Op:
        line = Line(self.state, unit.file, row, node)
        codes = line.codes()
        delete = self.job.inputs.block_delete if line.deleted else False
        if delete is True:
            return lambda: row + 1
        if delete is None and (line.settings or not codes.isdisjoint(("M98", "M99", "M73"))):
            raise self.undecided(unit, row, node)
        if "M98" in codes:
            return self._flow.numbered_call(unit, row, line)
        if "M99" in codes and self.state.calls:
            return self._flow.numbered_end(unit, row, line)
        restores = "M73" in codes and bool(self.state.calls)
        pieces = line.pieces(frozenset(("M73",)) if restores else frozenset(), self.job.inputs.keep_n, "M70")
        if not pieces and not line.words:
            return self._settings_alone(unit, row, line)
        if delete is None:
            pieces.insert(0, "/")
        ends = not codes.isdisjoint(("M2", "M30", "M99")) and delete is False
        executed = self.written(unit, row, line, pieces, END if ends else row + 1, restores)
        return self._framed(executed) if ends else executed

    def _framed(self, end: Op) -> Op:
        """The end of a program in percent signs: the second one stays behind it."""

        def ended() -> int:
            behind = end()
            sign = self.main.closing_sign if self._percent else None
            if sign is not None:
                self.job.emit(self.main.document.line(sign), self.main.file, sign, None)
            return behind

        return ended

    def written(self, unit: Unit, row: int, line: Line, pieces: list[Piece], behind: int, restores: bool = False) -> Op:
        """A line that is calculated, set and written. ``restores``: it said M73."""
        emit, file, state, watch = self.job.emit, unit.file, self.state, self._watch
        kept = state.machine.kept
        settings, gets, comment = line.settings, [word.get for word in line.words], line.comment
        decimals, minus_zero, letters = self._decimals, self._minus_zero, [word.letter for word in line.words]

        def executed() -> int:
            puts = [(target(), get()) for target, get in settings]
            values = [get() for get in gets]
            for put, value in puts:
                put(value)
            if kept:
                self._keep(unit, row)
            text = text_of(pieces, values, comment, decimals, minus_zero)
            if watch:
                state.machine.block(letters, values, line.deleted)
            if restores:
                state.restores = True
            if text.strip():
                emit(text.rstrip(" \t") if settings else text, file, row, state.frame)
            return behind

        return executed

    def _settings_alone(self, unit: Unit, row: int, line: Line) -> Op:
        kept, behind = self.state.machine.kept, row + 1
        if len(line.settings) == 1:
            target, get = line.settings[0]

            def one() -> int:
                put = target()
                put(get())
                if kept:
                    self._keep(unit, row)
                return behind

            return one

        def several() -> int:
            puts = [(target(), get()) for target, get in line.settings]
            for put, value in puts:
                put(value)
            if kept:
                self._keep(unit, row)
            return behind

        return several

    def _keep(self, unit: Unit, row: int) -> None:
        """Offsets that were set stay in the flat program: they move what follows."""
        for at in self.state.machine.kept:
            value = written(self.state.params[at], self._decimals, self._minus_zero)
            self.job.emit(f"#{at}={value}", unit.file, row, self.state.frame)
        self.state.machine.kept.clear()

    def undecided(self, unit: Unit, row: int, node: LineNode) -> Halt:
        """The end of a run that hangs on the operator's switch."""
        message = "whether this line runs is decided at the machine, and the lines behind it depend on it; say --block-delete on or off"
        return self.state.fault("block-delete-state", unit.file, row, Span(0, len(node.text.rstrip())), message)
