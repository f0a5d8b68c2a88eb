"""Function without parentheses.

The argument of a function stands in `( )`; the control refuses the line if it does not.

Source: spec/z32.md §3

Bad:

    HA<SN 30>
       ^^
    !HA=RQ+1!
        ^^

Good:

    HA<SN(30)>
    !HA=RQ(2)+1!
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import bracketed
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the function."""
    said = line.said(problem)
    yield Report(
        whole(problem), f"`{said}` needs its argument in parentheses, `{said}(...)`; the control refuses the line"
    )


def fix(broken: Broken) -> Iterator[Fix]:
    """Put the value behind it into parentheses."""
    yield from bracketed(broken, "()")
