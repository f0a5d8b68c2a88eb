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

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the function as far as it goes."""
    yield Report(whole(problem), f"`{line.said(problem)}` lacks its second argument; write `ATAN[y]/[x]`")
