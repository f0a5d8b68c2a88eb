"""Numbered parameter that is read but never set.

The control takes 0 for it without a word. The numbers 1 to 30 are a subprogram's arguments; in
the main program they are parameters like others. Said only where all calls are known, nothing is
set by a computed number, and no file of stored parameters is configured.

Source: spec/rs274.md §4.1

Bad:

    G0 X#77
        ^^^

Bad:

    o<drill> sub
      G0 X#1
      #2=5
    o<drill> endsub
    o<drill> call [10]
    G0 Y#2
        ^^

Good:

    #77=5
    G0 X#77 Y#5021

Good (parameters=machine.var):

    G0 X#77

Good:

    #31=100
    #[#31+1]=5
    G0 X#101
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._files import World, world_of
from deburr.rules.rs274._frame import is_part
from deburr.rules.rs274._held import Role
from deburr.rules.rs274._program import Use, ready
from deburr.rules.rs274._values import given
from deburr.steps import paced

ARGUMENTS = range(1, 31)
FREE = range(31, 5001)


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first read of each number."""
    world = world_of(analysis)
    reads = [use for use in world.main.uses if use.role is Role.READ and use.number is not None]
    if not reads or world.nested or world.is_library or analysis.settings["parameters"] or is_part(analysis):
        return
    told = {int(said) for said in given(analysis) if said.isdecimal()}
    known, in_main = _known(world), _in_main(world)
    for use in paced(reads):
        if use is None:
            yield None
        elif (
            use.number is not None
            and use.number not in told
            and _is_unset(world, use, known, in_main)
            and not world.is_idle(use.line)
        ):
            told.add(use.number)
            yield Report(use.span, f"nothing sets `#{use.number}`{_where(use)}; the control takes 0 for it", use.line)


def _where(use: Use) -> str:
    return " in the main program" if use.number in ARGUMENTS else ""


def _known(world: World) -> set[int] | None:
    """The numbers that are set anywhere; None where that is not certain."""
    uses = [use for program in world.programs for use in program.uses if use.role in (Role.SET, Role.MENTIONED)]
    if not world.is_complete or any(use.name is None and use.number is None for use in uses):
        return None
    return {use.number for use in uses if use.number is not None}


def _is_unset(world: World, use: Use, known: set[int] | None, in_main: set[int]) -> bool:
    if known is None:
        return False
    if use.number in FREE:
        return use.number not in known
    if use.number not in ARGUMENTS or world.main.sub_at(use.line) is not None or world.main.bare:
        return False
    return use.number not in known or use.number not in in_main


def _in_main(world: World) -> set[int]:
    """The numbers that the main program sets, asks for or names in a line that cannot be read."""
    uses = (use for use in world.main.uses if use.role is not Role.READ and world.main.sub_at(use.line) is None)
    return {use.number for use in uses if use.number is not None}
