"""Text that is no word, comment or `;`.

A block is made of addresses with a value: `X10`, `X<HA+1>`. Assignments, IF and jumps stand
between `!` and `!`.

Source: spec/z32.md §11

Bad:

    G0 X
       ^
    X=5
    ^
    X-<HA>
     ^
    G0 #5 X1
       ^
    IF HA>10
    ^^

Good:

    G0 X5
    !X=5!
    X<-HA>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the text."""
    yield Report(whole(problem), f"`{line.said(problem)}` is no word that the control can read{_hint(line, problem)}")


def _hint(line: Line, problem: Problem) -> str:
    behind = line.text[problem.end :].lstrip(" \t")
    if behind.startswith("="):
        return "; an assignment stands between `!` and `!`"
    return (
        "; instructions stand between `!` and `!`" if line.said(problem).upper() in ("IF", "EB") else expected(problem)
    )
