"""Value with a sign behind a sign.

A value is filled in as it stands, and a loop prints the sign of its total: `Z-|Depth|` with a Depth of -4
becomes `Z--4`. No control takes that for a number; it stops, or reads one of the signs and moves the
wrong way. Write the sign in the line or in the value, not in both.

It is also said where the conditions around the line make it so for every value that is given.

Source: spec/metagcode.md §5.2, §5.5

Bad (variables=part.vars):

    G1 Z-|Top| F100
         ^^^^^
    -- part.vars --
    Top=-1.5

Bad (variables=part.vars):

    #LOOP1 |Depth| 2 c
    G1 Z-|Depth|
         ^^^^^^^
    #ENDLOOP1
    -- part.vars --
    Depth=-4

Good (variables=part.vars):

    #LOOP1 |Depth| 2 c
    G1 Z|Depth| (down to -|Depth|)
    #ENDLOOP1
    -- part.vars --
    Depth=-4
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the reference."""
    yield Report(fault.span, fault.message)


def fix(broken: Broken) -> Iterator[Fix]:
    """The value brings its sign along, so the one before the reference goes."""
    at = broken.span.start - 1
    if at >= 0 and broken.text[at] in "+-":
        yield Fix(f"Delete the `{broken.text[at]}`", (broken.edit(at, at + 1, ""),))
