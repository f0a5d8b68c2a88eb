"""`#EVAL` that is no assignment.

It takes a word, `=`, and an expression or, for a text, unquoted text up to the parenthesis.

Source: spec/cgt.md §3, §5.8

Bad:

    #EVAL(#V1)
    ^^^^^^^^^^
    #EVAL()
    ^^^^^^^
    #EVAL (#V1=1)
    ^^^^^
    #EVAL(#V1=1+)
    ^^^^^^^^^^^^^
    #EVAL(#V1=1 2)
                ^
    #EVAL(#V1=--1)
               ^
    #EVAL(#V1=2**3)
                ^

Good:

    #EVAL(#V1=#V1-#U2)
    #EVAL(#V1=-2^(2+1)*PI/MAX(#V2, .5))
    #EVAL(#S9=M03)
    #EVAL(#S9=)
    #EVAL(#V1=jos(TOOL LENGTH))
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import blanks_left_out
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what does not fit."""
    said = line.said(problem)
    what = "is no complete assignment" if said.upper().startswith("#EVAL") else "does not fit into an assignment"
    yield Report(whole(problem), f"`{said}` {what}{expected(problem)}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave out the blanks before the bracket."""
    yield from blanks_left_out(broken, "(")
