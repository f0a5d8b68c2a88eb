"""CP at the origin, where there is no angle.

CP turns HX and HY into the radius HR and the angle HT. Where both are 0 any angle is as good as another: HT
becomes 0, and what is calculated with it points along X.

Source: spec/z32.md §4

Bad:

    !HX=0; HY=0; CP!
                 ^^

Bad:

    HA 3
    !HX=HA-3; HY=0*HA; CP!
                       ^^

Good:

    !HX=0; HY=0.001; CP!
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the instruction."""
    yield Report(fault.span, fault.message)
