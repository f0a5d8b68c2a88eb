"""ATAN without its second argument.

ATAN takes two bracketed arguments, `ATAN[y]/[x]`, and gives the angle in all four quadrants. With
one only the control stops with "Slash missing after first atan argument".

Source: spec/rs274.md §3.3

Bad:

    #1=ATAN[1]
       ^^^^^^^
    #1=ATAN[1]/2
       ^^^^^^^^

Good:

    #1=ATAN[1]/[2]
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the function as far as it goes."""
    yield Report(whole(problem), f"`{line.said(problem)}` lacks its second argument; write `ATAN[y]/[x]`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Put the second argument into brackets; without one, 1 leaves the tangent as it is."""
    number = _NUMBER.match(broken.text, broken.span.end)
    if not broken.said.endswith("/"):
        yield broken.inserted(broken.span.end, "/[1]")
    elif number is not None:
        edit = broken.edit(*number.span(), f"[{number[0]}]")
        yield Fix(f"Write `[{number[0]}]`", (edit,))


_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)|#[0-9]+|#<[^<>]+>")
