"""Words in an advanced line.

No movement can be programmed between `!` and `!`. `X=10` only stores the value; a move is a
block of its own.

Source: spec/z32.md §6.2

Bad:

    !G0 X1!
     ^^^^^
    !X10!
     ^^^
    !IF HA>1; Y<HA>; EB! HA=2!
              ^^^^^

Good:

    !X=10!
    G0 X<X>
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import groups, trailing_block
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the words."""
    trailing = trailing_block(node)
    for field in (field for group in groups(node) for field in group):
        if field.kind == "movement" and field is not trailing:
            message = f"`{line.said(field)}` cannot stand in an advanced line, which moves nothing"
            yield Report(whole(field), f"{message}; write `=` to store a value, or a block of its own")
