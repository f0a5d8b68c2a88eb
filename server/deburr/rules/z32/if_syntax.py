"""IF without one comparison.

A condition is `expression relation expression` with one of `= <> < > <= >=`, and `;` behind it.
There is no AND or OR: two IFs in a row ask for both. A comparison cannot stand in brackets.

Source: spec/z32.md §3

Bad:

    N1 !IF HA; EB!
        ^^^^^
    !IF HA>; HA=1!
     ^^^^^^
    !IF HA>1>2; HA=1!
            ^
    !IF (HA>5); HA=1!
           ^
    !IF HA>1 HA=5!
             ^^

Good:

    N1 !IF HA>1; IF HA<5; HA=1!
    !IF (HA+1)*2>=5; HA=1!
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.rules.z32._words import INSTRUCTIONS
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the condition or what does not fit in it."""
    message = f"the condition cannot be read at `{line.said(problem)}`; IF takes one comparison and then `;`"
    yield Report(whole(problem), message + (_hint(line, problem) or expected(problem)))


def _hint(line: Line, problem: Problem) -> str:
    said = line.said(problem).upper()
    before, behind = line.text[: problem.start].rstrip(), line.text[problem.end :].lstrip()
    if said in INSTRUCTIONS:
        return f", which is missing before `{said}`"
    if before.endswith("=") and said[:1] in ("=", "<", ">"):
        return "; equal is written `=`" if said[0] == "=" else f"; write `{said[0]}=`"
    if behind.startswith("!="):
        return "; unequal is written `<>`"
    return _WORDS.get(said, "")


_WORDS = {
    "THEN": ", which stands for `THEN`",
    "AND": "; `IF ...; IF ...;` asks for both",
    "OR": "; a second IF behind the next `!` asks for the other",
    "EQ": "; equal is written `=`",
    "NE": "; unequal is written `<>`",
    "GT": "; greater is written `>`",
    "LT": "; less is written `<`",
    "GE": "; not less is written `>=`",
    "LE": "; not greater is written `<=`",
}


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the separator behind the condition."""
    if broken.said[:1].isalpha() and re.search(r"expected .*`;` or `!`", broken.finding.message):
        yield Fix("Insert `;`", (broken.edit(len(broken.text[: broken.span.start].rstrip()), broken.span.start, "; "),))
