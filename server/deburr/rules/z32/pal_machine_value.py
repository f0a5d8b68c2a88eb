"""Value of the machine that was not given.

PAL[256] to PAL[512] are written by the logic of the machine, a pallet in place or a probe that
switched. What they hold decides where the program goes, so nothing is expanded without them: the setting
`pal` gives them, or `-D PAL[300]=5`.

`check` cannot know what the machine holds and does not report it; `expand` refuses.

Source: spec/z32.md §5

Bad:

    X<PAL[300]>
      ^^^^^^^^

Bad:

    HA 256
    !IF PAL[HA]=1; GON10!
        ^^^^^^^
    G0 X1
    N10

Good:

    PAL[255]5
    X<PAL[255]>
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the first read that a run meets."""
    yield Report(fault.span, fault.message)
