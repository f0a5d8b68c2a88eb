"""RS274 programs run to flat G-code (spec/rs274.md §7): the loop that calls compiled lines. Values, lines, flow and the machine have files of their own."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from deburr.expand.job import EXACT
from deburr.expand.numbers import written
from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.chains import DECIMALS
from deburr.expand.rs274.copying import without_number
from deburr.expand.rs274.files import first_values
from deburr.expand.rs274.flow import Flow
from deburr.expand.rs274.following import follow
from deburr.expand.rs274.judge import Judge
from deburr.expand.rs274.lines import Line, Piece, text_of
from deburr.expand.rs274.machine import Machine
from deburr.expand.rs274.parts import last_values
from deburr.expand.rs274.saved import SAVES, saving
from deburr.expand.rs274.shapes import CONTOURED, is_plain, needs_run
from deburr.expand.rs274.source import Source
from deburr.expand.rs274.state import State
from deburr.expand.rs274.template import Templates
from deburr.expand.rs274.turning import GEOMETRY, turns_by_radius
from deburr.expand.rs274.unit import COPIED, ELSEWHERE, END, PAUSED, Op, Unit
from deburr.expand.rs274.values import name_of
from deburr.fault import Entered, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.fault import Frame
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_WATCHED = re.compile(
    r"#[ \t]*(?:5|#|\[)|[mM][ \t]*0*[ \t]*(?:7[ \t]*[03]|9[ \t]*8)|[gG][ \t]*0*[ \t]*9[ \t]*1(?![ \t]*[.0-9])|[gG][ \t]*[#\[]"
)
"""What can read the position or bring modes back, moves in steps, or calls who knows what."""
_UNSURE = re.compile(r"(?m)^[ \t]*/|\(not_a_subfile\)")
"""What may be passed over at the machine, or is no program of its own."""
_ENDS = (2, 30, 98, 99)
"""M codes that end a program, or lead where it may end."""
_GLOBAL = re.compile(r"#[ \t]*(<[ \t]*_[^<>\n]*>)")
_MANY = 16
"""Lines that are compiled before others have their turn."""


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
    """One run: the lines of its files as closures, and the loop that calls them."""

    def __init__(self, job: Job) -> None:
        self.job = job
        job.where = self._where
        machine = Machine(job)
        self.state = State(job, machine)
        machine.state = self.state
        first_values(self.state)
        machine.started()
        self._flow = Flow(self)
        self._templates = Templates(self)
        self._percent = False
        self._lines = self._next = 0
        """Lines that were compiled since the run was last left, and the row at which it then goes on."""
        self._computed = False
        """Whether a line with a computed M code was met."""
        self._may_have_ended = False
        """Whether such a code was one of those that end a program, or lead into another."""
        self._judge: Judge | None = None
        decimals = job.inputs.decimals
        self._decimals = self._coordinates = DECIMALS if decimals is None else decimals
        self._minus_zero = self._decimals >= EXACT

    def all(self, unit: Unit) -> Iterator[None]:
        """From the first line to the end."""
        self.main = self.unit = unit
        self.row = 0
        self._watch = self._is_watched(unit)
        if worth_running(unit.document):
            self._judge = Judge(self.job)
            if self.job.inputs.decimals is None and (yield from turns_by_radius(unit, self._flow.calls.load)):
                self._coordinates = EXACT
        row, left, pace = 0, 0, self.job.pace
        try:
            while row != END:
                if row == ELSEWHERE:
                    unit, row = self.unit, self.row
                code, last = unit.code, len(unit.code)
                steps = left = self.job.slice(unit.file, min(row, last - 1), self.state.frame)
                while left and row >= 0:
                    if row >= last:
                        self._endless(unit)
                        row = END
                        break
                    left -= 1
                    row = (code[row] or self._compiled(unit, row))()
                if row == PAUSED:
                    row, left = self._next, left + 1
                    yield
                elif row == COPIED:
                    row, left = self._copied(unit, left + 1)
                self.job.steps -= left
                pace -= steps - left
                if pace <= 0:
                    pace = self.job.pace
                    if self._judge is not None:
                        self._judge.settle()
                    yield
        except Halt:
            # A line that was written before may be wrong, too.
            self._finish()
            raise
        self._finish()

    def _endless(self, unit: Unit) -> None:
        """Stop behind the last line where a check could not know that a computed M code does not end the program."""
        text = unit.document.text
        if not self._computed or self._may_have_ended or self._percent or unit is not self.main or _UNSURE.search(text):
            return
        row = text.rstrip().count("\n")
        message = "the program ends without M2, M30 or `%`: no computed M code was one; the control stops here"
        raise self.state.fault("program-end-missing", unit.file, row, Span(0, 0), message)

    def _copied(self, unit: Unit, left: int) -> tuple[int, int]:
        """Copy lines of the stretch that was found, as many as may be run; where the run goes on, and how many may still be run."""
        stretch = self._stretch
        part = stretch.part(0, left) if len(stretch.lines) > left else stretch
        texts, rows, shapes = part.bare()
        if self._watch:
            follow(self.state.machine, part.lines, part.shapes)
        frame = self.state.frame
        if self.state.contour is not None:
            self.state.contour += ((text, unit.file, row, frame) for text, row in zip(texts, rows))
        else:
            if self.job.inputs.keep_n:
                texts, rows, shapes = part.lines, range(part.first, part.first + len(part.lines)), part.shapes
            self.job.copy(texts, unit.file, rows, frame)
            if self._judge is not None:
                self._judge.copied(texts, shapes, unit, rows, frame)
        return part.first + len(part.lines), left - len(part.lines)

    def emit(self, text: str, file: str, row: int, frame: Frame | None, does: Sequence[str] | None = None) -> None:
        """A flat line: to where they go, or to the contour that is being gathered. ``does``: the lines that do the same, if it does not say that itself."""
        if self.state.contour is not None:
            self.state.contour.append((text, file, row, frame))
            return
        self.job.emit(text, file, row, frame)
        if self._judge is None:
            return
        if does is None:
            self._judge.add(text, self.unit, row, frame)
        else:
            self._judge.heed(does, self.unit, row, frame)

    def written(self, unit: Unit, row: int, line: Line, pieces: list[Piece], behind: int) -> Op:
        """A line that is calculated, set and written."""
        read, write = self.read(line), self.write(unit, row, line, pieces)

        def executed() -> int:
            write(read())
            return behind

        return executed

    def read(self, line: Line) -> Callable[[], list[float]]:
        """What calculates the words of a line and then sets its parameters."""
        settings, gets, kept = line.settings, [word.get for word in line.words], self.state.machine.kept
        if not settings:
            return lambda: [get() for get in gets]

        def calculated() -> list[float]:
            puts = [(target(), get()) for target, get in settings]
            values = [get() for get in gets]
            for put, value in puts:
                put(value)
            if kept:
                self._keep(line.source)
            return values

        return calculated

    def write(self, unit: Unit, row: int, line: Line, pieces: list[Piece]) -> Callable[[list[float]], None]:
        """What writes a line with the values of its words, and moves the machine."""
        emit, file, state, watch = self.emit, unit.file, self.state, self._watch
        comment, sets = line.comment, bool(line.settings)
        maybe = line.deleted and self.job.inputs.block_delete is None
        computed = [at for at, word in enumerate(line.words) if word.letter == "M" and not word.code]
        self._computed |= bool(computed)
        minus_zero, letters = self._minus_zero, [word.letter for word in line.words]
        decimals = self._decimals if GEOMETRY.isdisjoint(letters) else self._coordinates
        rounded = [at for at in pieces if isinstance(at, int) and at >= 0 and letters[at] in AXES]
        chained, chains = watch and bool(rounded) and decimals < EXACT, state.machine.chains

        def put_down(values: list[float]) -> None:
            for at in computed:
                self._may_have_ended |= round(values[at]) in _ENDS
            said = chains.rounded(letters, values, rounded) if chained and state.contour is None else values
            text = text_of(pieces, said, comment, decimals, minus_zero)
            if watch:
                state.machine.block(letters, values, maybe)
            if text.strip():
                emit(text.rstrip(" \t") if sets else text, file, row, state.frame)

        return put_down

    def undecided(self, unit: Unit, row: int, node: LineNode) -> Halt:
        """The end of a run that hangs on the operator's switch."""
        message = "whether this line runs is decided at the machine, and the lines behind it depend on it; say --block-delete on or off"
        return self.state.fault("block-delete-state", unit.file, row, Span(0, len(node.text.rstrip())), message)

    def _finish(self) -> None:
        if self._judge is not None:
            self._judge.finish()

    def _is_watched(self, unit: Unit) -> bool:
        """Whether anything may ask for the position or for modes: only then they are followed."""
        text, named = unit.document.text, self.state.machine.named
        if _WATCHED.search(text) or any(named(name_of(said)) for said in set(_GLOBAL.findall(text))):
            return True
        # A file that is called may ask as well.
        return any(label not in unit.subs or self._flow.calls.load(label) is not None for label in unit.called)

    def _where(self) -> str:
        """The innermost loop and what it depends on, in the user's words."""
        loops, unit = self.state.loops, self.unit
        if not loops:
            return ""
        row, frame = loops[-1].first, self.state.frame
        line = unit.document.line(row).strip()
        passes = f" in pass {frame.number:,}" if frame is not None and frame.kind is Entered.LOOP else ""
        return f"`{line}` of line {row + 1}{passes}{last_values(self.state, unit, row)}"

    def _compiled(self, unit: Unit, row: int) -> Op:
        self._lines += 1
        if self._lines > _MANY:
            self._lines, self._next = 0, row
            return _paused
        stretch = unit.stretches.at(row)
        if stretch is not None:
            self._stretch = stretch
            return _copied
        shared = unit.stretches.shared(row)
        op = self._templates.op(unit, row, *shared) if shared else self._compile(unit, row)
        if unit.met[row] or not shared:
            unit.code[row] = op
        unit.met[row] = True
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
        if is_plain(node.shape, node.reading) and not self._watch:
            return self._plain(unit, row, node)
        if "PERCENT" in kinds:
            return self._percent_line(unit, row, node)
        return self._flow.compiled(unit, row, node) if "o_line" in kinds else self._block(unit, row, node)

    def _plain(self, unit: Unit, row: int, node: LineNode) -> Op:
        """A line that is copied: nothing in it is to be calculated, and nobody asks for modes."""
        text = node.text
        if "line_number" in node.kinds and not self.job.inputs.keep_n:
            text = without_number(text)
            if not text.strip():
                return lambda: row + 1
        emit, file, state, behind = self.emit, unit.file, self.state, row + 1

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
        line = Line(self.state, Source(unit.file, row, node.text), node)
        codes = line.codes()
        delete = self.job.inputs.block_delete if line.deleted else False
        if delete is True:
            return lambda: row + 1
        if delete is None and (line.settings or not codes.isdisjoint(("M98", "M99", *SAVES))):
            raise self.undecided(unit, row, node)
        if "M98" in codes:
            return self._flow.calls.numbered_call(unit, row, line)
        if not codes.isdisjoint(SAVES):
            return saving(self, unit, row, line, codes & SAVES)
        if not codes.isdisjoint(CONTOURED) and any(word.letter == "Q" for word in line.words):
            return self._flow.calls.contour(unit, row, line)
        pieces = line.pieces()
        if not pieces and not line.words:
            return self._settings_alone(unit, row, line)
        if delete is None:
            pieces.insert(0, "/")
        ends = not codes.isdisjoint(("M2", "M30", "M99")) and delete is False
        executed = self.written(unit, row, line, pieces, END if ends else row + 1)
        if ends:
            executed = self._framed(executed)
        return self._flow.calls.numbered_end(unit, row, line, executed) if "M99" in codes else executed

    def _framed(self, end: Op) -> Op:
        """The end of a program in percent signs: the second one stays behind it."""

        def ended() -> int:
            behind = end()
            for sign in self.main.signs[1:] if self._percent else ():
                self.job.emit(self.main.document.line(sign), self.main.file, sign, None)
            return behind

        return ended

    def _settings_alone(self, unit: Unit, row: int, line: Line) -> Op:
        kept, behind = self.state.machine.kept, row + 1
        if len(line.settings) == 1:
            target, get = line.settings[0]

            def one() -> int:
                put = target()
                put(get())
                if kept:
                    self._keep(line.source)
                return behind

            return one

        def several() -> int:
            puts = [(target(), get()) for target, get in line.settings]
            for put, value in puts:
                put(value)
            if kept:
                self._keep(line.source)
            return behind

        return several

    def _keep(self, source: Source) -> None:
        """Offsets that were set stay in the flat program: they move what follows."""
        for at in self.state.machine.kept:
            value = written(self.state.params[at], self._decimals, self._minus_zero)
            self.emit(f"#{at}={value}", source.file, source.row, self.state.frame)
        self.state.machine.kept.clear()


def _paused() -> int:
    """Leave the run for a moment: many lines were compiled, which takes much longer than to run them."""
    return PAUSED


def _copied() -> int:
    return COPIED
