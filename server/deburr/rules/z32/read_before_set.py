"""Parameter that is read before it has a value.

Parameters keep what the last program left in them, so a program that reads one before it sets it
moves to where that happens to be. Nothing is expanded with a guess: the value is given by the program, or
with `-D HA=10`. Axes have a value from their first word on. What a line with `/` has set is not known
behind it unless `--block-delete` says whether it ran.

`check` cannot know what is given at the machine and does not report it; `expand` refuses.

Source: spec/z32.md §5, §11

Bad:

    X<HA>
      ^^

Bad:

    G0 X10
    G1 X<Y+1> F200
         ^

Bad:

    !IF PAR[3]>0; HB=1!
        ^^^^^^

Bad:

    !HX=1; CP!
           ^^

Bad:

    X0
    /G0 X10
    G1 Y<X+1> F200
         ^

Good:

    HA 10
    PAR[3]2 PAL[7]1
    G0 X<HA> Y<PAR[3]*PAL[7]>
    G1 X<X+1> F200
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the first read that a run meets."""
    yield Report(fault.span, fault.message)
