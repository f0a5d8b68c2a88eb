"""Table row without a comma.

A row is output from behind its first comma on. Without one there is nothing to output, and the rows
behind it would be counted wrongly.

Source: spec/cgt.md §3, §5.7

Bad:

    @DCOMP
    0,G40
    G41
    ^^^
    2,G42

Good:

    @DCOMP
    // off, left, right
    0,G40

    ,G41
    right,G42 // , and more
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the row."""
    yield Report(whole(problem), f"`{line.said(problem)}` is no row; what is output stands behind a comma")
