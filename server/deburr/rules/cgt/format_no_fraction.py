"""Format without decimals for a position.

Every position is rounded to whole units when it is output, so the part is cut at other places
than it was drawn.

Source: spec/cgt.md §7

Bad:

    #FMT(#XPOS,T4.0)
               ^^^^
    #FMT(#F_Decimal,D5.0)
                    ^^^^

Good:

    #FMT(#XPOS,T4.3)
    #FMT(#SPEED,T5.0)
"""

import re
from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_POSITION = re.compile("(?i:#[XYZ](?:POS|ST|CTR))|#F_Decimal")
_WHOLE = re.compile(r"[DFTLPZE][+!]?[0-9]+\.0+")


@rule(Severity.INFO, Nodes(("fmt",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the format."""
    word = line.said(node.children[2])
    said = node.children[4]
    if _POSITION.fullmatch(word) and _WHOLE.fullmatch(line.said(said)):
        yield Report(
            Span(said.start, said.end), f"`{line.said(said)}` rounds `{word}` to whole units; give it decimals"
        )
