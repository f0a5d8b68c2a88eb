"""Program that is called no times.

`M98 P100 L0` runs nothing. The installed interpreter enters the call all the same and never leaves
it: from there on local names are gone, labels count as those of the program that was not run, and
one call fewer can be active. The flat program is what the manual says. Put the call into an `if`.

Source: spec/rs274.md §6

Bad (whole):

    #<times>=0
    M98 P100 L#<times>
    ^^^^^^^^^^^^^^^^^^
    M2
    o100
    G0 X1
    M99

Good (whole):

    #<times>=0
    o1 if [#<times> GT 0]
      M98 P100 L#<times>
    o1 endif
    M2
    o100
    G0 X1
    M99
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
