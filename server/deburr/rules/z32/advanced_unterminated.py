"""Advanced line without its last `!`.

An advanced line starts and ends with `!`; the control refuses one that is never closed. A `;` with
no `!` behind it separates nothing.

Source: spec/z32.md §2

Bad:

    !X=0
    ^^^^
    N10 !HA=1;HB=2
        ^^^^^^^^^^
    !IF HA>10; HA=10
    ^^^^^^^^^^^^^^^^

Good:

    !X=0!
    N10 !HA=1;HB=2! ;two values
    !IF HA>10; HA=10!
"""

from collections.abc import Iterator

from deburr.fixers import closed
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import terminated, trailing_block
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the line."""
    if not terminated(node) and trailing_block(node) is None:
        yield Report(
            whole(node), "the advanced line is never closed and the control refuses it; `!` is missing at its end"
        )


fix = closed("!")
