"""Subprograms, calls and returns as closures (spec/rs274.md §6). Knows no loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.expand.rs274.parts import condition
from deburr.expand.rs274.saved import restore
from deburr.expand.rs274.state import ARGUMENTS, ENDLESS, Activation
from deburr.expand.rs274.targets import Targets
from deburr.expand.rs274.unit import ELSEWHERE, Op, Unit
from deburr.fault import Entered, Frame, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.rs274.compiling import Compiler
    from deburr.expand.rs274.lines import Line
    from deburr.expand.rs274.parts import Parts
    from deburr.expand.rs274.run import Run
    from deburr.expand.rs274.values import Get

DEEPEST = 9
"""Calls that may be active at once (spec/rs274.md §6)."""


class Calls:
    """The calls of one run."""

    def __init__(self, run: Run, compiler: Compiler) -> None:
        self._run = run
        self._compiler = compiler
        self._state = run.state
        self._targets = Targets(run)
        self.load = self._targets.load
        self._contours: dict[str, tuple[str, ...]] = {}
        """The contours that the flat program has."""

    def sub(self, unit: Unit, row: int, parts: Parts) -> Op:
        """A definition in the way is passed over and known from then on."""
        state, behind = self._state, unit.ends[row] + 1
        values = [(at, condition(state, unit, at)) for at in unit.returns[row]]
        given = bool(values) and values[-1][1] is not None and values[-1][0] == behind - 1

        def passed() -> int:
            if self._run.reached.runs_nested:
                return row + 1
            self._targets.define(unit, row, parts)
            value = 0.0
            for _, calculate in values:
                value = _calculated(calculate)
            if values:
                state.value, state.value_returned = value, float(given)
            return behind

        return passed

    def back(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`endsub` and `return`."""
        value, state = parts.value, self._state

        def returned() -> int:
            if not state.calls:
                message = f"`{parts.said}` is met in no subprogram; the control stops here"
                raise state.fault("sub-outside", unit.file, row, parts.span, message)
            state.value, state.value_returned = (value(), 1.0) if value is not None else (0.0, 0.0)
            return self._return(unit, row)

        return returned

    def call(self, unit: Unit, row: int, parts: Parts) -> Op:
        """A call with its arguments."""
        arguments, label, state, span = parts.arguments, parts.label, self._state, parts.span
        if len(arguments) > ARGUMENTS:
            message = f"{len(arguments)} arguments; a subprogram takes at most {ARGUMENTS}"
            raise state.fault("sub-arguments", unit.file, row, span, message)
        rest = [0.0] * (ARGUMENTS - len(arguments))

        def called() -> int:
            # The caller's names are gone once the call is active.
            name, values = label(), [get() for get in arguments]
            self._activate(unit, row, span, len(values))
            target, start = self._targets.found(name, unit, row, span)
            state.params[1 : ARGUMENTS + 1] = values + rest
            self._run.unit, self._run.row = target, start + 1
            return ELSEWHERE

        return called

    def numbered_call(self, unit: Unit, row: int, line: Line) -> Op:
        """`M98 Pn Ln`: a program that shares its caller's #1 to #30. Nothing else on the line is heeded."""
        span, state = Span(0, len(line.node.text.rstrip())), self._state
        program, times = self._integer(line, "P"), self._integer(line, "L")
        if not line.begins_with("M98"):
            message = "behind other words the control knows no `M98`; it must come first on its line"
            raise state.fault("m-unknown", unit.file, row, span, message)

        def called() -> int:
            if program is None:
                raise state.fault("word-missing", unit.file, row, span, "`M98` calls nothing without a P word")
            number, count = program(), times() if times is not None else 1
            if count == 0:
                message = "this calls nothing; the installed interpreter enters a call all the same and never leaves it: local names are gone from here on"
                state.warn("m98-zero", unit.file, row, span, message)
                return row + 1
            self._activate(unit, row, span, 0)
            target, start = self._targets.numbered(str(number), unit, row, span)
            state.calls[-1].again = (target, start, max(count, 1) - 1)
            self._run.unit, self._run.row = target, start + 1
            return ELSEWHERE

        return called

    def numbered_end(self, unit: Unit, row: int, line: Line, alone: Op) -> Op:
        """`M99`: back, or once more. ``alone``: what it does where nothing was called."""
        state, clear = self._state, line.begins_with("M99") and len(line.words) == 1 and not line.settings
        span = Span(0, len(line.node.text.rstrip()))

        def ended() -> int:
            if not state.calls:
                return alone()
            if state.calls[-1].again is None:
                message = "`M99` ends what `M98` calls; in what an O-word calls the control stops here: write `endsub` or `return`"
                raise state.fault("sub-outside", unit.file, row, span, message)
            if not clear:
                message = "the control stops at an `M99` that shares its line with other words"
                raise state.fault("word-conflict", unit.file, row, span, message)
            state.value = state.value_returned = 0.0
            target, start, left = state.calls[-1].again
            if left:
                state.calls[-1].again = (target, start, left - 1)
                self._bring_back(unit, row)
                state.locals, state.saved, state.returns = {}, None, False
                self._run.unit, self._run.row = target, start + 1
                return ELSEWHERE
            return self._return(unit, row)

        return ended

    def contour(self, unit: Unit, row: int, line: Line) -> Op:
        """A lathe cycle: the control needs the contour as a subprogram, so the flat program has it, too, with values in it."""
        run, state, span = self._run, self._state, Span(0, len(line.node.text.rstrip()))
        at = next(at for at, word in enumerate(line.words) if word.letter == "Q")
        compiler = self._compiler
        read, write = compiler.read(line), compiler.write(unit, row, line, line.pieces(computed="Q"))
        number = line.values.integer(line.words[at].part)

        def called() -> int:
            label = str(number())
            values = read()
            self._activate(unit, row, span, 0)
            target, start = self._targets.found(label, unit, row, span)
            state.params[1 : ARGUMENTS + 1] = [0.0] * ARGUMENTS
            state.contour = []
            state.machine.block([word.letter for word in line.words], values, False)

            def finished() -> None:
                values[at] = float(self._contour_label(label, target, start))
                write(values)

            state.calls[-1].then = finished
            run.unit, run.row = target, start + 1
            return ELSEWHERE

        return called

    def _contour_label(self, label: str, unit: Unit, row: int) -> str:
        """Define the contour that was gathered, unless the flat program has it already; the label under which it stands there."""
        lines, state, emit = self._state.contour or [], self._state, self._run.job.emit
        state.contour = None
        said = tuple(text for text, *_ in lines)
        free = label
        while self._contours.get(free, said) != said:
            free = str(int(free) + 1000)
        if free not in self._contours:
            self._contours[free] = said
            emit(f"o{free} sub", unit.file, row, state.frame)
            for text, source, at, frame in lines:
                emit(text, source.file, at, frame)
            emit(f"o{free} endsub", unit.file, unit.ends[row], state.frame)
        return free

    def _integer(self, line: Line, letter: str) -> Callable[[], int] | None:
        word = next((word for word in line.words if word.letter == letter), None)
        return line.values.integer(word.part) if word is not None else None

    def _return(self, unit: Unit, row: int) -> int:
        state = self._state
        for loop in state.loops:
            if loop.left != ENDLESS:
                state.leaks.counters[unit.file, loop.first] = loop.left
        self._bring_back(unit, row)
        call = state.calls.pop()
        if call.again is None:
            state.params[1 : ARGUMENTS + 1] = call.arguments
        state.locals = call.locals
        state.loops, state.frame, state.saved, state.returns = call.loops, call.frame, call.saved, call.returns
        self._run.unit, self._run.row = call.unit, call.row + 1
        if call.then is not None:
            call.then()
        return ELSEWHERE

    def _bring_back(self, unit: Unit, row: int) -> None:
        """The modes that `M73` saved for the end of what was called."""
        state = self._state
        if state.returns and state.saved is not None:
            restore(self._run, unit, row, state.saved)

    def _activate(self, unit: Unit, row: int, span: Span, count: int) -> None:
        state = self._state
        if len(state.calls) >= DEEPEST:
            message = f"{DEEPEST} calls are active already; the control takes no more"
            raise state.fault("sub-depth", unit.file, row, span, message)
        state.calls.append(Activation(unit, row, state))
        state.locals, state.loops, state.saved, state.returns = {}, [], None, False
        state.frame = Frame(state.frame, unit.file, row, Entered.CALL, count)


def _calculated(calculate: Get | None) -> float:
    """What `endsub` gives where it is passed over: names that do not exist there are no fault."""
    if calculate is None:
        return 0.0
    try:
        return calculate()
    except Halt as halt:
        if halt.fault.kind != "named-undefined":
            raise
        return 0.0
