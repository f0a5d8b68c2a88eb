"""What is proven of one variable or loop, for who looks at it. Proves nothing itself, knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from typing import TYPE_CHECKING

from deburr.values import Told
from deburr.values.explain import Explanation
from deburr.values.passes import Passes, passes
from deburr.values.words import said

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.values.graph import Loop
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution
    from deburr_grammar.text import Span

_SHOWN = 3
"""So many lines that set a variable are named."""


def told(
    program: Program, analysis: Analysis, line: int, key: Hashable, behind: bool, written: Callable[[Hashable], str]
) -> Told | None:
    """What a variable holds before a line, or behind it, and where that comes from."""
    value = program.value(analysis.file, line, key, behind)
    if value is None or (value.empty and not value.texts) or not (text := said(value)):
        return None
    turned, rows = (None, []) if behind else _origin(program, analysis, line, key, written)
    shown = " and ".join(str(row + 1) for row in rows)
    why = f"set at line{'s' if len(rows) > 1 else ''} {shown}" if 0 < len(rows) <= _SHOWN else ""
    return Told(text, why, text if value.exact else None, turned)


def turns(program: Program, file: str, line: int) -> tuple[Span, int] | None:
    """How often a loop goes round whose condition stands on a line, and the columns of its command."""
    for routine, solution, nodes in program.places(file, line):
        for loop in routine.graph.loops:
            found = passes(solution, loop) if loop.test in nodes else None
            if found is not None:
                return loop.span, found.times
    return None


def all_turns(program: Program, file: str) -> Iterator[tuple[int, Span, int]]:
    """How often each loop of a file goes round, where that is proven: the line of its condition, the columns of its command, the number."""
    for name, solved in program.solved.items():
        routine = program.routines[name]
        for loop in routine.graph.loops:
            at = routine.graph.nodes[loop.test].line
            found = passes(solved.solution, loop) if loop.test in solved.solution.before else None
            if found is not None and (routine.files is None or routine.files[at] == file):
                yield routine.rows[at], loop.span, found.times


def _origin(
    program: Program, analysis: Analysis, line: int, key: Hashable, written: Callable[[Hashable], str]
) -> tuple[int | None, list[int]]:
    """The passes of the loop around a line that a variable counts, and the lines of the program that set it last."""
    for routine, solution, nodes in program.places(analysis.file, line):
        around = _counting(routine, solution, nodes, key)
        explained = Explanation(program, analysis, written)
        reached = [node for node in nodes if node in solution.before] if routine.files is None else []
        rows = {row for node in reached for row in explained.setting(routine, solution, node, key)}
        return around.times if around is not None else None, sorted(rows)
    return None, []


def _counting(routine: Routine, solution: Solution, nodes: list[int], key: Hashable) -> Passes | None:
    """The innermost loop around a line that counts a variable, if its passes are known."""
    around: list[Loop] = [
        loop
        for loop in routine.graph.loops
        if all(loop.first < node <= loop.last for node in nodes) and loop.test not in nodes
    ]
    for loop in sorted(around, key=lambda loop: loop.last - loop.first):
        found = passes(solution, loop)
        if found is not None and found.counter == key:
            return found
    return None
