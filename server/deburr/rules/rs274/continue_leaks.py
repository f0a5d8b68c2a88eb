"""`continue` that repeats another loop.

The installed interpreter keeps in mind that it has met the `continue` of a `do` loop until it passes
over lines to the end of a loop, and then begins that loop again: a `repeat [2]` runs four times, a
`break` does not leave its `while` loop. The flat program is what the manual says.

Source: spec/rs274.md §6, spec/oracle.md §4

Bad:

    #1=0
    o1 do
      #1=[#1+1]
      o2 if [#1 EQ 1]
        o1 continue
      o2 endif
    o1 while [#1 LT 3]
    o5 repeat [2]
    o5 endrepeat
    ^^^^^^^^^^^^

Bad:

    #1=0
    o1 do
      #1=[#1+1]
      o2 if [#1 EQ 1]
        o1 continue
      o2 endif
    o1 while [#1 LT 3]
    #2=0
    o5 while [#2 LT 10]
      #2=[#2+1]
      o6 if [#2 EQ 5]
        o5 break
        ^^^^^^^^
      o6 endif
    o5 endwhile

Good:

    #1=0
    o1 while [#1 LT 3]
      #1=[#1+1]
      o2 if [#1 EQ 1]
        o1 continue
      o2 endif
    o1 endwhile
    o5 repeat [2]
    o5 endrepeat
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
