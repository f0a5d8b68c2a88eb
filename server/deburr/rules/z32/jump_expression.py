"""Jump to a calculated block number.

Reading it is an extension; a control may take only a number behind GON.

Source: spec/z32.md §3

Bad:

    !GON<HA>!
        ^^^^
    !GON10-N<HA>!
            ^^^^
    N10 G0 X1

Good:

    !GON10!
    N10 G0 X1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("jump",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the expressions."""
    end = node.node("range_end")
    for part in (node.node("angle"), end.node("angle") if end else None):
        if part is not None:
            yield Report(whole(part), f"the jump goes to `{line.said(part)}`; a control may take only a number here")
