"""Word in a table row.

A row is output as it stands; words in it are not replaced by their values.

Source: spec/cgt.md §5.7

Bad:

    @DCOMP
    0,G40
    1,G41 D#DOFF
           ^^^^^

Good:

    @DCOMP
    0,G40
    1,G41
    2,#100=42
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("row",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the word."""
    for part in node.children:
        if part.kind == "WORD":
            message = f"`{line.said(part)}` is output as it stands; a table row is text"
            yield Report(Span(part.start, part.end), message)
