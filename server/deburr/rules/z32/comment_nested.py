"""Comment inside a comment.

A comment ends at the first `)`: what stands behind it is read as words again, and the control
refuses it or, worse, moves.

Source: spec/z32.md §2, §11

Bad:

    (a (b) c)
       ^^^
    G0 X1 (drill (first) hole) Y2
                 ^^^^^^^

Good:

    G0 X1 (drill, first, hole) Y2
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the inner comment."""
    message = f"`{line.said(problem)}` stands inside a comment, which ends at its `)`; the rest is read as words"
    yield Report(whole(problem), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write other brackets in the comment."""
    inner = broken.said
    if inner.startswith("(") and inner.endswith(")") and inner.count("(") == inner.count(")") == 1:
        yield broken.replaced(f"[{inner[1:-1]}]")
