"""Subprogram that is called above its definition.

The control finds the subprogram further down and runs it, but when the program then comes to the
definition it stops with "found in illegal location". Definitions go before the first call, behind
M2, or in files of their own. For the same reason no definition may stand in a loop: the second
pass meets it again.

Source: spec/rs274.md §6, §8

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    o<drill> sub
      G0 Z1
    o<drill> endsub

Bad:

    o<drill> sub
      o<retract> call
    o<drill> endsub
    o<drill> call
    ^^^^^^^^^^^^^
    o<retract> sub
      G0 Z1
    o<retract> endsub

Bad:

    o1 repeat [2]
      o<drill> sub
      ^^^^^^^^^^^^
        G0 Z1
      o<drill> endsub
      o<drill> call
    o1 endrepeat

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    o<drill> sub
      G0 Z1
    o<drill> endsub
    -- drill.ngc --
    o<drill> sub
    o<drill> endsub

Good:

    o<drill> sub
      o<retract> call
    o<drill> endsub
    o<retract> sub
      G0 Z1
    o<retract> endsub
    o<drill> call

Good (whole):

    o<drill> call
    M2
    o<drill> sub
      G0 Z1
    o<drill> endsub
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._files import How, World, ready_world, said, world_of
from deburr.rules.rs274._program import Call, Program, Sub


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report definitions in loops, and calls of the main program that lead to a definition which it comes to later."""
    world = world_of(analysis)
    program = world.main
    if not program.sound or world.is_library or world.nested:
        return
    met = [sub for sub in program.subs if sub.flow and sub.label is not None and not program.passed_over(sub.start)]
    for sub in met:
        if program.loop_end(sub.start) > sub.start and (sub.inside is not None):
            message = f"`{said(sub.label)} sub` stands in a loop; its second pass meets the definition again, and the control refuses it there"
            yield Report(sub.span, message, sub.start)
    later = {sub.label: sub for sub in met[::-1] if sub.inside is None}
    last = max((sub.start for sub in later.values()), default=-1)
    for call in program.calls_by_sub.get(None, ()) if last >= 0 else ():
        if call.line < last and not program.passed_over(call.line):
            yield from _early(world, call, later)
            yield None


def _early(world: World, call: Call, later: dict[str | None, Sub]) -> Iterator[Report]:
    for way in _ways(world, call):
        sub = later.get(way[-1].label)
        if sub is None or sub.start < call.line:
            continue
        what = f"`{said(sub.label)} sub` is only defined further down, in line {sub.start + 1}"
        message = f"{what}; the control runs it and then stops at the definition; move the definition up, or behind M2"
        if len(way) > 1:
            message = f"`{said(call.label)}` calls `{said(sub.label)}`: {message}"
        notes = [Note(each.line, each.span, f"`{said(each.label)} call`") for each in way[1:]]
        severity = None if world.main.is_certain(call) else Severity.WARNING
        yield Report(
            call.span, message, call.line, (*notes, Note(sub.start, sub.span, "the definition")), severity=severity
        )
        return


def _ways(world: World, call: Call) -> Iterator[list[Call]]:
    """The calls that follow from a call of the main program for certain, each with all before it; those in files of their own are left out."""
    program, seen = world.main, {call.line}
    waiting = [[call]]
    while waiting:
        way = waiting.pop(0)
        target = world.target(world.path, program, way[-1])
        if target.how not in (How.SUB, How.FILE):
            continue
        yield way
        for inner in _certain_calls(program, target.sub) if target.program is program else ():
            if inner.line not in seen:
                seen.add(inner.line)
                waiting.append([*way, inner])


def _certain_calls(program: Program, sub: Sub | None) -> list[Call]:
    if sub is None:
        return []
    return [call for call in program.calls_by_sub.get(sub, ()) if program.is_certain(call)]
