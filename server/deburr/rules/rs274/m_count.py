"""More than four M codes on a line.

A line takes four M codes at most, whatever they are. The control stops with "Too many m codes on
line".

Source: spec/rs274.md §5, §9

Bad:

    T1 M6 S100 M3 M8 M48 M0
                         ^^

Good:

    S100 M3 M8 M48 M0
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import split
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._parting import line_of
from deburr.rules.rs274._words import report, said, sharing, words
from deburr_grammar.tree import Node

_MOST = 4


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report the codes that are too many."""
    found = words(line)
    if any(len(group) > 1 for group in sharing(line, found, "M")):
        # That two of them exclude each other says more.
        return
    many = [at for at, letter in enumerate(found.letters) if letter == "M"]
    for at in many[_MOST:]:
        yield report(line, at, f"`{said(line, at)}` is the fifth M code or later; the control takes four on a line")


def fix(broken: Broken) -> Iterator[Fix]:
    """Split the line before it, if nothing but such codes stands behind it: other words would leave the codes before it."""
    _, found, starts = line_of(broken)
    if set(found.letters[starts.index(broken.span.start) :]) == {"M"}:
        yield from split(broken)
