"""Parameter number that is no integer.

A parameter's number must be within 0.0001 of an integer; the control stops with "Non integer
value for integer".

Source: spec/rs274.md §1.2

Bad:

    #1.5=3
     ^^^
    G0 X#[3/2]
         ^^^^^
    #1.0002=3
     ^^^^^^

Good:

    #1.00009=3
    #[4/2]=1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR, asked, index
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("param",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number."""
    number = index(line, node)
    if number is not None and abs(number - round(number)) > NEAR and not asked(line, node):
        said = node.children[1]
        yield Report(Span(said.start, said.end), f"`{line.said(said)}` is no integer; a parameter's number must be one")
