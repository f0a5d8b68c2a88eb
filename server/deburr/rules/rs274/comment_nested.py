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

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the inner comment."""
    yield Report(whole(problem), f"`{line.said(problem)}` stands inside a comment; the control refuses nested comments")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write other brackets in the comment."""
    inner = broken.said
    if inner.startswith("(") and inner.endswith(")") and inner.count("(") == inner.count(")") == 1:
        yield broken.replaced(f"[{inner[1:-1]}]")
