"""What is proven of one variable or loop, for who looks at it. Proves nothing itself, knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable
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
    why = [] if behind else _why(program, analysis, line, key, written)
    return Told(text, ", ".join(why), text if value.exact else None)


def turns(program: Program, file: str, line: int) -> tuple[Span, int] | None:
    """How often a loop goes round whose condition stands on a line, and the columns of its command."""
    for routine, solution, nodes in program.places(file, line):
        for loop in routine.graph.loops:
            found = passes(solution, loop) if loop.test in nodes else None
            if found is not None:
                return loop.span, found.times
    return None


def _why(
    program: Program, analysis: Analysis, line: int, key: Hashable, written: Callable[[Hashable], str]
) -> list[str]:
    from deburr.symbols.constants import count

    found: list[str] = []
    for routine, solution, nodes in program.places(analysis.file, line):
        around = _counting(routine, solution, nodes, key)
        found += [f"({count(around.times)})"] if around is not None else []
        reached = [node for node in nodes if node in solution.before]
        explained = Explanation(program, analysis, written)
        rows = sorted({row for node in reached for row in explained.setting(routine, solution, node, key)})
        if routine.files is None and 0 < len(rows) <= _SHOWN:
            found.append(f"set at line{'s' if len(rows) > 1 else ''} {' and '.join(str(row + 1) for row in rows)}")
        break
    return found


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
