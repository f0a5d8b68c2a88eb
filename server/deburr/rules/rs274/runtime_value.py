"""Value that only the machine knows.

What a probe has touched, an input has shown or where `G28` leads is known when the machine stands
there, not before. A flat program with a guess in it would be wrong on the machine, so nothing is
expanded; `--machine-values simulate` answers as the stand-alone interpreter does, for a look at the rest. What `#<_hal[...]>`, `#<_ini[...]>` and `#<_task>` hold can be given: `-D "_hal[motion.feed]=1"`.

`check` cannot know what the machine holds and does not report it; `expand` refuses.

Source: spec/rs274.md §4, §7

Bad:

    G38.2 Z-10 F50
    G0 Z#5063
        ^^^^^

Bad:

    G28
    G91 G0 X[5 - #5420]
                 ^^^^^

Bad:

    M66 P0 L3 Q5
    o1 if [#5399 EQ 1]
           ^^^^^
    o1 endif

Bad:

    #1=#<_hal[motion.feed]>
       ^^^^^^^^^^^^^^^^^^^^

Good:

    G0 X5
    G91 G0 X[5 - #5420]
    #5063=-3
    G0 Z#5063
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
