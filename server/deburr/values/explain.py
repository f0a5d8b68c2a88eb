"""Why a value is what it is: the settings, conditions and calls that lead to a place, as related places. Proves nothing itself."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from itertools import islice
from typing import TYPE_CHECKING

from deburr.finding import Place, Related
from deburr.values.domain import ANY, Value, joined
from deburr.values.graph import Telling
from deburr.values.words import said
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.values.graph import Node
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution

_SHOWN = 6
_STEPS = 2_000
_DEPTH = 3


class Explanation:
    """The way to places in one program. ``written``: how a variable is spelled."""

    def __init__(self, program: Program, analysis: Analysis, written: Callable[[Hashable], str]) -> None:
        self._program = program
        self._analysis = analysis
        self._written = written

    def place(self, routine: Routine, node: int, span: Span) -> Place:
        """Columns of a node's line as a place."""
        at = routine.graph.nodes[node].line
        file = self._analysis.file if routine.files is None else routine.files[at]
        return Place(file, routine.rows[at], span.start, routine.rows[at], span.end)

    def related(self, routine: Routine, node: int) -> Iterator[Related]:
        """What led to a node with the values that it uses, the nearest first."""
        solved = self._program.solved.get(routine.name)
        if solved is None:
            return islice(self._callers(routine, "called here, where nothing comes"), _SHOWN)
        solution = solved.solution
        known = solution.before[node]
        used = [key for key in routine.graph.nodes[node].used if key is not None]
        used = sorted((key for key in used if key in known or not isinstance(key, Telling)), key=str)
        found = dict.fromkeys(islice(self._led(routine, solution, node, used, _DEPTH), 4 * _SHOWN))
        return islice(found, _SHOWN)

    def _led(
        self, routine: Routine, solution: Solution, node: int, keys: list[Hashable], depth: int
    ) -> Iterator[Related]:
        behind: list[tuple[int, list[Hashable]]] = []
        for key in keys:
            sources = list(self._sources(routine, solution, node, key))
            for place, why in sources:
                yield Related(self._around(routine, place), why)
                inner = [each for each in place.used if each is not None and each != key]
                if key in place.sets and depth and inner:
                    behind.append((next(n for n, p in routine.graph.nodes.items() if p is place), inner))
            if (depth == _DEPTH or not sources) and solution.before[node].get(key, ANY) != ANY:
                yield from self._calls(routine, solution, key)
        for number, inner in behind:
            yield from self._led(routine, solution, number, sorted(inner, key=str), depth - 1)

    def setting(self, routine: Routine, solution: Solution, node: int, key: Hashable) -> list[int]:
        """The lines one of which has set a variable last before a node; none where it may come from elsewhere."""
        first = min(routine.graph.nodes)
        found, seen, waiting = set[int](), {node}, [node]
        while waiting:
            at = waiting.pop()
            for source in solution.sources(at):
                place = routine.graph.nodes[source]
                if key in place.sets:
                    found.add(routine.rows[place.line])
                elif place.calls or None in place.sets:
                    return []
                elif source not in seen:
                    seen.add(source)
                    waiting.append(source)
        return [] if first in seen or len(seen) > _STEPS else sorted(found)

    def _sources(self, routine: Routine, solution: Solution, start: int, key: Hashable) -> Iterator[tuple[Node, str]]:
        """The nearest settings of a variable, and the conditions on it that are passed on the way."""
        seen, waiting = {start}, [start]
        while waiting and len(seen) < _STEPS:
            node = waiting.pop(0)
            for source in sorted(solution.sources(node), reverse=True):
                place = routine.graph.nodes[source]
                value = solution.before[node].get(key, ANY)
                if key in place.sets:
                    yield place, self._set(key, value)
                    continue
                if self._is_set_inside(place, key):
                    yield place, f"`{self._written(key)}` is set by what is called here{_holds(said(value))}"
                    continue
                old = solution.before[source].get(key, ANY)
                if place.condition is not None and key in place.used and value != old and source not in seen:
                    yield place, self._learned(key, value)
                if source not in seen:
                    seen.add(source)
                    waiting.append(source)

    def _is_set_inside(self, place: Node, key: Hashable) -> bool:
        """Whether a call leads to what sets a variable."""
        summary = self._program.summary(place.callee) if place.callee is not None else None
        return summary is not None and summary.written is not None and key in summary.written

    def _set(self, key: Hashable, value: Value) -> str:
        return (
            key.told(value) if isinstance(key, Telling) else f"`{self._written(key)}` is set here{_holds(said(value))}"
        )

    def _learned(self, key: Hashable, value: Value) -> str:
        if isinstance(key, Telling):
            return key.told(value)
        known = _holds(said(value)) or (" is no number" if value.empty and value.wild else " is restricted")
        return f"from here on `{self._written(key)}`{known}"

    def _calls(self, routine: Routine, solution: Solution, key: Hashable) -> Iterator[Related]:
        """The calls that give a routine its arguments."""
        entry = self._program.entry(routine.name)
        if key not in entry or key in routine.graph.locals:
            return
        yield from self._callers(routine, "called here")
        yield from self._around_calls(routine, key)

    def _around_calls(self, routine: Routine, key: Hashable, passed: frozenset[str] = frozenset()) -> Iterator[Related]:
        """Where what a call hands on is set: before the calls, or those around them; if something calls that has no lines, anywhere."""
        for other, solved in self._program.solved.items():
            caller = self._program.routines[other]
            if routine.name not in solved.called or other in passed:
                continue
            if caller.rows[0] < 0:
                yield from self._elsewhere(routine, key)
                continue
            calls = [at for at in sorted(solved.solution.before) if caller.graph.nodes[at].callee == routine.name]
            found = [each for at in calls for each in self._sources(caller, solved.solution, at, key)]
            yield from (Related(self._around(caller, place), why) for place, why in found)
            if not found:
                yield from self._around_calls(caller, key, passed | {routine.name})

    def _elsewhere(self, routine: Routine, key: Hashable) -> Iterator[Related]:
        known = self._program.entry(routine.name).get(key, ANY)
        for other, solved in self._program.solved.items():
            caller, solution = self._program.routines[other], solved.solution
            for number in sorted(solution.before) if other != routine.name else ():
                targets = [to for to in solution.targets(number) if to in solution.before]
                if key in caller.graph.nodes[number].sets and targets:
                    value = solution.before[targets[0]].get(key, ANY)
                    if joined(value, known) == known:
                        yield Related(self._around(caller, caller.graph.nodes[number]), self._set(key, value))

    def _callers(self, routine: Routine, why: str) -> Iterator[Related]:
        """The calls of a routine: those that are reached, or all if none is."""
        for other, solved in self._program.solved.items():
            caller = self._program.routines[other]
            is_reached = routine.name in solved.called
            if not is_reached and routine.name in self._program.solved:
                continue
            for number in sorted(solved.solution.before if is_reached else caller.graph.nodes):
                place = caller.graph.nodes[number]
                if place.callee == routine.name:
                    yield Related(self._around(caller, place), why)

    def _around(self, routine: Routine, node: Node) -> Place:
        """A node's condition, or its whole line."""
        span = node.condition
        file = self._analysis.file if routine.files is None else routine.files[node.line]
        if span is None and file == self._analysis.file:
            text = self._analysis.document.line(routine.rows[node.line])
            span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
        span = span or Span(0, 0)
        return Place(file, routine.rows[node.line], span.start, routine.rows[node.line], span.end)


def _holds(text: str) -> str:
    return f", it holds {text}" if text else ""
