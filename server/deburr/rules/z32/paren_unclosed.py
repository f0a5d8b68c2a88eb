"""Parenthesis without its `)`.

In an expression `(` sets what is calculated first; without its `)` the control refuses the line.

Source: spec/z32.md §3, §11

Bad:

    HA<(X+1>
       ^^^^
    HA< HB + (HC+HD/2)/(SN(HE) >
                       ^^^^^^^
    !HA=SN(X+1!
          ^^^^

Good:

    HA<(X+1)>
    HA< HB + (HC+HD/2)/(SN(HE)) >
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the parenthesis."""
    yield Report(
        whole(problem), f"`{line.said(problem)}` is never closed, so the control cannot read the line; `)` is missing"
    )


def fix(broken: Broken) -> Iterator[Fix]:
    """Close it where the expression ends."""
    said = broken.said.rstrip()
    inner = said.rstrip("> ") if said.endswith(">") and "<" not in said else said
    yield broken.inserted(broken.span.start + len(inner), ")")
