"""Text beside an O-word.

An O-word stands alone on its line, with nothing before it but a line number and nothing behind
what its command takes but a comment. The control stops with "Unexpected character after O-word".

Source: spec/rs274.md §6

Bad:

    o1 if [1] G0 X1
              ^^^^^
    o1 endif

Bad:

    o<drill> call 5
                  ^
    G0 X1 o2 call
          ^^^^^^^

Good:

    N10 o1 if [1] (first)
      G0 X1
    o1 endif ; last
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import split
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr.rules.rs274._characters import foreign
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the text."""
    text = line.said(problem)
    if strange := foreign(text[0]):
        message = strange
    elif text[0] in "oO" and line.text[: problem.start][-1:].isdigit():
        message = (
            f"`{text}` would be an O-word, which shares its line with nothing; for the digit write `0`, not `{text[0]}`"
        )
    elif _BARE.fullmatch(text):
        message = (
            f"`{text}` cannot share a line with an O-word; what a command takes stands in brackets, as in `[{text}]`"
        )
    else:
        message = f"`{text}` cannot share a line with an O-word; write it on a line of its own"
    yield Report(whole(problem), message)


_BARE = re.compile(r"[-+]?(?:[0-9.]+|#<?\w+>?)")


def fix(broken: Broken) -> Iterator[Fix]:
    """Put a value into brackets; all else goes on a line of its own."""
    if "stands in brackets" in broken.finding.message:
        yield broken.replaced(f"[{broken.said}]")
    else:
        yield from split(broken)
