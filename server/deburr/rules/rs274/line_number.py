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

Good:

    /N5 G0 X1
    N56.78 G0 X2
"""

from collections.abc import Iterator

from deburr_grammar.problem import Problem

from deburr.rule import Line, Report, Severity, Syntax, rule, whole


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the N."""
    yield Report(whole(problem), f"`{line.said(problem)}`: a line number is `N` and an unsigned number, once, at the start of the line")
