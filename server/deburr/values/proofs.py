"""What is certain to go wrong in a program, in findings of the rules that own it. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from typing import TYPE_CHECKING

from deburr.finding import Finding, Place, Related
from deburr.values.explain import Explanation
from deburr.values.graph import Loop, Proof

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution


def findings(program: Program, analysis: Analysis, written: Callable[[Hashable], str]) -> Iterator[Finding]:
    """All that is proven of all routines that can be reached, if its rule is on."""
    explained = Explanation(program, analysis.document, written)
    for name, solved in program.solved.items():
        routine = program.routines[name]
        for node, proof in _proofs(routine, solved.solution, analysis):
            rule = analysis.ruleset.named(proof.kind)
            if rule is None or rule not in analysis.ruleset.rules:
                continue
            row = routine.rows[routine.graph.nodes[node].line]
            related = tuple(
                Related(Place(analysis.file, note.line, note.span.start, note.line, note.span.end), note.message)
                for note in explained.notes(routine, node)
            )
            place = Place(analysis.file, row, proof.span.start, row, proof.span.end)
            yield Finding(rule.name, analysis.ruleset.severity(rule), proof.message, place, related)


def _proofs(routine: Routine, solution: Solution, analysis: Analysis) -> Iterator[tuple[int, Proof]]:
    yield from sorted(solution.proofs.items())
    for loop in routine.graph.loops:
        if _is_endless(solution, loop):
            row = routine.rows[routine.graph.nodes[loop.test].line]
            said = analysis.document.line(row)[loop.span.start : loop.span.end]
            message = f"`{said}` never ends: its condition holds in every pass, and nothing in it leaves it"
            yield loop.test, Proof(loop.kind, loop.span, message)


def _is_endless(solution: Solution, loop: Loop) -> bool:
    """Whether every way through a loop goes round again, and nothing in it can stop the control."""
    inside = [node for node in solution.before if loop.first <= node <= loop.last]
    if loop.head not in solution.before or not solution.doubtful.isdisjoint(inside):
        return False
    ways = [solution.targets(node) for node in inside]
    return all(way and all(loop.first <= target <= loop.last for target in way) for way in ways)
