"""M code of the machine builder.

M100 to M199 run a program of that name which the machine builder has put on the control. Whether
there is one only the machine knows: without it the control stops with "Unknown m code used".

Source: spec/rs274.md §5

Bad:

    M190
    ^^^^
    M101 P1 Q2
    ^^^^

Good:

    M8
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._words import report, said, words
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report the code."""
    for at in words(line).groups.get("user", ()):
        yield report(
            line, at, f"`{said(line, at)}` is a command of the machine builder; it runs only where it is installed"
        )
