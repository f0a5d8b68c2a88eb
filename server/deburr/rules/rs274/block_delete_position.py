"""Block delete sign that is not the first of its line.

`/` deletes a block only as its very first sign, before the line number. Elsewhere it is a bad
character.

Source: spec/rs274.md §1.3

Bad:

    G0 /X1
       ^
    N5 /G0 X1
       ^

Good:

    /N5 G0 X1
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the sign."""
    slashes = "//" in line.text[max(0, problem.start - 1) : problem.end + 1]
    hint = "; a comment starts with `;` or stands in `( )`" if slashes else ""
    yield Report(whole(problem), f"`/` must be the first sign of the line; the control stops at it here{hint}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Start a comment where two stand; before a line number, move it there."""
    start = broken.span.start
    slashes = broken.text.startswith("//", start)
    if slashes and ")" not in broken.text[start:]:
        yield Fix("Write a comment behind `;`", (broken.edit(start, start + 2, ";"),))
    elif not slashes and re.fullmatch(r"\s*N[0-9]+\s*", broken.text[:start], re.I):
        yield Fix("Move `/` to the start", (broken.edit(0, 0, "/"), broken.edit(start, start + 1, "")))
