"""Name that is not closed.

A name runs from `<` to `>` on one line. The control stops with "Named parameter not terminated".

Source: spec/rs274.md §4.2

Bad:

    #<depth=3
    ^^^^^^^^^
    o<drill call
    ^^^^^^^^^^^^

Good:

    #<depth>=3
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report from the name's sign on."""
    yield Report(whole(problem), f"`{line.said(problem)}` has no `>` that ends the name")
