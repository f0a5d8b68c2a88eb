"""More than 10 `(` open at once.

The control nests parentheses 10 deep, those of functions included, and refuses the line beyond
that. A part of the expression can be stored in a parameter before.

Source: spec/z32.md §7

Bad:

    HA<(((((((((((1)))))))))))>
                 ^^^
    !HA=SN(ABS((((((((((1)))))))))))!
                       ^^^

Good:

    HA<((((((((((1))))))))))>
    !HA=SN(ABS(((((((((1))))))))))!
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule, whole
from deburr.rules.z32._depth import beyond

DEPTH = 10


@rule(Severity.ERROR, Text(r"\((?:[^\n(]*\(){10}"))
def check(line: Line) -> Iterator[Report]:
    """Report each parenthesis that is one too deep."""
    for node in beyond(line.node.tree, ("group", "function"), DEPTH):
        yield Report(whole(node), f"`{line.said(node)}` is nested {DEPTH + 1} deep in `(`; the control takes {DEPTH}")
