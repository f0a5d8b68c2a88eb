"""Two signs before one value.

The control takes `X--1` for X1. Nearly always one of the signs was typed twice, and then the sign
of the value is wrong.

Source: spec/rs274.md §1.2

Bad:

    G0 X--1
        ^^
    G0 X- +3
        ^^^

Good:

    G0 X-1
    #1=[3--2]
    #2=1
    G0 X[#1+-#2]
    G0 X-[-#1]
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("signed",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the two signs. Behind an operator one sign is common, and what is read is what is meant."""
    value = node.children[1]
    if value.kind == "signed":
        pair = line.text[node.start : value.start + 1]
        said = line.text[value.start + 1 : value.end].strip()
        yield Report(Span(node.start, value.start + 1), f"`{said}` has two signs, `{pair}`; was one typed twice?")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write a sign once that stands there twice."""
    signs = broken.said.replace(" ", "")
    if len(set(signs)) == 1:
        yield broken.replaced(signs[0])
