"""Line that the operator may skip and on which others depend.

A line that begins with `/` runs or not, as a switch on the machine stands. As long as it only moves, the
flat program keeps the `/`. If it sets a parameter, calls or holds an O-word, the lines behind it
depend on the switch, and there is no one flat program: say `--block-delete on` or `off`.

`check` takes it as it comes and does not report it; `expand` refuses.

Source: spec/rs274.md §7

Bad:

    /#1=5
    ^^^^^
    G0 X#1

Bad:

    o1 sub
    o1 endsub
    / o1 call
    ^^^^^^^^^

Good:

    /G0 X5
    /(MSG,hello)
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
