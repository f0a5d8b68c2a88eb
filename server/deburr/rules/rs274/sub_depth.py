"""Calls that nest deeper than the control allows.

Nine calls can be active at once; at the tenth the control stops with "Too many subroutine
levels". A subprogram that calls itself, or one that calls it, must do so under a condition that
some time fails. Only what is certain without a run is reported here: calls without any condition.

Source: spec/rs274.md §6, §9

Bad:

    o1 sub
      G0 X1
      o1 call
      ^^^^^^^
    o1 endsub
    o1 call

Bad:

    o1 sub
      o2 call
    o1 endsub
    o2 sub
      o1 call
      ^^^^^^^
    o2 endsub
    o1 call

Bad:

    o10 sub
    o10 endsub
    o9 sub
      o10 call
      ^^^^^^^^
    o9 endsub
    o8 sub
      o9 call
    o8 endsub
    o7 sub
      o8 call
    o7 endsub
    o6 sub
      o7 call
    o6 endsub
    o5 sub
      o6 call
    o5 endsub
    o4 sub
      o5 call
    o4 endsub
    o3 sub
      o4 call
    o3 endsub
    o2 sub
      o3 call
    o2 endsub
    o1 sub
      o2 call
    o1 endsub
    o1 call

Good:

    o9 sub
    o9 endsub
    o8 sub
      o9 call
    o8 endsub
    o7 sub
      o8 call
    o7 endsub
    o6 sub
      o7 call
    o6 endsub
    o5 sub
      o6 call
    o5 endsub
    o4 sub
      o5 call
    o4 endsub
    o3 sub
      o4 call
    o3 endsub
    o2 sub
      o3 call
    o2 endsub
    o1 sub
      o2 call
    o1 endsub
    o1 call

Good:

    o1 sub
      o2 if [#1 GT 0]
        o1 call [#1-1]
      o2 endif
    o1 endsub
    o1 call [3]
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._files import World, ready_world, said, world_of
from deburr.rules.rs274._program import Call, Program, Sub
from deburr.steps import paced

DEEPEST = 9
"""Calls that can be active at once."""


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the call that closes a circle, or the tenth of a chain, among calls of the program's own subs that are made whenever their sub runs."""
    world = world_of(analysis)
    program = world.main
    if not program.sound:
        return
    told: set[int] = set()
    begun: set[Sub | None] = set()
    for call in paced(_starts(world)):
        if call is None:
            yield None
            continue
        sub = _sub_of(world, program, call)
        way = _too_deep(world, call) if sub not in begun else []
        begun.add(sub)
        if way and way[-1].line not in told:
            told.add(way[-1].line)
            yield _report(way)


def _starts(world: World) -> Iterator[Call]:
    """The calls with which a run can begin: in a library those of all subs."""
    program = world.main
    calls = program.calls if world.is_library else program.calls_by_sub.get(None, [])
    return (call for call in calls if program.is_certain(call) and not program.passed_over(call.line))


def _report(way: list[Call]) -> Report:
    last = way[-1]
    notes = tuple(Note(call.line, call.span, f"`{said(call.label)} call`") for call in way[:-1])
    circle = any(call.label == last.label for call in way[:-1])
    if circle:
        message = f"`{said(last.label)}` calls itself again and again without any condition; at the tenth call the control stops"
    else:
        message = f"this is the tenth call inside another; the control allows {DEEPEST}"
    return Report(last.span, message, last.line, notes)


def _too_deep(world: World, call: Call) -> list[Call]:
    """The calls that follow from one for certain, down to the first that is one too many or closes a circle; empty if there is none."""
    program = world.main
    seen: set[int] = set()
    waiting = [[call]]
    while waiting:
        way = waiting.pop()
        sub = _sub_of(world, program, way[-1])
        if sub is None:
            continue
        if len(way) > DEEPEST or any(_sub_of(world, program, each) is sub for each in way[:-1]):
            return way
        if (key := sub.start * (DEEPEST + 1) + len(way)) in seen:
            continue
        seen.add(key)
        inner = [each for each in program.calls_by_sub.get(sub, ()) if program.is_certain(each)]
        waiting += [[*way, each] for each in inner[::-1]]
    return []


def _sub_of(world: World, program: Program, call: Call) -> Sub | None:
    target = world.target(world.path, program, call)
    return target.sub if target.program is program else None
