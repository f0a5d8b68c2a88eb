"""Loop that never ends.

The control runs `o1 while [1]` for ever, quietly or with endless motion. It is reported where the
condition is proven to hold in every pass and nothing in the loop leaves it or can stop, and where a whole
pass of a run changes nothing at all. A loop that counts in too small steps is only met by `expand`, which
executes 1,000,000 lines unless `--max-steps` sets another number; the message names the loop
and the values in its condition.

Source: spec/rs274.md §7, §9

Bad:

    o1 while [1]
    ^^^^^^^^^^^^
    o1 endwhile

Bad:

    #<x>=0
    #<step>=0
    o1 while [#<x> LT 10]
    ^^^^^^^^^^^^^^^^^^^^^
      G0 X#<x>
      #<x>=[#<x>+#<step>]
    o1 endwhile

Bad:

    #<z>=0
    o1 while [#<z> LT 20]
    ^^^^^^^^^^^^^^^^^^^^^
      #<z>=[#<z>-2]
      G0 Z#<z>
    o1 endwhile

Bad:

    #1=2
    o1 do
      G0 X#1
    o1 while [#1 GT 1]
    ^^^^^^^^^^^^^^^^^^

Good:

    #<x>=0
    #<step>=0.5
    o1 while [#<x> LT 100]
      G0 X#<x>
      #<x>=[#<x>+#<step>]
    o1 endwhile
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
