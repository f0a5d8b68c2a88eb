"""Function that does not exist.

Where a value is expected, letters can only be a function: ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP,
FIX, FUP, LN, ROUND, SIN, SQRT, TAN. There is no NOT, INT or LOG. The control stops with "Unknown
word where unary operation could be".

Source: spec/rs274.md §3.3

Bad:

    #1=FOO[1]
       ^^^
    #1=[NOT 1]
        ^^^

Good:

    #1=FIX[2.5]
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.suggest import suggestion
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the name."""
    yield Report(
        whole(problem), f"`{line.said(problem)}` is no function{_meant(line.said(problem)) or expected(problem)}"
    )


_NAMES = ("ABS", "ACOS", "ASIN", "ATAN", "COS", "EXISTS", "EXP", "FIX", "FUP", "LN", "ROUND", "SIN", "SQRT", "TAN")
_ELSEWHERE = {"INT": "FIX", "FLOOR": "FIX", "CEIL": "FUP", "LOG": "LN"}
"""What other languages call the same."""


def _meant(name: str) -> str:
    plain = "".join(name.split()).upper()
    return f"; did you mean `{_ELSEWHERE[plain]}`?" if plain in _ELSEWHERE else suggestion(plain, _NAMES)
