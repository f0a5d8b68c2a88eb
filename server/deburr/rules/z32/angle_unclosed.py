"""Expression without its `>`.

A calculated value stands between `<` and `>`; where the `>` is missing the control cannot tell where
it ends and refuses the line.

Source: spec/z32.md §3

Bad:

    HA<X+1
      ^^^^
    X<HA*2 Y5
     ^^^^^
    !HA=<X+1; HB=2!
        ^^^^

Good:

    HA<X+1>
"""

from collections.abc import Iterator

from deburr.fixers import closed
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the expression."""
    message = f"`{line.said(problem)}` is never closed, so the control cannot read the line; `>` is missing"
    stores = "!" in line.text[: problem.start]
    yield Report(whole(problem), message + (", or the `IF` before a comparison" if stores else ""))


fix = closed(">")
