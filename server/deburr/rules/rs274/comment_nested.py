"""Comment inside a comment.

A comment ends at the first `)`, and a second `(` before it is refused: the control stops
with "Nested comment found" when it reads the line.

Source: spec/rs274.md §1.4

Bad:

    G0 X1 (drill (first) hole)
                 ^^^^^^^

Good:

    G0 X1 (drill, first, hole)
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the inner comment."""
    yield Report(whole(problem), f"`{line.said(problem)}` stands inside a comment; the control refuses nested comments")
