"""Comparison outside an IF.

`<` and `>` compare only in the condition of an IF. Elsewhere `<` opens an expression and the
first `>` closes it, so `HA<X>Y>` ends behind the X. `=` stores.

Source: spec/z32.md §3

Bad:

    HA<X>Y>
        ^
    !HA=X<Y!
         ^
    !HA=X<=Y!
         ^^
    HA<(X>Y)+1>
         ^
    !HA=X=Y!
         ^

Good:

    !IF X>Y; HA=1; EB! HA=0!
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the sign."""
    said = line.said(problem)
    message = f"`{said}` compares only in the condition of an IF; here the control cannot read the line"
    hint = "; if it should close an expression, the `<` is missing" if said in (">", "&gt") else ""
    yield Report(whole(problem), message + hint)
