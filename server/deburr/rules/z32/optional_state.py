"""Line with `/` on which the program behind it depends.

The operator's switch decides whether the line runs. A block that only moves is kept with its `/`; one
that sets a parameter, names axes or ends a subprogram, and every advanced line, changes what comes
behind it, so there is no one flat program: `--block-delete on` or `off` says which is meant.

`check` cannot know how the switch stands and does not report it; `expand` refuses.

Source: spec/z32.md §6.7, §11

Bad:

    /!HA=1!
    ^^^^^^^

Bad:

    /N20 HA 5 ;one more pass
    ^^^^^^^^^^^^^^^^^^^^^^^^

Bad:

    /PAR[1]5 X1
    ^^^^^^^^^^^

Bad:

    G0 X1
    /G25XYZ
    ^^^^^^^

Good:

    /G0 X1 M8
    /M0 (LOOK AT IT)
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the line where a run comes to it."""
    yield Report(fault.span, fault.message)
