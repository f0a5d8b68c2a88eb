"""Division by a literal zero.

The control stops at the line with "Attempt to divide by zero".

Source: spec/rs274.md §3.2

Bad:

    #1=[4/0]
          ^
    G0 X[1/[-0.0]]
           ^^^^^^

Good:

    #1=[4/0.5]
"""

from collections.abc import Iterator

from deburr_grammar.tree import Node, Token

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span


@rule(Severity.ERROR, Nodes(("quotient",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the divisor."""
    divisor = node.children[-1]
    if _is_zero(line, divisor):
        yield Report(Span(divisor.start, divisor.end), f"`{line.said(divisor)}` is 0; the control stops at a division by zero")


def _is_zero(line: Line, part: Node | Token) -> bool:
    if isinstance(part, Token):
        return part.kind == "NUMBER" and not float(line.said(part).replace(" ", "").replace("\t", ""))
    if part.kind == "signed":
        return _is_zero(line, part.children[1])
    return part.kind == "group" and _is_zero(line, part.children[1])
