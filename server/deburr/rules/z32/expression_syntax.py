"""Expression that cannot be calculated.

A value is missing, an operator is missing between two values, or an index lacks its bracket. The
control refuses the line.

Source: spec/z32.md §3

Bad:

    HA<X+>
         ^
    HA<X Y>
         ^
    HA<2(X+1)>
        ^^^^^
    PAR[HA X5
       ^^^
    !HA=!
       ^

Good:

    HA<X+Y*2>
    PAR[1]5
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report where the expression breaks."""
    yield Report(whole(problem), f"the expression cannot be calculated at `{line.said(problem)}`{expected(problem)}")
