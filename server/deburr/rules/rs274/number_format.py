"""Number that is not written as one.

A number is digits with at most one point and at least one digit; there is no exponent and no
decimal comma. The control stops with "bad number format".

Source: spec/rs274.md §1.2

Bad:

    G0 X.
        ^
    G0 X1.2.3
        ^^^^^
    #1=[1.5.2+3]
        ^^^^^

Good:

    G0 X.5 Y1. Z-.25
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the number."""
    yield Report(whole(problem), f"`{line.said(problem)}` is no number; the control stops at it")
