"""Bar without a partner.

A variable stands between two bars on one line, and the bar has no other use: it cannot be written
out, not even in a comment. With an odd number of bars it cannot be told what is a name and what is
text.

Source: spec/metagcode.md §2, §6, §10

Bad:

    G0 X|a
        ^^
    (depth |D| or 5 | 6)
                    ^^^^
    G0 X|| Y|b
            ^^
    #IF1 |a equalto 1 n
         ^^^^^^^^^^^^^^
    #ENDIF1

Good:

    G0 X|a| Y-|b c|
    (|D|)
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report from the bar on."""
    yield Report(whole(problem), f"`{line.said(problem)}` begins with a bar that has no partner; write `|name|`")


def fix(broken: Broken) -> Iterator[Fix]:
    """End the name behind its first word."""
    name = re.match(r"\|\w+", broken.said)
    if name is not None:
        yield broken.inserted(broken.span.start + name.end(), "|")
