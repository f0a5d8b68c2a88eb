"""Header that is no section name.

A section starts at `@` and a name: a letter, then letters, digits or `_`, with nothing else
on the line but blanks and a comment. The generator finds no section under any other header,
so the lines behind it would never run.

Source: spec/cgt.md §2, §11

Bad:

    @9x
    ^^^

Bad:

    @DWELL G4
           ^^

Bad:

    @ DWELL
    ^^^^^^^

Good:

    @DWELL  // G4 is written here
    G4 P#DWELL

Good:

    @FXD1
    G81 X#XPOS
    @
    @$side
    #RETNUM(1)
    @
    @DECLARE
    #CALCDEC #side
    @
    @FXD2
    #side
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import split
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what is no name, or what stands behind it."""
    said = line.said(problem)
    if problem.start:
        yield Report(
            whole(problem), f"`{said}` stands behind a section's name; a header holds the name and nothing else"
        )
    else:
        yield Report(whole(problem), f"`{said}` is no section header; a name is a letter, then letters, digits or `_`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave out the blank behind the `@`; what stands behind the name goes on the next line."""
    if "behind a section" in broken.finding.message:
        yield from split(broken)
    elif re.fullmatch(r"@[ \t]+[A-Za-z]\w*", broken.said):
        yield broken.replaced("@" + broken.said[1:].strip())
