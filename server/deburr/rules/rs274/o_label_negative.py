"""Negative number as the label of an O-word.

LinuxCNC runs it, but no manual knows it. Most likely the sign is a slip, and the label meant is
another one.

Source: spec/rs274.md §6

Bad:

    o-1 if [1]
     ^^
    o-1 endif
     ^^

Good:

    o1 if [1]
    o1 endif
    o[3-2] if [1]
    o[3-2] endif
"""

from collections.abc import Iterator

from deburr.arithmetic.rs274 import constant
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


def _may(_line: Line, node: Node) -> bool:
    return not isinstance(node.children[0], Token)


@rule(Severity.WARNING, Nodes(("label",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the label."""
    value = constant(line.text, node, line.settings)
    if isinstance(value, float) and value < 0 and abs(value - round(value)) <= NEAR:
        yield Report(Span(node.start, node.end), f"`{line.said(node)}` is negative; no manual knows such labels")
