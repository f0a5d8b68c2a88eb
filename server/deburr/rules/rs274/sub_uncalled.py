"""Subprogram that nothing calls.

It is passed over and never runs. In a file that only defines subprograms others call them, and
nothing is said.

Source: spec/rs274.md §6, §8

Bad:

    o<drill> sub
    ^^^^^^^^^^^^
      G0 Z1
    o<drill> endsub

Good:

    o<drill> sub
      G0 Z1
    o<drill> endsub
    o<drill> call

Good (whole):

    o<drill> sub
      G0 Z1
    o<drill> endsub
    M2
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._files import ready_world, said, world_of


@rule(Severity.INFO, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the definition, where all calls are known."""
    world = world_of(analysis)
    for sub in world.main.subs if world.main.sound else ():
        if world.is_uncalled(sub) and len(world.main.by_label[sub.label or ""]) == 1:
            yield Report(sub.span, f"nothing calls `{said(sub.label)}`; it never runs", sub.start)
