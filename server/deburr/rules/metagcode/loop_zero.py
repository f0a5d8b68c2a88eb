"""Loop over a total of 0.

A loop divides the value of its variable into steps. Of 0 there are none, so the body is left out:
nothing is cut, which is safe but seldom what was meant. If another variable of the same loop is not
0, it decides, and this one stays 0.

It is also said where the conditions around the line make it so for every value that is given.

Source: spec/metagcode.md §5.4, §6

Bad (variables=part.vars):

    G0 Z5
    #LOOP1 |Depth| 2 c
           ^^^^^^^
    G1 Z-|Depth|
    #ENDLOOP1
    -- part.vars --
    Depth=0.0

Good (variables=part.vars):

    #LOOP1 |Depth| 2 c |Shift| 1 r
    G1 X|Shift| Z-|Depth|
    #ENDLOOP1
    #IF1 |Pocket| greaterthan 0 n
    #LOOP1 |Pocket| 2 c
    G1 Z-|Pocket|
    #ENDLOOP1
    #ENDIF1
    -- part.vars --
    Depth=6
    Shift=0
    Pocket=0
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the variable in the header."""
    yield Report(fault.span, fault.message)
