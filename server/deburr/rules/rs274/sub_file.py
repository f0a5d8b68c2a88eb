"""Called file that does not give the control its subprogram.

The control writes a called name in small letters without blanks and looks for `name.ngc`: a file
`Drill.ngc` or `drill.nc` is never found. It looks for `o<name> sub` in the file and starts there:
a file without it, or with subprograms above it that are called in it, ends the program. Where
both the program and the file start with `%` nothing is found at all. An error in the called
subprogram stops the program, too, and is shown at the first call.

Source: spec/rs274.md §6, §8, spec/oracle.md §4, §5

Bad:

    o<Drill> call
    ^^^^^^^^^^^^^
    -- Drill.ngc --
    o<drill> sub
    o<drill> endsub

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    -- drill.ngc --
    o<drilling> sub
    o<drilling> endsub

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    -- drill.ngc --
    o<retract> sub
      G0 Z5
    o<retract> endsub
    o<drill> sub
      o<retract> call
    o<drill> endsub

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    -- drill.ngc --
    o<drill> sub
      G0 Z#<depth>
    o<drill> endsub

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    -- drill.ngc --
    o<drill> sub
      G0 Z5

Bad (whole):

    %
    o<drill> call
    ^^^^^^^^^^^^^
    %
    -- drill.ngc --
    %
    o<drill> sub
    o<drill> endsub
    %

Bad:

    M98 P2
    ^^^^^^
    -- 2.ngc --
    G0 X1
    M2

Good:

    o<drill> call
    -- drill.ngc --
    o<drill> sub
      o<retract> call
    o<drill> endsub
    o<retract> sub
      G0 Z5
    o<retract> endsub
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._calls import why
from deburr.rules.rs274._files import How, Target, Trouble, World, ready_world, world_of
from deburr.rules.rs274._program import Call

_AT_ALL = (How.LACKS, How.PERCENT, How.MISNAMED)


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report every call of a file that cannot serve it, and the first call of each file in which the control stops."""
    world = world_of(analysis)
    told: set[str] = set()
    for call in world.main.calls if not world.nested else ():
        target = world.target(world.path, world.main, call)
        idle = world.is_idle(call.line)
        if target.how in _AT_ALL and world.fails(target, call):
            severity = Severity.WARNING if idle or world.is_library and target.how is How.MISNAMED else None
            yield Report(call.span, why(world, world.main, call, target), call.line, severity=severity)
        elif target.how is How.FILE and not idle and target.path not in told:
            told.add(target.path)
            yield from _inside(world, call, target)


def _inside(world: World, call: Call, target: Target) -> Iterator[Report]:
    troubles = list(world.troubles(target))
    worst = max(troubles, key=lambda trouble: trouble.severity, default=None)
    if worst is None:
        return
    file, at = worst.path.rpartition("/")[2], f"line {worst.line + 1}"
    said = _said(world, worst)
    does = "the control stops" if worst.severity is Severity.ERROR else "see"
    message = f"{does} in `{file}`, {at}: {said}"
    severity = worst.severity if worst.severity is not Severity.ERROR and not world.is_library else None
    if world.is_library:
        severity = Severity.WARNING
    yield Report(call.span, message, call.line, (_note(worst, said),), severity=severity)


def _said(world: World, trouble: Trouble) -> str:
    if trouble.call is None or trouble.target is None or trouble.program is None:
        return trouble.message
    return why(world, trouble.program, trouble.call, trouble.target)


def _note(trouble: Trouble, said: str) -> Note:
    return Note(trouble.line, trouble.span, said, trouble.path)
