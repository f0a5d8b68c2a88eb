"""Word or setting without a value.

Every letter is followed by a value, and so is the `=` of a setting: a number, `#`, `[`, a
function or a sign. The control finds no characters to read and stops.

Source: spec/rs274.md §2

Bad:

    #1=
      ^
    S(speed)100
    ^
    G0 X Y1
       ^^

Good:

    S100 (speed)
    #1=0
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the letter or sign that lacks its value."""
    yield Report(whole(problem), f"`{line.said(problem).strip()}` has no value{expected(problem)}")
