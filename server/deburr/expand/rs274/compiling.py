"""What lines are compiled to: each becomes a closure that runs it and gives the next row. Knows no loop that calls them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.expand.job import EXACT
from deburr.expand.numbers import written
from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.chains import DECIMALS
from deburr.expand.rs274.copying import without_number
from deburr.expand.rs274.flow import Flow
from deburr.expand.rs274.lines import Line, Piece, text_of
from deburr.expand.rs274.saved import SAVES, saving
from deburr.expand.rs274.shapes import CONTOURED, is_plain
from deburr.expand.rs274.source import Source
from deburr.expand.rs274.template import Templates
from deburr.expand.rs274.turning import GEOMETRY
from deburr.expand.rs274.unit import COPIED, END, PAUSED, Op, Unit
from deburr.fault import Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.rs274.copying import Stretch
    from deburr.expand.rs274.run import Run
    from deburr_grammar.line import LineNode

_MANY = 16
"""Lines that are compiled before others have their turn."""


class Compiler:
    """Compiles the lines of one run, each when it is first met."""

    stretch: Stretch
    """What `COPIED` stands for: lines to copy as they are."""

    def __init__(self, run: Run) -> None:
        self._run = run
        run.job.parts.append(self)
        self.state = run.state
        self.flow = Flow(run, self)
        self._templates = Templates(run, self)
        self._lines = 0
        """Lines that were compiled since the run was last left."""
        self.next = 0
        """The row at which it then goes on."""
        self.watch = True
        """Whether anything may ask for position or modes, so that they are followed."""
        self.percent = False
        """Whether the sign that frames the program was met."""
        self.computed = False
        """Whether a line with a computed M code was met."""
        decimals = run.job.inputs.decimals
        self._decimals = self.coordinates = DECIMALS if decimals is None else decimals
        """Decimals of values, and of those that say where a move leads."""
        self._minus_zero = self._decimals >= EXACT

    def compiled(self, unit: Unit, row: int) -> Op:
        """A line, or the stretch that starts there."""
        if row in unit.faulty:
            self._run.reached.execute(unit, row)
        self._lines += 1
        if self._lines > _MANY:
            self._lines, self.next = 0, row
            return _paused
        stretch = unit.stretches.at(row)
        if stretch is not None:
            self.stretch = stretch
            return _copied
        shared = unit.stretches.shared(row)
        op = self._templates.op(unit, row, *shared) if shared else self._compile(unit, row)
        if unit.met[row] or not shared:
            unit.code[row] = op
        unit.met[row] = True
        return op

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
        emit, state, watch = self._run.out.emit, self.state, self.watch
        maybe = line.deleted and self._run.job.inputs.block_delete is None
        letters, texts = [word.letter for word in line.words], self.texts(line, pieces)

        def put_down(values: list[float]) -> None:
            (text,) = texts(values)
            if watch:
                state.machine.block(letters, values, maybe)
            if text.strip():
                emit(text, unit, row, state.frame)

        return put_down

    def texts(self, line: Line, *forms: list[Piece]) -> Callable[[list[float]], list[str]]:
        """What writes forms of one line with the values of its words; the first has all words that say where it leads."""
        state, comment, sets = self.state, line.comment, bool(line.settings)
        minus_zero, letters = self._minus_zero, [word.letter for word in line.words]
        decimals = self._decimals if GEOMETRY.isdisjoint(letters) else self.coordinates
        rounded = [at for at in forms[0] if isinstance(at, int) and at >= 0 and letters[at] in AXES]
        chained, chains = self.watch and bool(rounded) and decimals < EXACT, state.machine.chains

        def written_down(values: list[float]) -> list[str]:
            said = chains.rounded(letters, values, rounded) if chained and state.contour is None else values
            texts = [text_of(pieces, said, comment, decimals, minus_zero) for pieces in forms]
            return [text.rstrip(" \t") for text in texts] if sets else texts

        return written_down

    def undecided(self, unit: Unit, row: int, node: LineNode) -> Halt:
        """The end of a run that hangs on the operator's switch."""
        switch = self.state.job.inputs.ways.switch
        message = (
            f"whether this line runs is decided at the machine, and the lines behind it depend on it; say {switch}"
        )
        return self.state.fault("block-delete-state", unit.file, row, Span(0, len(node.text.rstrip())), message)

    def _compile(self, unit: Unit, row: int) -> Op:
        node = unit.document.node(row)
        if node.problems:
            problem = node.problems[0]
            message = f"`{node.text[problem.start : problem.end]}` cannot be read here; the control stops"
            raise self.state.fault(problem.kind, unit.file, row, Span(problem.start, problem.end), message)
        if node.reading.start is None:
            return lambda: END
        kinds = node.kinds
        if is_plain(node.shape, node.reading) and not self.watch:
            return self._plain(unit, row, node)
        if "PERCENT" in kinds:
            return self._percent_line(unit, row, node)
        if "o_line" in kinds:
            return self._run.reached.guarded(unit, row, self.flow.compiled(unit, row, node))
        return self._block(unit, row, node)

    def _plain(self, unit: Unit, row: int, node: LineNode) -> Op:
        """A line that is copied: nothing in it is to be calculated, and nobody asks for modes."""
        text = node.text
        if "line_number" in node.kinds and not self._run.job.inputs.keep_n:
            text = without_number(text)
            if not text.strip():
                return lambda: row + 1
        emit, state, behind = self._run.out.emit, self.state, row + 1

        def copied() -> int:
            emit(text, unit, row, state.frame)
            return behind

        return copied

    def _percent_line(self, unit: Unit, row: int, node: LineNode) -> Op:
        """The first frames the program, the second ends it."""

        def sign() -> int:
            self._run.job.emit(node.text, unit.file, row, self.state.frame)
            first, self.percent = not self.percent, True
            return row + 1 if first else END

        return sign

    def _block(self, unit: Unit, row: int, node: LineNode) -> Op:
        line = Line(self.state, Source(unit.file, row, node.text), node)
        return self._with_codes(unit, row, node, line) if line.computed else self._words(unit, row, node, line)

    def _with_codes(self, unit: Unit, row: int, node: LineNode, line: Line) -> Op:
        """A line with computed M codes is compiled once for each that ends the program, leads elsewhere, or saves modes."""
        self.computed = True
        found: dict[tuple[int, ...], Op] = {}
        codes = [line.values.integer(line.words[at].part) for at in line.computed]

        def executed() -> int:
            said = tuple(code() for code in codes)
            if said not in found:
                found[said] = self._words(unit, row, node, line.with_codes(said))
            return found[said]()

        return executed

    def _words(self, unit: Unit, row: int, node: LineNode, line: Line) -> Op:
        codes = line.codes()
        delete = self._run.job.inputs.block_delete if line.deleted else False
        if delete is True:
            return lambda: row + 1
        if delete is None and (line.settings or not codes.isdisjoint(("M98", "M99", *SAVES))):
            raise self.undecided(unit, row, node)
        if "M98" in codes:
            return self.flow.calls.numbered_call(unit, row, line)
        if not codes.isdisjoint(CONTOURED) and any(word.letter == "Q" for word in line.words):
            return self.flow.calls.contour(unit, row, line)
        pieces = line.pieces()
        if not pieces and not line.words:
            return self._settings_alone(unit, row, line)
        if delete is None:
            pieces.insert(0, "/")
        ends = not codes.isdisjoint(("M2", "M30", "M99")) and delete is False
        behind = END if ends else row + 1
        if codes.isdisjoint(SAVES):
            executed = self.written(unit, row, line, pieces, behind)
        else:
            executed = saving(self._run, self, unit, row, line, behind)
        if ends:
            executed = self._framed(executed)
        return self.flow.calls.numbered_end(unit, row, line, executed) if "M99" in codes else executed

    def _framed(self, end: Op) -> Op:
        """The end of a program in percent signs: the second one stays behind it."""

        def ended() -> int:
            behind = end()
            for sign in self._run.main.signs[1:] if self.percent and behind == END else ():
                self._run.job.emit(self._run.main.document.line(sign), self._run.main.file, sign, None)
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
            self._run.out.emit(f"#{at}={value}", self._run.unit, source.row, self.state.frame)
        self.state.machine.kept.clear()


def _paused() -> int:
    """Leave the run for a moment: many lines were compiled, which takes much longer than to run them."""
    return PAUSED


def _copied() -> int:
    return COPIED
