"""Branches and loops as closures (spec/rs274.md §6). Knows no call.

The documented meaning is run. Where the installed interpreter does something else, because it
keeps `break`, `continue` and counts of one loop for the next (spec/oracle.md §4), that is said.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.rs274.parts import condition, last_values
from deburr.expand.rs274.state import ENDLESS, Loop
from deburr.fault import Entered, Frame

_PROBES = {first + behind: behind for first in (2**power for power in range(6, 40)) for behind in (0, 1)}
"""Passes at which all values are looked at, and the next ones, at which they are compared."""

if TYPE_CHECKING:
    from deburr.expand.rs274.parts import Parts
    from deburr.expand.rs274.state import State
    from deburr.expand.rs274.unit import Block, Op, Unit
    from deburr.expand.rs274.values import Get
    from deburr.fault import Halt


class Loops:
    """The branches and loops of one run."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._seen: tuple[object, ...] = ()

    def branch(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`if`: the first branch whose condition holds."""
        block, first = self._block(unit, row, parts), parts.condition
        rows = block.middles
        last = next((at for at in rows if not self._is_elseif(unit, at)), block.close)
        others = [(at + 1, self._condition(unit, at)) for at in rows if at < last]
        start, behind = row + 1, last + 1

        def chosen() -> int:
            if first():
                return start
            for branch, holds in others:
                if holds():
                    return branch
            return behind

        return chosen

    def other_branch(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`elseif` or `else` behind a branch that ran: the control still calculates the conditions that follow."""
        block = self._block(unit, row, parts)
        rows = [at for at in block.middles if at >= row and self._is_elseif(unit, at)]
        conditions, behind = [self._condition(unit, at) for at in rows], block.close + 1

        def passed() -> int:
            for calculate in conditions:
                calculate()
            return behind

        return passed

    def nothing(self, unit: Unit, row: int, parts: Parts) -> Op:
        """A line that only marks a place."""
        return lambda: row + 1

    def test(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`while`, which opens a loop or ends a `do`."""
        block, holds = self._block(unit, row, parts), parts.condition
        if block.open != row:
            return self._end_of_do(unit, row, block, parts)
        body, behind = row + 1, block.close + 1
        if block.crossed:
            return lambda: body if holds() else behind
        state, file, breaks = self._state, unit.file, bool(block.breaks)

        def tested() -> int:
            loops = state.loops
            if loops and loops[-1].first == row:
                outer, passes = loops[-1].outer, state.frame.number if state.frame is not None else 0
            else:
                outer, passes = state.frame, 0
                loops.append(Loop(row, outer))
            if holds():
                state.frame = Frame(outer, file, row, Entered.LOOP, passes + 1)
                if passes in _PROBES:
                    self._probe(unit, row, parts, passes)
                return body
            loops.pop()
            state.frame = outer
            state.leaks.continued = False
            if breaks:
                # It looks at the `break` on its way to the end.
                state.leaks.broke = True
            return behind

        return tested

    def end_of_while(self, unit: Unit, row: int, parts: Parts) -> Op:
        """Back to the test."""
        first = self._block(unit, row, parts).open
        return lambda: first

    def do(self, unit: Unit, row: int, parts: Parts) -> Op:
        """The first pass of a loop that is tested at its end."""
        state, body = self._state, row + 1
        if self._block(unit, row, parts).crossed:
            return lambda: body

        def entered() -> int:
            state.loops.append(Loop(row, state.frame))
            state.frame = Frame(state.frame, unit.file, row, Entered.LOOP, 1)
            return body

        return entered

    def repeat(self, unit: Unit, row: int, parts: Parts) -> Op:
        """A counted loop; the count is rounded half to even."""
        block, count, state = self._block(unit, row, parts), parts.condition, self._state
        body, behind, key = row + 1, block.close + 1, (unit.file, row)
        if block.crossed:
            return self._crossed_repeat(count, key, body, behind)

        def entered() -> int:
            times = round(count())
            if state.leaks.counters or state.calls:
                self._check_counter(unit, row, parts, times)
            if times <= 0:
                state.leaks.continued = False
                return behind
            state.loops.append(Loop(row, state.frame, times - 1))
            state.frame = Frame(state.frame, unit.file, row, Entered.LOOP, 1)
            return body

        return entered

    def end_of_repeat(self, unit: Unit, row: int, parts: Parts) -> Op:
        """The next pass, if there is one left."""
        block, state = self._block(unit, row, parts), self._state
        first, body, behind = block.open, block.open + 1, row + 1
        if block.crossed:
            return lambda: first
        count = self._condition(unit, first)

        def ended() -> int:
            _, outer, left = loop = state.loops.pop()
            if left:
                passes = state.frame.number + 1 if state.frame is not None else 1
                state.loops.append(loop._replace(left=left - 1))
                state.frame = Frame(outer, unit.file, first, Entered.LOOP, passes)
                return body
            state.frame = outer
            if state.leaks.continued:
                state.leaks.continued = False
                self._warn_continue(unit, row, parts, round(count()) > 0)
            return behind

        return ended

    def leave(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`break`: out of the loop of that label; the condition of a `do` is still calculated."""
        target = self._loop_of(unit, row, parts)
        holds, behind = self._condition(unit, target.close if target.kind == "do" else target.open), target.close + 1
        state, is_do = self._state, target.kind == "do"

        def left() -> int:
            self._abandon(unit, target.open)
            if is_do:
                holds()
            elif state.leaks.continued:
                state.leaks.continued = False
                self._warn_continue(unit, row, parts, holds() != 0)
            state.leaks.broke = not is_do
            return behind

        return left

    def go_on(self, unit: Unit, row: int, parts: Parts) -> Op:
        """`continue`: the test of the loop of that label."""
        target = self._loop_of(unit, row, parts)
        to = target.close if target.kind == "do" else target.open
        state, is_do, breaks = self._state, target.kind == "do", any(at > row for at in target.breaks)

        def skipped() -> int:
            self._abandon(unit, target.open + 1)
            if is_do:
                state.leaks.continued = True
            elif breaks:
                state.leaks.broke = True
            return to

        return skipped

    def _end_of_do(self, unit: Unit, row: int, block: Block, parts: Parts) -> Op:
        state, holds, first, body, behind = self._state, parts.condition, block.open, block.open + 1, row + 1
        if block.crossed:
            return lambda: body if holds() else behind

        def tested() -> int:
            outer = state.loops[-1].outer
            again, broke = holds(), state.leaks.broke
            state.leaks.broke = False
            if again:
                if broke:
                    self._warn_break(unit, row, parts)
                passes = state.frame.number + 1 if state.frame is not None else 1
                state.frame = Frame(outer, unit.file, first, Entered.LOOP, passes)
                if passes in _PROBES:
                    self._probe(unit, row, parts, passes)
                return body
            state.loops.pop()
            state.frame = outer
            return behind

        return tested

    def _crossed_repeat(self, count: Get, key: tuple[str, int], body: int, behind: int) -> Op:
        """A `repeat` that overlaps another block: its count lives on until its own line finds it used up."""
        counters = self._state.leaks.counters

        def entered() -> int:
            left = counters.pop(key) if key in counters else round(count())
            if left <= 0:
                return behind
            counters[key] = left - 1
            return body

        return entered

    def _abandon(self, unit: Unit, first: int) -> None:
        """Leave all loops that start in this row or below it."""
        state = self._state
        while state.loops and state.loops[-1].first >= first:
            loop = state.loops.pop()
            state.frame = loop.outer
            if loop.left != ENDLESS:
                state.leaks.counters[unit.file, loop.first] = loop.left

    def _probe(self, unit: Unit, row: int, parts: Parts, passes: int) -> None:
        """End a loop of which a whole pass has changed nothing: it goes on like this for ever."""
        state = self._state
        now = (unit.file, row, state.values())
        if _PROBES[passes] == 0:
            self._seen = now
        elif now == self._seen:
            message = f"`{parts.said}` never ends: its passes change nothing"
            raise self._fault("limit", unit, row, parts, message + last_values(state, unit, row))

    def _check_counter(self, unit: Unit, row: int, parts: Parts, times: int) -> None:
        state = self._state
        left = state.leaks.counters.pop((unit.file, row), times)
        deeper = any(
            call.unit is unit and any(loop.first == row and loop.left != ENDLESS for loop in call.loops)
            for call in state.calls
        )
        if deeper or left != times:
            why = "it is still counting in an outer call" if deeper else f"it was left with {left} to go"
            message = f"`{parts.said}` runs {max(times, 0)} times; the installed interpreter goes on with its old count, because {why}"
            state.warn("repeat-counter", unit.file, row, parts.span, message)

    def _warn_break(self, unit: Unit, row: int, parts: Parts) -> None:
        message = f"`{parts.said}` goes on with the loop; the installed interpreter ends it here, because of a `break` that it met before in another loop"
        self._state.warn("break-leaks", unit.file, row, parts.span, message)

    def _warn_continue(self, unit: Unit, row: int, parts: Parts, differs: bool) -> None:
        if differs:
            message = f"`{parts.said}` ends the loop; the installed interpreter runs it again, because of a `continue` that it met before in a `do` loop"
            self._state.warn("continue-leaks", unit.file, row, parts.span, message)

    def _condition(self, unit: Unit, row: int) -> Get:
        found = condition(self._state, unit, row) if row < len(unit.code) else None
        return found if found is not None else lambda: 0.0

    def _is_elseif(self, unit: Unit, row: int) -> bool:
        return "ELSEIF" in unit.document.node(row).kinds

    def _block(self, unit: Unit, row: int, parts: Parts) -> Block:
        """The block that a line is part of. Only a program whose faults were not heeded has lines without one."""
        block = unit.blocks.get(row)
        if block is None:
            message = f"`{parts.said}` belongs to no block; the control stops here"
            raise self._fault("o-unopened", unit, row, parts, message)
        return block

    def _loop_of(self, unit: Unit, row: int, parts: Parts) -> Block:
        block = unit.blocks.get(row)
        if block is None:
            message = f"no `while` or `do` of that label is open around `{parts.said}`"
            raise self._fault("break-target", unit, row, parts, message)
        return block

    def _fault(self, kind: str, unit: Unit, row: int, parts: Parts, message: str) -> Halt:
        return self._state.fault(kind, unit.file, row, parts.span, message)
