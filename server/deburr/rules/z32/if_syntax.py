"""IF without one comparison.

A condition is `expression relation expression` with one of `= <> < > <= >=`, and `;` behind it.
There is no AND or OR: two IFs in a row ask for both. A comparison cannot stand in brackets.

Source: spec/z32.md §3

Bad:

    N1 !IF HA; EB!
        ^^^^^
    !IF HA>; HA=1!
     ^^^^^^
    !IF HA>1>2; HA=1!
            ^
    !IF (HA>5); HA=1!
           ^
    !IF HA>1 HA=5!
             ^^

Good:

    N1 !IF HA>1; IF HA<5; HA=1!
    !IF (HA+1)*2>=5; HA=1!
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the condition or what does not fit in it."""
    message = f"the condition cannot be read at `{line.said(problem)}`; IF takes one comparison and then `;`"
    yield Report(whole(problem), message + expected(problem))
