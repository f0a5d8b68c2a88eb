"""Condition or count that is not in brackets.

`if`, `elseif`, `while` and `repeat` take one value in brackets, even if it is a single parameter.
The control misses the left bracket and stops.

Source: spec/rs274.md §6

Bad:

    o1 if #1
       ^^
      o2 repeat 5
         ^^^^^^
      o2 endrepeat
    o1 endif

Good:

    #1=1
    o1 if [#1]
    o1 endif
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the command."""
    yield Report(whole(problem), f"`{line.said(problem)}` needs its value in brackets, `{line.said(problem)} [...]`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Put all that follows into brackets."""
    rest = re.match(r"\s*([^\s;(\[][^;(]*?)\s*(?=$|[;(])", broken.text[broken.span.end :])
    if rest is not None:
        start, end = (broken.span.end + at for at in rest.span(1))
        yield Fix(f"Write `[{rest[1]}]`", (broken.edit(start, end, f"[{rest[1]}]"),))
