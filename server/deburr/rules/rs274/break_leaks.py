"""`break` that ends another loop as well.

The installed interpreter keeps in mind that it has met a `break` until it comes to the end of a `do`
loop, and ends that loop, though its condition holds. It meets the `break` of a `while` loop also where
that loop ends by itself. The flat program is what the manual says: the `do` loop goes on. Write it as
a `while` loop, and both say the same.

Source: spec/rs274.md §6, spec/oracle.md §4

Bad:

    #1=0
    o1 while [1]
      o2 if [#1 GE 2]
        o1 break
      o2 endif
      #1=[#1+1]
    o1 endwhile
    #1=0
    o5 do
      #1=[#1+1]
    o5 while [#1 LT 3]
    ^^^^^^^^^^^^^^^^^^

Good:

    #1=0
    o1 while [1]
      o2 if [#1 GE 2]
        o1 break
      o2 endif
      #1=[#1+1]
    o1 endwhile
    #1=0
    o5 while [#1 LT 3]
      #1=[#1+1]
    o5 endwhile
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
