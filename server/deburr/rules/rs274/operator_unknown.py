"""Operator that does not exist.

The operators are `**`, `*`, `/`, `MOD`, `+`, `-`, `EQ`, `NE`, `GT`, `GE`, `LT`, `LE`, `AND`, `OR`
and `XOR`. There is no `^`, no `<`, no `==`, and a comment may not stand inside an expression.
The control stops with "Unknown operation".

Source: spec/rs274.md §3.1

Bad:

    #1=[2^3]
         ^
    #1=[1 < 2]
          ^
    #1=[1 (x) + 2]
          ^^^

Good:

    #1=[2**3]
    #1=[1 LT 2]
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what stands in the operator's place."""
    yield Report(
        whole(problem),
        f"`{line.said(problem)}` is no operator{_MEANT.get(line.said(problem), '') or expected(problem)}",
    )


_MEANT = {"^": "; write `**`", "<": "; write `LT`", ">": "; write `GT`", "=": "; write `EQ`", "%": "; write `MOD`"}
