"""Function without brackets around its argument.

`SIN 30` is refused: the control misses the left bracket after the name.

Source: spec/rs274.md §3.3

Bad:

    #1=SIN 30
       ^^^
    #1=[ABS -5]
        ^^^

Good:

    #1=SIN[30]
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import bracketed
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the function's name."""
    yield Report(whole(problem), f"`{line.said(problem)}` needs its argument in brackets, `{line.said(problem)}[...]`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Put the value behind it into brackets."""
    yield from bracketed(broken, "[]")
