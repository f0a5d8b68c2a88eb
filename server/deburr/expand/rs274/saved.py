"""Modal state that is saved and brought back: M70 to M73 (spec/oracle.md §3). Decides nothing about calls."""

from __future__ import annotations

import math
import re
from copy import copy
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand.rs274.modes import EARLY, SETTING
from deburr.expand.rs274.state import Saved
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.rs274.compiling import Compiler
    from deburr.expand.rs274.lines import Line
    from deburr.expand.rs274.run import Run
    from deburr.expand.rs274.state import State
    from deburr.expand.rs274.unit import Op, Unit

SAVES = frozenset(("M70", "M71", "M72", "M73"))
_FORGOTTEN = frozenset(("late",))
_WORD = re.compile(r"([A-Z])([0-9.]+)")
_BEFORE = {f"{letter}{tenths // 10}": taken for (letter, tenths), taken in EARLY.items()}


class Beside(NamedTuple):
    """A line with `M72` in it: all of it, only what acts before the code, with it, and both without it."""

    whole: str = "M72"
    kept: str = "M72"
    rest: str = ""
    first: str = ""


_ALONE = Beside()


def saving(run: Run, compiler: Compiler, unit: Unit, row: int, line: Line, behind: int) -> Op:
    """A line with one of these codes: some of its words act before it, the others behind it."""
    at = next(at for at, word in enumerate(line.words) if word.code in SAVES)
    code, late = line.words[at].code, _late(line)
    if code == "M72":
        return _restoring(run, compiler, unit, row, line, behind)
    state, read = run.state, compiler.read(line)
    texts = compiler.texts(line, line.pieces(computed="M"), line.pieces(SAVES))

    def executed() -> int:
        values = read()
        # The flat program has no ends of calls at which modes come back by themselves.
        text, rest = texts([*values[:at], 70.0, *values[at + 1 :]])
        _act(state, line, values, late, False)
        if code == "M71":
            state.saved = None
        else:
            state.saved = state.slot = Saved(state.machine.modes.copy())
            state.returns |= code == "M73"
        _act(state, line, values, late, True)
        run.out.ask(rest, unit, row, state.frame)
        if code != "M71":
            run.out.emit(text, unit, row, state.frame, [rest] if rest.strip() else [])
        elif rest.strip():
            run.out.emit(rest, unit, row, state.frame, [rest])
        return behind

    return executed


def _restoring(run: Run, compiler: Compiler, unit: Unit, row: int, line: Line, behind: int) -> Op:
    """`M72`. As soon as a mode comes back the control forgets the words of the line that would act behind it."""
    state, late, read = run.state, _late(line), compiler.read(line)
    said = next(word.part for word in line.words if word.code == "M72")
    span = Span(max(line.node.text.upper().rfind("M", 0, said.start), 0), said.end)
    early = _without(line, late)
    forms = (line.pieces(), early.pieces(_FORGOTTEN), line.pieces(SAVES), early.pieces(_FORGOTTEN | SAVES))
    texts = compiler.texts(line, *forms)

    def executed() -> int:
        values = read()
        if state.saved is None:
            message = "`M72` brings modes back that no `M70` or `M73` has saved at this level of calls"
            raise state.fault("restore-unsaved", unit.file, row, span, message)
        beside = Beside(*texts(values))
        run.out.ask(beside.rest, unit, row, state.frame)
        _act(state, line, values, late, False)
        saved = state.saved.modes
        if restore(run, unit, row, state.saved, beside):
            return row + 1
        if late and math.isnan(saved.feed):
            state.machine.forget()
            return row + 1
        _act(state, line, values, late, True)
        return behind

    return executed


def _late(line: Line) -> frozenset[int]:
    """The numbers of the words that act behind the code."""
    codes = line.codes()
    before = {*SETTING, *(letter for code in codes for letter in _BEFORE.get(code, ""))}
    return frozenset(
        at
        for at, word in enumerate(line.words)
        if word.letter not in before and word.code not in SAVES and word.code not in _BEFORE
    )


def _without(line: Line, left_out: frozenset[int]) -> Line:
    """The same line with words marked to be left out."""
    found = copy(line)
    found.words = [word._replace(code="late") if at in left_out else word for at, word in enumerate(line.words)]
    return found


def _act(state: State, line: Line, values: list[float], late: frozenset[int], behind: bool) -> None:
    """Let the words act that do so before the code, or behind it."""
    found = [at for at, word in enumerate(line.words) if (at in late) == behind and word.code not in SAVES]
    state.machine.block([line.words[at].letter for at in found], [values[at] for at in found], False)


def restore(run: Run, unit: Unit, row: int, saved: Saved, beside: Beside = _ALONE) -> bool:
    """Bring saved modes back, and write the line; whether any differs.

    The flat program has one place for them: where it holds others by now, words say what changes.
    """
    state, emit = run.state, run.out.emit
    if state.slot is not saved and (saved.modes.lost or state.machine.modes.lost or math.isnan(saved.modes.feed)):
        message = "which modes come back here hangs on a code of the machine's own or on a move in inverse time, of which the program tells nothing"
        raise state.fault("runtime-value", unit.file, row, Span(0, 0), message)
    if saved.modes.lost:
        emit(beside.whole, unit, row, state.frame)
        state.machine.forget()
        return True
    lines = state.machine.modes.restoring(saved.modes)
    before = beside.first if lines else beside.rest
    if state.slot is saved:
        emit(beside.kept.rstrip(" \t") if lines else beside.whole, unit, row, state.frame, [before, *lines])
    else:
        for text in [before, *lines] if before.strip() else lines:
            emit(text, unit, row, state.frame)
    for text in lines:
        words = _WORD.findall(text)
        state.machine.block([letter for letter, _ in words], [float(number) for _, number in words], False)
    if math.isnan(saved.modes.feed):
        state.machine.modes.feed = math.nan
    return bool(lines)
