"""Comment without its `)`.

The rest of the line would be comment, the words in it included; the control refuses the block.

Source: spec/z32.md §2

Bad:

    (oops
    ^^^^^
    G0 X1 (approach Y2
          ^^^^^^^^^^^^

Good:

    G0 X1 (approach) Y2
"""

from collections.abc import Iterator

from deburr.fixers import closed
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the comment."""
    yield Report(whole(problem), "the comment is never closed, so the rest of the line is lost in it; `)` is missing")


fix = closed(")")
