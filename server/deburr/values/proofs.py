"""What is certain to go wrong in a program, in findings of the rules that own it. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from typing import TYPE_CHECKING

from deburr.finding import Finding
from deburr.rule import Proven, Report
from deburr.values.explain import Explanation
from deburr.values.graph import Dead, Loop, Proof
from deburr.values.places import Places

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.values.program import Program, Routine
    from deburr.values.solve import Solution

Written = Callable[[Hashable], str]
UNREACHED = "sub-unreachable"
"""The rule of a routine that is called only where the program never comes."""


def findings(program: Program, analysis: Analysis, written: Written) -> Iterator[Finding | None]:
    """All that is proven of all routines that can be reached, if its rule is on; None wherever the work can be left."""
    explained = Explanation(program, analysis, written)
    places = Places(program)
    for name, solved in program.solved.items():
        routine = program.routines[name]
        yield None
        for proven in _proofs(routine, solved.solution, analysis, places):
            if proven is None:
                yield None
            else:
                yield from _found(explained, routine, *proven, analysis)
    yield from _idle(program, analysis, written)


def _found(explained: Explanation, routine: Routine, node: int, proof: Proof, analysis: Analysis) -> Iterator[Finding]:
    rule = analysis.ruleset.named(proof.kind)
    if rule is None or rule not in analysis.ruleset.rules:
        return
    own = rule.check(proof) if isinstance(rule.trigger, Proven) else [_report(proof)]
    related = tuple(explained.related(routine, node))
    for report in own:
        place = explained.place(routine, node, report.span)
        yield Finding(rule.name, analysis.ruleset.severity(rule, report.severity), report.message, place, related)


def _report(proof: Proof) -> Report:
    return Report(proof.span, proof.message, severity=proof.severity)


def _proofs(
    routine: Routine, solution: Solution, analysis: Analysis, places: Places
) -> Iterator[tuple[int, Proof] | None]:
    for node, proof in sorted({**solution.remarks, **solution.proofs}.items()):
        if places.agree(routine, node, proof):
            yield node, proof
    for loop in routine.graph.loops:
        yield None
        if routine.files is None and _is_endless(solution, loop) and places.alone(routine, loop.test):
            row = routine.rows[routine.graph.nodes[loop.test].line]
            said = analysis.document.line(row)[loop.span.start : loop.span.end]
            message = f"`{said}` never ends: its condition holds in every pass, and nothing in it leaves it"
            yield loop.test, Proof(loop.kind, loop.span, message)


def _idle(program: Program, analysis: Analysis, written: Written) -> Iterator[Finding | None]:
    """Ways that are never taken and routines that are never reached, whatever the switches of the program are set to."""
    here = [routine for routine in program.routines.values() if not routine.is_elsewhere(analysis.file)]
    routines = [routine for routine in here if routine.name in program.solved]
    unreached = [
        routine.name for routine in here if routine.name not in program.solved and _is_called(program, routine.name)
    ]
    found = bool(unreached)
    for routine in routines:
        yield None
        found = found or bool(_ways(routine, program.solved[routine.name].solution))
    if not found:
        return
    general = program.general
    if general is not program:
        for _ in general.solving():
            yield None
    explained, places = Explanation(general, analysis, written), Places(general)
    for routine in routines:
        if routine.name in general.solved:
            yield None
            ways = _ways(routine, general.solved[routine.name].solution)
            for node, dead in (each for each in ways if places.alone(routine, each[0])):
                proof = Proof(dead.kind, dead.span, dead.message, severity=dead.severity)
                yield from _found(explained, routine, node, proof, analysis)
                yield None
    for name in unreached:
        if name not in general.solved:
            yield from _unreached(general, explained, name, analysis)


def _ways(routine: Routine, solution: Solution) -> list[tuple[int, Dead]]:
    """The ways that no values go, at nodes that can be reached and passed."""
    return [
        (node, dead)
        for node in sorted(solution.before)
        for dead in routine.graph.nodes[node].dead
        if node not in solution.proofs and solution.targets(node) and _is_dead(solution, node, dead)
    ]


def _is_dead(solution: Solution, node: int, dead: Dead) -> bool:
    if dead.later:
        return dead.target not in solution.before and solution.ends and all(map(solution.targets, solution.before))
    return dead.target not in solution.targets(node)


def _is_called(program: Program, name: str) -> bool:
    return any(name in program.routines[each].graph.callees for each in program.solved)


def _unreached(program: Program, explained: Explanation, name: str, analysis: Analysis) -> Iterator[Finding]:
    routine = program.routines[name]
    first = min(routine.graph.nodes, default=None)
    if first is None or (span := routine.graph.nodes[first].condition) is None:
        return
    message = "this is called only where the program never comes, so that it never runs"
    yield from _found(explained, routine, first, Proof(UNREACHED, span, message), analysis)


def _is_endless(solution: Solution, loop: Loop) -> bool:
    """Whether every way through a loop goes round again, and nothing in it can stop the control."""
    if not {loop.head, loop.test} <= solution.before.keys():
        return False
    # A program may have a thousand loops: each looks at its own nodes only.
    inside = [node for node in range(loop.first, loop.last + 1) if node in solution.before]
    if not solution.doubtful.isdisjoint(inside):
        return False
    ways = [solution.targets(node) for node in inside]
    return all(way and all(loop.first <= target <= loop.last for target in way) for way in ways)
