"""Comparison of a comparison.

`[3 GT 2 GT 1]` is no range: the first comparison gives 1 or 0, and that is compared with the last
value. Here 1 GT 1 is 0.

Source: spec/rs274.md §3.1

Bad:

    #1=[3 GT 2 GT 1]
        ^^^^^^
    o1 if [0 LE #1 LT 5]
           ^^^^^^^
    o1 endif

Good:

    #1=[3 GT 2 AND 2 GT 1]
    #2=[[#1 GT 2] EQ [#1 GT 1]]
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("comparison",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the inner comparison."""
    inner = node.children[0]
    if inner.kind == "comparison":
        message = f"`{line.said(inner)}` is 1 or 0, and only that is compared again; join two comparisons with AND"
        yield Report(Span(inner.start, inner.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Compare twice, and join the comparisons with AND."""
    start, end = broken.span
    outer = next((each for each in broken.node.find("comparison") if each.start == start and each.end > end), None)
    inner = outer.children[0] if outer is not None else None
    if isinstance(inner, Node) and len(inner.children) == 3:
        middle = inner.children[2]
        yield broken.inserted(end, f" AND {broken.text[middle.start : middle.end]}")
