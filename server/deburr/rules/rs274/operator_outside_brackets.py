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

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
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


def fix(broken: Broken) -> Iterator[Fix]:
    """Start a comment, or put what is calculated into brackets."""
    start = broken.span.start
    if "starts no comment" in broken.finding.message:
        yield Fix("Write a comment behind `;`", (broken.edit(start, start + 2, ";"),))
        return
    before = re.search(rf"{_OPERAND}\s*$", broken.text[:start])
    after = re.match(rf"(?:\s*(?:\*\*|[-+*/])\s*{_OPERAND})+", broken.text[start:], re.I)
    if before is not None and after is not None:
        text = broken.text[before.start() : start + after.end()]
        edit = broken.edit(before.start(), start + after.end(), f"[{text}]")
        yield Fix(f"Write `[{text}]`", (edit,))


_OPERAND = r"(?:[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)|#+[0-9]+|#<[^<>]+>|\[[^\[\]]*\])"
