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

from collections.abc import Generator, Iterator, Sequence

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.rs274._files import World, ready_world, world_of
from deburr.rules.rs274._frame import is_part
from deburr.rules.rs274._held import Role
from deburr.rules.rs274._program import Use
from deburr.rules.rs274._values import given
from deburr.steps import paced

ARGUMENTS = range(1, 31)
FREE = range(31, 5001)


@rule(Severity.WARNING, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first read of each number."""
    world = world_of(analysis)
    reads: list[Use] = []

    def take(uses: Sequence[Use]) -> None:
        reads.extend([use for use in uses if use.role is Role.READ and use.number is not None])

    yield from parted(world.main.uses, take)
    if not reads or world.nested or world.is_library or analysis.settings["parameters"] or is_part(analysis):
        return
    told = {int(said) for said in given(analysis) if said.isdecimal()}
    known = yield from _known(world)
    in_main: set[int] = set()
    yield from parted(world.main.uses, lambda uses: in_main.update(_in_main(world, uses)))
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


def _known(world: World) -> Generator[None, None, set[int] | None]:
    """The numbers that are set anywhere; None where that is not certain."""
    found: set[int] = set()
    is_certain = world.is_complete
    for use in paced(use for program in world.programs for use in program.uses) if is_certain else ():
        if use is None:
            yield
        elif use.role in (Role.SET, Role.MENTIONED):
            if use.number is not None:
                found.add(use.number)
            elif use.name is None:
                return None
    return found if is_certain else None


def _is_unset(world: World, use: Use, known: set[int] | None, in_main: set[int]) -> bool:
    if known is None:
        return False
    if use.number in FREE:
        return use.number not in known
    if use.number not in ARGUMENTS or world.main.sub_at(use.line) is not None or world.main.bare:
        return False
    return use.number not in known or use.number not in in_main


def _in_main(world: World, uses: Sequence[Use]) -> set[int]:
    """The numbers that the main program sets, asks for or names in a line that cannot be read."""
    said = (use for use in uses if use.role is not Role.READ and world.main.sub_at(use.line) is None)
    return {use.number for use in said if use.number is not None}
