"""Modal state that is saved and brought back: M70 to M73 (spec/oracle.md §3). Decides nothing about calls."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.expand.rs274.state import Saved
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.rs274.compiling import Compiler
    from deburr.expand.rs274.lines import Line
    from deburr.expand.rs274.run import Run
    from deburr.expand.rs274.unit import Op, Unit

SAVES = frozenset(("M70", "M71", "M72", "M73"))
_WORD = re.compile(r"([A-Z])([0-9.]+)")


def saving(run: Run, compiler: Compiler, unit: Unit, row: int, line: Line, codes: frozenset[str]) -> Op:
    """A line with one of these codes: the rest of the line first, then what the code does to the saved modes."""
    rest, state, emit = compiler.written(unit, row, line, line.pieces(SAVES), row + 1), run.state, run.out.emit
    said = next((word.part for word in line.words if word.code == "M72"), line.node.tree)
    span = Span(max(line.node.text.upper().rfind("M", 0, said.start), 0), said.end)

    def executed() -> int:
        rest()
        saved = state.saved
        if not codes.isdisjoint(("M70", "M73")):
            state.saved = state.slot = Saved(state.machine.modes.copy())
            state.returns |= "M73" in codes
            emit("M70", unit, row, state.frame, ())
        elif "M71" in codes:
            state.saved = None
        elif saved is None:
            message = "`M72` brings modes back that no `M70` or `M73` has saved at this level of calls"
            raise state.fault("restore-unsaved", unit.file, row, span, message)
        else:
            restore(run, unit, row, saved)
        return row + 1

    return executed


def restore(run: Run, unit: Unit, row: int, saved: Saved) -> None:
    """Bring saved modes back. The flat program has one place for them: where it holds others by now, words say what changes."""
    state = run.state
    if state.slot is not saved and (saved.modes.lost or state.machine.modes.lost):
        message = "which modes come back here hangs on a code of the machine's own, of which the program tells nothing"
        raise state.fault("runtime-value", unit.file, row, Span(0, 0), message)
    if saved.modes.lost:
        run.out.emit("M72", unit, row, state.frame)
        state.machine.forget()
        return
    lines = state.machine.modes.restoring(saved.modes)
    if state.slot is saved:
        run.out.emit("M72", unit, row, state.frame, lines)
    else:
        for text in lines:
            run.out.emit(text, unit, row, state.frame)
    for text in lines:
        words = _WORD.findall(text)
        state.machine.block([letter for letter, _ in words], [float(number) for _, number in words], False)
