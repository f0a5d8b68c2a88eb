"""Line with more than 200 opening brackets.

No control works out such an expression and nobody wrote it. Nothing else is said of the line.

Source: deburr's own limit

Bad:

    {[*201}
    ^^^^^^^

Good:

    {(}deburr speaks here{)}
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the line."""
    yield Report(whole(problem), "a line with more than 200 opening brackets is not read; no control works it out")
