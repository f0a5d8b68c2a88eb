"""Expression in which a value is missing.

Between brackets values and operators alternate. Where a value should stand, the control reads
something else as a number and stops with "bad number format".

Source: spec/rs274.md §2

Bad:

    #1=[1+]
          ^
    #1=[]
        ^
    #1=[*2]
        ^

Good:

    #1=[1+2]
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what stands in the value's place."""
    yield Report(whole(problem), f"`{line.said(problem)}` stands where a value should{expected(problem)}")
