"""Line that is longer than the control reads.

LinuxCNC takes 252 characters, comments included, and stops with "Command too long"; the SmithyCNC
manual allows 256.

Source: spec/rs274.md §1

Bad:

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
                                                                                                                                                                                                                                                                ^

Bad (profile=smithy):

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
                                                                                                                                                                                                                                                                    ^

Good:

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
"""

from collections.abc import Iterator

from deburr.rule import Line, Long, Report, Severity, rule
from deburr_grammar.text import Span


@rule(Severity.ERROR, Long(252))
def check(line: Line) -> Iterator[Report]:
    """Report what stands beyond the limit."""
    length = len(line.text)
    limit = LIMIT[line.settings["profile"]]
    if length > limit:
        yield Report(Span(limit, length), f"the line has {length} characters; the control reads {limit}")


LIMIT = {"linuxcnc": 252, "smithy": 256}
