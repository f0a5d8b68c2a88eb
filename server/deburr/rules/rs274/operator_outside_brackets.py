"""Operator outside brackets.

Operators work only between `[` and `]`. Elsewhere the value ends where it can, and the control
calls the operator a bad character. Comments start with `;` or stand in `( )`; `//` starts none.

Source: spec/rs274.md §2

Bad:

    #4=#1+2
         ^
    G0 X10/2
          ^
    G0 X10 // first hole
           ^

Good:

    #1=3
    #4=[#1+2]
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the operator."""
    sign, pair = line.said(problem), line.text[problem.start : problem.start + 2]
    if pair in ("//", "/*"):
        yield Report(whole(problem), f"`{pair}` starts no comment here; write `;` or `( )`")
    else:
        yield Report(whole(problem), f"`{sign}` calculates only inside brackets, as in `[#1{sign}2]`")
