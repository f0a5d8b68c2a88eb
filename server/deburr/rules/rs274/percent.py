"""Percent sign that does not stand alone.

`%` marks the start and the end of a program, each on a line of its own. With anything else on the
line the control calls it a bad character.

Source: spec/rs274.md §1.1

Bad (whole):

    %part 7
     ^^^^^^
    G0 X1
    M2

Good (whole):

    %
    G0 X1
    %
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the text beside it."""
    yield Report(whole(problem), f"`{line.said(problem)}` stands on a line with `%`, which must be alone")
