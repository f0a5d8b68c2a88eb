"""Line number that is malformed or misplaced.

A line number is `N` and an unsigned number, once, before everything but the block delete sign.
Elsewhere the control calls the N a bad character. LinuxCNC takes any size and a fraction; the
SmithyCNC manual allows 0 to 99999.

Source: spec/rs274.md §1.3

Bad:

    N-5 G0 X1
    ^^
    G0 N5
       ^
    N5 N6 G0
       ^

Bad (profile=smithy):

    N123456 G0 X1
    ^^^^^^^
    N5.5 G0 X2
    ^^^^

Good (profile=smithy):

    N99999 G0 X1

Good:

    N123456 G0 X1
    /N5 G0 X1
    N56.78 G0 X2
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule
from deburr_grammar.problem import Problem
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Syntax(("line_number",), only=("profile", "smithy")))
def check(line: Line, part: Problem | Node) -> Iterator[Report]:
    """Report the N, or in the smithy profile a number that its manual does not allow."""
    said, place = line.said(part), Span(part.start, part.end)
    if isinstance(part, Problem):
        yield Report(place, f"`{said}`: a line number is `N` and an unsigned number, once, at the start of the line")
    elif not re.fullmatch("[0-9]{1,5}", "".join(said[1:].split())):
        yield Report(place, f"`{said}` is no line number from 0 to 99999")


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave the number out: it means nothing to the control."""
    number = re.match(r"N\s*[-+]?[0-9.]*", broken.text[broken.span.start :], re.I)
    if number is not None:
        yield broken.deleted(broken.span.start, broken.span.start + number.end())
