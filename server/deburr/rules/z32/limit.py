"""Program that never ends.

A jump back whose condition never fails, or a jump to itself, is run until a limit: 1,000,000 executed lines
unless `--max-steps` sets another, as many flat lines (`--max-blocks`), and 10,000 jumps with a return
that never comes. The message names the loop and the values in its condition. `check` runs less and
says nothing of a program that takes longer, but for a loop whose condition holds in every pass on every way to it, and that
nothing leaves.

Source: spec/z32.md §6.7, §7

Bad:

    HA 0
    N10 G0 X<HA>
    !IF HA<1; GON10-N20!
                    ^^^
    N20

Good:

    HA 0
    N10 G0 X<HA>
    !HA=HA+1; IF HA<9; GON10-N20!
    N20
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the line at which the run was left."""
    yield Report(fault.span, fault.message)
