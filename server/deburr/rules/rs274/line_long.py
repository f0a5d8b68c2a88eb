"""Line that LinuxCNC would not read.

The SmithyCNC manual allows 256 characters, but the interpreter that most controls of its family run
takes 252.

Source: spec/rs274.md §1

Bad (profile=smithy):

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
                                                                                                                                                                                                                                                                ^

Bad (profile=smithy):

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
                                                                                                                                                                                                                                                                ^^^^

Good (profile=smithy):

    G0 X1 (xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx)
"""

from collections.abc import Iterator

from deburr.rule import Line, Long, Report, Severity, rule
from deburr_grammar.text import Span


@rule(Severity.WARNING, Long(252))
def check(line: Line) -> Iterator[Report]:
    """Report what stands beyond the limit."""
    length = len(line.text)
    if line.settings["profile"] == "smithy" and length <= 256:
        yield Report(Span(252, length), f"the line has {length} characters; LinuxCNC reads 252")
