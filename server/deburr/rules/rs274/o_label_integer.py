"""O-word number that is no integer.

An O-word's number must be an integer; the control stops with "Non integer value for integer".

Source: spec/rs274.md §6

Bad:

    o1.5 call
     ^^^

Good:

    o1.0 if [1]
    o1 endif
    o<hole 1.5> if [1]
    o<hole 1.5> endif
"""

from collections.abc import Iterator
from math import isfinite

from deburr.arithmetic.rs274 import constant
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


def _may(line: Line, node: Node) -> bool:
    only = node.children[0]
    return not isinstance(only, Token) or "." in line.said(only)


@rule(Severity.ERROR, Nodes(("label",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number."""
    number = constant(line.text, node, line.settings)
    if isinstance(number, float) and isfinite(number) and abs(number - round(number)) > NEAR:
        yield Report(Span(node.start, node.end), f"`{line.said(node)}` is no integer; an O-word's number must be one")
