"""Directive without its number.

`#IF`, `#ENDIF`, `#LOOP` and `#ENDLOOP` carry a number directly behind the word, with no blank: it
ties the two ends of a block together. Without it an end fits any block, and a block that was
closed in the wrong place is not noticed.

Source: spec/metagcode.md §2, §6

Bad:

    #IF |a| equalto 1 n
    ^^^
    #ENDIF
    ^^^^^^

Bad:

    #LOOP 1 |z| 2 c
    ^^^^^
    G0 Z|z|
    #ENDLOOP-1
    ^^^^^^^^

Good:

    #LOOP07 |z| 2 c
    G0 Z|z|
    #ENDLOOP07
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("if", "endif", "loop", "endloop"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    if node.find("LABEL") is None:
        keyword = node.children[0]
        word = line.said(keyword)
        yield Report(
            Span(keyword.start, keyword.end),
            f"`{word}` has no number, so nothing ties it to its other end; write it as in `{word}1`, with no blank",
        )
