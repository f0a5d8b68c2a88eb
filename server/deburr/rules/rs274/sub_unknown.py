"""Call of a subprogram that there is not.

`o<drill> call` runs `o<drill> sub` of the same file, or the file `drill.ngc` in the program's
folder or in one of the setting `subroutine-path`. The control stops with "EOF in file seeking
o-word" where it finds none. In a file that only defines subprograms the program that calls it may
have the missing one; there it is a warning.

`M98 P100` runs what stands behind a bare `O100`. Where it comes to `o100 sub` first, the control stops there.

A subprogram behind M2 is looked for from the call on downward: one that stands above a call in
another subprogram behind M2 is not found.

Source: spec/rs274.md §6, §8

Bad:

    o9 call
    ^^^^^^^

Bad:

    o<dril> call [3]
    ^^^^^^^^^^^^
    -- drill.ngc --
    o<drill> sub
    o<drill> endsub

Bad:

    M98 P100
    ^^^^^^^^

Bad:

    G18 F100
    G71 Q100 X4 Z2 D0.5 I1 R0.5
    ^^^^^^^^

Bad (whole):

    o510 call
    M2
    o500 sub
      G0 X1
    o500 endsub
    o510 sub
      o500 call
      ^^^^^^^^^
    o510 endsub

Bad:

    o<drill> call
    ^^^^^^^^^^^^^
    -- subs/drill.ngc --
    o<drill> sub
    o<drill> endsub

Good (subroutine-path=subs|lib):

    o<drill> call
    -- lib/drill.ngc --
    o<drill> sub
    o<drill> endsub

Good:

    o<drill> sub
    o<drill> endsub
    o<Drill> call
    o<pocket> call
    -- pocket.ngc --
    o<pocket> sub
    o<pocket> endsub

Good (whole):

    o510 call
    M98 P100
    M2
    o510 sub
      o500 call
    o510 endsub
    o500 sub
      G0 X1
    o500 endsub
    o100
    G0 X2
    M99
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._calls import IDLE, why
from deburr.rules.rs274._files import How, ready_world, said, world_of

_NOWHERE = (How.MISSING, How.PASSED)


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report every call that leads nowhere. Where the program's folder cannot be seen, only what the text itself decides."""
    world = world_of(analysis)
    for call in world.main.calls if not world.nested else ():
        target = world.target(world.path, world.main, call)
        nearby = target.how is How.NEARBY and not world.is_library
        if nearby or target.how in _NOWHERE and world.fails(target, call):
            certain = not (nearby or world.is_library or world.is_idle(call.line))
            notes = (Note(target.sub.start, target.sub.span, f"`{said(call.label)} sub`"),) if target.sub else ()
            message = why(world, world.main, call, target) + (IDLE if world.is_idle(call.line) else "")
            yield Report(call.span, message, call.line, notes, severity=None if certain else Severity.WARNING)


fix = did_you_mean
