"""Declaration outside `@DECLARE`.

Words are declared once, before anything runs. In any other section the generator does not know
the command.

Source: spec/cgt.md §5.1

Bad:

    #INT #a
    ^^^^^^^

Good:

    @DECLARE
    #INT #a
    @
    @DWELL
    #a
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("declaration",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the declaration."""
    if line.node.reading.name != "declare":
        message = f"`{line.said(node)}` declares outside `@DECLARE`; move it there"
        yield Report(Span(node.start, node.end), message)
