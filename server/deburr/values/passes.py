"""How often a loop goes round, where that is the same on every way: its counter is counted out on the loop's own nodes. Knows no language."""

from __future__ import annotations

from typing import NamedTuple

from deburr.values.domain import Value, exactly
from deburr.values.graph import Env, Key, Loop, Proof, Summary
from deburr.values.solve import Solution

_MOST = 10_000
"""Loops with more passes are not counted out."""


class Passes(NamedTuple):
    """How often a loop goes round, and the variable that counts it."""

    times: int
    counter: Key


def passes(solution: Solution, loop: Loop) -> Passes | None:
    """The number of passes; None where something else may leave the loop, or no variable of its condition is set exactly once in each pass."""
    inside = [node for node in solution.before if loop.first <= node <= loop.last]
    if loop.head not in solution.before or any(_leaves(solution, loop, node) for node in inside):
        return None
    counters = sorted(solution.graph.nodes[loop.test].used - {None}, key=str)
    if loop.head == loop.test and not _inside(loop, solution.targets(loop.test)):
        return Passes(0, counters[0]) if counters else None
    for key in counters:
        setting = [node for node in inside if _may_set(solution, node, key)]
        if len(setting) == 1 and _is_in_each_pass(solution, loop, setting[0]):
            times = _counted(solution, loop, setting[0], key)
            return Passes(times, key) if times is not None else None
    return None


def _leaves(solution: Solution, loop: Loop, node: int) -> bool:
    return node != loop.test and any(not loop.first <= to <= loop.last for to in solution.targets(node))


def _may_set(solution: Solution, node: int, key: Key) -> bool:
    here = solution.graph.nodes[node]
    return key in here.sets or None in here.sets or here.calls


def _is_in_each_pass(solution: Solution, loop: Loop, setting: int) -> bool:
    """Whether every pass goes through a node exactly once."""
    is_first = loop.head == loop.test
    starts = _inside(loop, solution.targets(loop.test)) if is_first else {loop.head}
    again = _reached(solution, loop, _inside(loop, solution.targets(setting)), {loop.test})
    return (
        setting != loop.test and setting not in again and loop.test not in _reached(solution, loop, starts, {setting})
    )


def _reached(solution: Solution, loop: Loop, starts: set[int], without: set[int]) -> set[int]:
    """The nodes of a loop that are reached from some without going on through others."""
    found, waiting = set(starts), list(starts - without)
    while waiting:
        behind = _inside(loop, solution.targets(waiting.pop())) - found
        found |= behind
        waiting += behind - without
    return found


def _inside(loop: Loop, nodes: tuple[int, ...]) -> set[int]:
    return {node for node in nodes if loop.first <= node <= loop.last}


def _counted(solution: Solution, loop: Loop, setting: int, key: Key) -> int | None:
    """Count the passes out, from the one value that the counter has before the loop."""
    value = (solution.entering(loop.head) or {}).get(key)
    for times in range(_MOST):
        if value is None or not value.exact:
            return None
        if times or loop.head == loop.test:
            ways = _through(solution, loop.test, key, value)
            if len(ways) != 1:
                return None
            if not _inside(loop, tuple(ways)):
                return times
        behind = _through(solution, setting, key, value)
        value = next(iter(behind.values())).get(key) if len(behind) == 1 else None
    return None


def _through(solution: Solution, node: int, key: Key, value: Value) -> dict[int, Env]:
    """Where a node goes on with one value of a variable, and with all that others may hold in any pass."""
    try:
        return dict(solution.graph.nodes[node].flow({**solution.before[node], key: exactly(value.low)}, _Nobody()))
    except Proof:
        return {}


class _Nobody:
    """Who answers calls where nothing is called."""

    def call(self, label: str, arguments: Env, shared: Env) -> Summary | None:
        """Nothing is known."""
        return None

    def again(self) -> None:
        """Nobody has to be asked again."""
