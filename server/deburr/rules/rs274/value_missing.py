"""Word or setting without a value.

Every letter is followed by a value, and so is the `=` of a setting: a number, `#`, `[`, a
function or a sign. The control finds no characters to read and stops. The letter O is no digit.

Source: spec/rs274.md §2

Bad:

    #1=
      ^
    S(speed)100
    ^
    G0 X Y1
       ^
    G0 XO Y0
       ^

Good:

    S100 (speed)
    #1=0
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the letter or sign that lacks its value."""
    said, behind = line.said(problem), line.text[problem.end :].lstrip()[:1]
    hint = f"; `{behind}` is the letter, for the digit write `0`" if behind in ("O", "o") else expected(problem)
    if len(said) > 1:
        hint = f": `{said[0]}` starts an O-word; text stands behind `;` or in `( )`"
        yield Report(whole(problem), f"`{said}` has no number or name{hint}")
    else:
        yield Report(whole(problem), f"`{said}` has no value{hint}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the digit in place of the letter that looks like it."""
    end = broken.span.end
    if "for the digit write `0`" in broken.finding.message and broken.text[end : end + 1] in "Oo":
        yield Fix("Change to `0`", (broken.edit(end, end + 1, "0"),))
