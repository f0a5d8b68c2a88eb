"""Instruction that an advanced line does not know.

Between `!` and `!` there are assignments, IF, EB, CP, PC, GON, GOP, GOS and `:L254-`.

Source: spec/z32.md §3

Bad:

    !FOO!
     ^^^
    !HA=1; GOTO10!
           ^^^^^^
    !GON1-200!
     ^^^^^^^^
    !GON!
     ^^^

Good:

    !HA=1; GON10!
    G0 X1
    N10 G0 X2
"""

from collections.abc import Iterator
from difflib import get_close_matches

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem

_KNOWN = ("IF", "EB", "CP", "PC", "GON", "GOP", "GOS")


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the field."""
    said = line.said(problem)
    name = "".join(letter for letter in said if letter.isalpha()).upper()
    near = [] if name in _KNOWN else get_close_matches(name, _KNOWN, 1, 0.6)
    if near:
        hint = f"; did you mean `{near[0]}`?"
    else:
        hint = expected(problem) if name in _KNOWN else f"; there are `name=value`, {', '.join(_KNOWN)} and `:L254-`"
    yield Report(whole(problem), f"`{said}` is no instruction of an advanced line{hint}")
