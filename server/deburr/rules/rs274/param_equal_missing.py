"""Parameter setting without `=`.

A `#` at the start of a word is a setting and must go on with `=`.

Source: spec/rs274.md §2

Bad:

    #1 G0 X5
    ^^^

Bad:

    #1[2+3]
    ^^
    #<deep>[2+3]
    ^^^^^^^

Good:

    #1=5
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the parameter."""
    yield Report(
        whole(problem),
        f"`{line.said(problem).strip()}` is not followed by `=`; a parameter outside a value is a setting",
    )


def fix(broken: Broken) -> Iterator[Fix]:
    """The sign before a value that follows."""
    end = broken.span.start + len(broken.said.rstrip())
    if broken.text[end:].lstrip()[:1] in tuple("0123456789.#[+-"):
        yield broken.inserted(end, "=")
