"""Block and advanced line on one line.

A line is either a block with words or an advanced line; the control does not read the two together
and refuses the line.

Source: spec/z32.md §1

Bad:

    G0 X1 !HA=1!
          ^^^^^^
    !HA=1! G0 X1
           ^^^^^
    G0 X1 !
          ^

Good:

    !HA=1!
    G0 X1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import deleted, split
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import trailing_block
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("mixed", "advanced")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the part that came second."""
    if node.kind == "mixed":
        yield Report(whole(node), "an advanced line cannot stand behind words; it needs a line of its own")
    elif (block := trailing_block(node)) is not None:
        yield Report(
            whole(block), f"`{line.said(block)}` stands behind an advanced line; words need a line of their own"
        )


def fix(broken: Broken) -> Iterator[Fix]:
    """Write both on lines of their own, or take out a lone sign."""
    yield from deleted(broken) if broken.said == "!" else split(broken)
