"""Snippet reference without a name.

`#FILE` is followed by the name of a file in the folder of snippets.

Source: spec/metagcode.md §3, §6

Bad:

    #FILE
    ^^^^^

Good:

    #FILE drill.txt
    -- Snippets/drill.txt --
    G81 X0 Y0 Z-5 R2
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("file",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    if node.find("NAME") is None:
        yield Report(whole(node), f"`{line.said(node)}` names no snippet; write `{line.said(node)} name.txt`")
