"""Directive that is not the first thing on its line.

Directives are found at the start of a line only. Behind anything else, even a line number, the word
is G-code text: it goes to the control as it is, and the block or snippet it was meant for is not
there.

Source: spec/metagcode.md §2, §6

Bad:

    G0 X1 #FILE a.txt
          ^^^^^
    N10 #IF1 |a| equalto 1 n
        ^^^

Good:

      #IF1 |a| equalto 1 n
      #ENDIF1
    G0 X1 (no #FILE here)
    #<file>=#1 ; nor an #ENDIF1
"""

from collections.abc import Iterator

from deburr.fixers import split
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("embedded",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    yield Report(
        whole(node),
        f"`{line.said(node)}` works only as the first thing on its line; here it goes to the control as text",
    )


fix = split
