"""Comment that is not closed on its line.

A `(` comment must end on the line on which it starts; the control stops with "Unclosed
comment found". Without that, the words behind it would silently be a comment.

Source: spec/rs274.md §1.4

Bad:

    G0 X1 (approach
          ^^^^^^^^^
    (DEBUG, x is #1
    ^^^^^^^^^^^^^^^

Good:

    G0 X1 (approach)
    G0 X2 ; approach (from the left
"""

from collections.abc import Iterator

from deburr.fixers import closed
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the comment up to the line's end."""
    yield Report(whole(problem), f"`{line.said(problem)}` is not closed on its line; the control refuses it, write `)`")


fix = closed(")")
