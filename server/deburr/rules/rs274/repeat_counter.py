"""`repeat` that goes on with an old count.

The installed interpreter keeps the count of a `repeat` with its label. Left by a `return`, or by the
`break` or `continue` of a loop around it, it is not forgotten: the next time the rest is run. In a
subprogram that calls itself all calls share one count. The flat program is what the manual says:
each time the count is new. Count with a `while` loop, and both say the same.

Source: spec/rs274.md §6, spec/oracle.md §4

Bad:

    o1 sub
      o2 repeat [3]
      ^^^^^^^^^^^^^
        G0 X#1
        o3 if [#1 EQ 1]
          o1 return
        o3 endif
      o2 endrepeat
    o1 endsub
    o1 call [1]
    o1 call [2]

Bad:

    o1 sub
      o2 repeat [2]
      ^^^^^^^^^^^^^
        o3 if [#1 GT 1]
          o1 call [#1-1]
        o3 endif
      o2 endrepeat
    o1 endsub
    o1 call [2]

Good:

    o1 sub
      #<n>=0
      o2 while [#<n> LT 3]
        G0 X#1
        o3 if [#1 EQ 1]
          o1 return
        o3 endif
        #<n>=[#<n>+1]
      o2 endwhile
    o1 endsub
    o1 call [1]
    o1 call [2]
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
