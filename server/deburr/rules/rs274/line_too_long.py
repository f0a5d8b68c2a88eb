"""Line that is longer than the control reads.

LinuxCNC takes 252 characters, comments included, and stops with "Command too long"; a line end of
two characters, as Windows writes it, costs one of them. The SmithyCNC manual allows 256.

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


@rule(Severity.ERROR, Long(251))
def check(line: Line) -> Iterator[Report]:
    """Report what stands beyond the limit."""
    length, crlf = len(line.text), line.ending == "\r\n"
    limit = 256 if line.settings["profile"] == "smithy" else 252 - crlf
    if length > limit:
        why = " where lines end with CR and LF" if crlf and limit < 252 else ""
        yield Report(Span(limit, length), f"the line has {length} characters; the control reads {limit}{why}")
