"""Name that is not closed.

A name runs from `<` to `>` on one line. The control stops with "Named parameter not terminated". A `;` in a name starts no comment.

Source: spec/rs274.md §4.2

Bad:

    #<depth=3
    ^^^^^^^^^
    o<drill call
    ^^^^^^^^^^^^

Good:

    #<depth>=3

Good:

    #<a;b>=3
    G0 X#<a;b>
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report from the name's sign on."""
    yield Report(whole(problem), f"`{line.said(problem)}` has no `>` that ends the name")


def fix(broken: Broken) -> Iterator[Fix]:
    """End the name behind its first word."""
    name = re.match(r"[#o]\s*<\s*\w+", broken.said, re.I)
    if name is not None:
        yield broken.inserted(broken.span.start + name.end(), ">")
