"""Two M codes of one modal group on a line.

Codes of one group exclude each other, also where one would think that both could be meant:
`M7` and `M8` are one group, and so are `M6` and `M61`. The control stops with "Two m codes used
from same modal group".

Source: spec/rs274.md §5

Bad:

    M3 S100 M4
            ^^
    M7 M8
       ^^
    M0 M1
       ^^
    M48 M50 P0
        ^^^

Good:

    M3 S100 M8
    M7
    M8
"""

from collections.abc import Iterator

from deburr.fixers import split
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._words import clashes
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report each code behind the first of its group."""
    yield from clashes(line, "M", "write one of them on a line of its own")


fix = split
