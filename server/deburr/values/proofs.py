"""What is certain to go wrong in a program, in findings of the rules that own it. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from typing import TYPE_CHECKING

from deburr.finding import Finding
from deburr.rule import Proven, Report
from deburr.values.explain import Explanation
from deburr.values.graph import Loop, Proof

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution


def findings(program: Program, analysis: Analysis, written: Callable[[Hashable], str]) -> Iterator[Finding]:
    """All that is proven of all routines that can be reached, if its rule is on."""
    explained = Explanation(program, analysis, written)
    for name, solved in program.solved.items():
        routine = program.routines[name]
        for node, proof in _proofs(routine, solved.solution, analysis):
            rule = analysis.ruleset.named(proof.kind)
            if rule is None or rule not in analysis.ruleset.rules:
                continue
            own = rule.check(proof) if isinstance(rule.trigger, Proven) else [Report(proof.span, proof.message)]
            related = tuple(explained.related(routine, node))
            for report in own:
                place = explained.place(routine, node, report.span)
                yield Finding(
                    rule.name, analysis.ruleset.severity(rule, report.severity), report.message, place, related
                )


def _proofs(routine: Routine, solution: Solution, analysis: Analysis) -> Iterator[tuple[int, Proof]]:
    for node, proof in sorted({**solution.remarks, **solution.proofs}.items()):
        if _everywhere(routine, solution, node, proof):
            yield node, proof
    for node in sorted(solution.before):
        dead = routine.graph.nodes[node].dead
        if dead is not None and node not in solution.proofs and dead.target not in solution.targets(node):
            yield node, Proof(dead.kind, dead.span, dead.message)
    for loop in routine.graph.loops:
        if _is_endless(solution, loop):
            row = routine.rows[routine.graph.nodes[loop.test].line]
            said = analysis.document.line(row)[loop.span.start : loop.span.end]
            message = f"`{said}` never ends: its condition holds in every pass, and nothing in it leaves it"
            yield loop.test, Proof(loop.kind, loop.span, message)


def _everywhere(routine: Routine, solution: Solution, node: int, proof: Proof) -> bool:
    """Whether a line of a file that is put in at several places goes wrong at each of them that can be reached."""
    if routine.files is None:
        return True
    at = routine.graph.nodes[node].line
    place = (routine.files[at], routine.rows[at])
    others = (each for each in solution.before if (routine.files[each], routine.rows[each]) == place)
    known = {**solution.remarks, **solution.proofs}
    return all(each in known and known[each].kind == proof.kind for each in others)


def _is_endless(solution: Solution, loop: Loop) -> bool:
    """Whether every way through a loop goes round again, and nothing in it can stop the control."""
    inside = [node for node in solution.before if loop.first <= node <= loop.last]
    if loop.head not in solution.before or not solution.doubtful.isdisjoint(inside):
        return False
    ways = [solution.targets(node) for node in inside]
    return all(way and all(loop.first <= target <= loop.last for target in way) for way in ways)
