"""Blank between two digits of a number.

Blanks mean nothing to the control, not even inside a number: `X1 2` is X12. Often the letter of a
second word is lost there, or an operator.

Source: spec/rs274.md §1.2

Bad:

    G0 X1 2
        ^^^
    #1=[1 2]
        ^^^
    G0 X0.12 5
        ^^^^^^

Good:

    G0 X 12
    G0 X1 Y2
    #1 = 12
"""

import re
from collections.abc import Iterator

from deburr.fixers import corrected
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, tokens

_JOINED = re.compile(r"[0-9][ \t]+[0-9]")


@rule(Severity.WARNING, Nodes(("line",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number; in a line that cannot be read, what is wrong has been said."""
    if line.node.problems or not _JOINED.search(line.text):
        return
    for token in tokens(node):
        said = line.said(token)
        if token.kind == "NUMBER" and _JOINED.search(said):
            message = f"`{said}` is read as `{''.join(said.split())}`: blanks inside a number mean nothing"
            yield Report(Span(token.start, token.end), message)


fix = corrected
