"""Comparison that controls of different age decide differently.

Up to LinuxCNC 2.8 `EQ` and `NE` take values for equal that differ by less than 0.0001, and `GE` and
`LE` are exact. From 2.9 the tolerance is 0.000001, for all four. A value that was calculated
is easily in between. Compare with a tolerance of your own: `[ABS[#1 - #2] LT 0.001]`.

Source: spec/rs274.md §3.2

Bad:

    #1=0.00005
    o1 if [#1 EQ 0]
           ^^^^^^^
    o1 endif
    #2=1
    #3=[#2 GE 1.0000005]
        ^^^^^^^^^^^^^^^

Good:

    #1=0.00005
    o1 if [ABS[#1] LT 0.001]
    o1 endif
    #3=[#1 EQ 1]
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
