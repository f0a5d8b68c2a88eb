"""Expression whose bracket is not closed.

The control reads on to the end of the line for the `]` and stops with "Unclosed expression".

Source: spec/rs274.md §3

Bad:

    #1=[1+2
       ^^^^
    G0 X[[1+2]*3
        ^^^^^^^^

Good:

    #1=[1+2]
"""

from collections.abc import Iterator

from deburr.fixers import closed
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the expression from its bracket on."""
    yield Report(whole(problem), f"`{line.said(problem)}` is not closed{expected(problem)}")


fix = closed("]")
