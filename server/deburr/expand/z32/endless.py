"""Whether a run goes round for ever: the same state twice, and nothing output between (spec/z32.md §7, §8). Outputs nothing itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand.z32.state import ELSEWHERE, END, MACHINE
from deburr.fault import Halt

if TYPE_CHECKING:
    from deburr.expand.z32.state import Loop, State
    from deburr.expand.z32.unit import Unit
    from deburr.fault import Frame

STEPS = 20_000
"""Lines in which a state must come back: a loop that does nothing is short."""


class Round(NamedTuple):
    """A place on an endless way that is in the fewest calls, jumps and loops: what goes round stands there."""

    depth: int
    unit: Unit
    row: int
    loop: Loop | None
    frame: Frame | None


def goes_round(state: State, row: int, step: Callable[[int], int]) -> Round | None:
    """Where a run goes that has come to a line and is certain to come there again just as it is, without an output on the way.

    A control in such a loop neither moves nor ends. What reads PAL[256] to PAL[512] waits for the machine,
    and what outputs a block is a program that repeats: neither is said to be endless.
    ``step`` executes a line and gives the next one; the run cannot be gone on with afterwards.
    """
    machine, state.pal[MACHINE:] = state.pal[MACHINE:], [None] * len(state.pal[MACHINE:])
    start, before, found = row, _known(state), _at(state, row)
    try:
        with state.job.silent():
            for _ in range(STEPS):
                row = step(row)
                if row == END:
                    return None
                row = state.row if row == ELSEWHERE else row
                found = min(found, _at(state, row), key=lambda each: each.depth)
                if row == start and _known(state) == before:
                    return found
    except Halt:
        return None
    finally:
        state.pal[MACHINE:] = machine
    return None


def _at(state: State, row: int) -> Round:
    depth = sum(1 for _ in state.frame.outward()) if state.frame is not None else 0
    return Round(depth, state.program.unit, row, state.loop, state.frame)


def _known(state: State) -> tuple[object, ...]:
    """All on which it depends what a run does next."""
    calls = [(call.program, call.behind, call.pending.ways()) for call in state.calls]
    flags = (state.alias, state.unsure, frozenset(state.uncertain))
    return state.program, dict(state.params), [*state.par], [*state.pal], flags, calls, state.pending.ways()
