"""G code with a calculated number.

Which G code a block holds must stand in the program; the control takes no expression there.

Source: spec/z32.md §2

Bad:

    G<HA>
     ^^^^
    X1 G<1+1>
        ^^^^^

Good:

    G1 X<HA> F100
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("computed",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the expression."""
    yield Report(whole(node), f"a G code is always a number; the control takes no `{line.said(node)}` behind `G`")
