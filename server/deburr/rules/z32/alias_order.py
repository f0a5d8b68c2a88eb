"""G25 with the axes in an unusual order.

The manual shows G25XYZ, G25YZX and G25ZXY, which keep the coordinates right-handed; any other
order mirrors them or names other axes. It is read all the same.

Source: spec/z32.md §6.5

Bad:

    G25XZY
    ^^^^^^
    G25XYA
    ^^^^^^

Good:

    G25YZX
    G25ZXY
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._alias import ORDERS, axes
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("axis_alias",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the word."""
    named = axes(line, node)
    if named and set(named) <= set(line.settings["axes"].upper()) and named not in ORDERS:
        message = f"`{line.said(node)}` is no order that the manual shows ({', '.join(ORDERS)})"
        outcome = "the part may come out mirrored" if set(named) == set("XYZ") else "other axes move than it describes"
        yield Report(whole(node), f"{message}; {outcome}")
