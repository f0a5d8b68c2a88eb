"""Function that does not exist.

Where a value is expected, letters can only be a function: ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP,
FIX, FUP, LN, ROUND, SIN, SQRT, TAN. There is no NOT, INT or LOG. The control stops with "Unknown
word where unary operation could be". Text that is no comment ends here too: its first letter is
taken for a word, the others for that word's value.

Source: spec/rs274.md §3.3

Bad:

    #1=FOO[1]
       ^^^
    #1=[NOT 1]
        ^^^
    G0 X0 side 2
          ^^^^

Bad:

    #1=ABBS[4]
       ^^^^

Good:

    #1=FIX[2.5]
    G0 X0 ; side 2
"""

import re
from collections.abc import Iterator

from deburr.fixers import did_you_mean
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.suggest import suggestion
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the name."""
    name = line.said(problem)
    if any(part.kind == "LETTER" and part.start == problem.start for part in line.node.tree.children):
        message = f"`{name}` is no word: `{name[0]}` has no value, and `{name[1:]}` is no function; text stands behind `;` or in `( )`"
    elif glued := _LETTERS.search(line.text[: problem.start]):
        operator = (glued[0] + name).upper()
        message = f"`{glued[0]}{name}` is no operator{suggestion(_OPERATORS.get(operator, operator), _COMPARE)}"
    else:
        message = f"`{name}` is no function{_meant(name) or expected(problem)}"
    yield Report(whole(problem), message)


_NAMES = ("ABS", "ACOS", "ASIN", "ATAN", "COS", "EXISTS", "EXP", "FIX", "FUP", "LN", "ROUND", "SIN", "SQRT", "TAN")
_COMPARE = ("EQ", "NE", "GT", "GE", "LT", "LE", "MOD", "AND", "OR", "XOR")
_OPERATORS = {"GTE": "GE", "LTE": "LE", "NEQ": "NE", "EQU": "EQ"}
_LETTERS = re.compile(r"[A-Za-z]+$")
_ELSEWHERE = {"INT": "FIX", "FLOOR": "FIX", "CEIL": "FUP", "LOG": "LN"}
"""What other languages call the same."""


def _meant(name: str) -> str:
    plain = "".join(name.split()).upper()
    return f"; did you mean `{_ELSEWHERE[plain]}`?" if plain in _ELSEWHERE else suggestion(plain, _NAMES)


fix = did_you_mean
