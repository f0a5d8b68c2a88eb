"""Character that means nothing in a program.

Outside comments a line holds letters, digits and `+ - * / . # = [ ] < > ( ) ; % @ ^ $`, each
where it has a meaning. The control stops with "Bad character used". A text processor or a web page
may have put in signs that only look like those of a keyboard: long dashes, no-break spaces.

Source: spec/rs274.md §1

Bad:

    G0 X1 & Y2
          ^
    G0 X1 )
          ^
    G0 X1,5
         ^
    G0 Z−2.5
        ^
    G0 X1 Х2
          ^

Good:

    G0 X1.5 (& , are text here)
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import advised, deleted, either
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr.rules.rs274._characters import foreign
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the character."""
    char = line.said(problem)
    said = foreign(char) or f"`{char}` {_meant(line, problem) or 'has no meaning here'}"
    way_out = "" if ";" in said[len(char) :] else "; the control stops at a bad character"
    yield Report(whole(problem), said + way_out)


def _meant(line: Line, problem: Problem) -> str:
    char, before, after = line.said(problem), line.text[: problem.start], line.text[problem.end :]
    if char == "," and before[-1:].isdigit() and after[:1].isdigit():
        return "does not part decimals; write `.`"
    return _ALONE.get(char, "")


_ALONE = {
    ")": "closes no comment, none is open here",
    "]": "closes no bracket, none is open here",
    '"': "has no meaning outside comments; text stands in `( )`",
    "'": "has no meaning outside comments; text stands in `( )`",
}


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the sign that it looks like, or leave it out."""
    if broken.said not in "\"'":
        yield from either(advised, deleted)(broken)
