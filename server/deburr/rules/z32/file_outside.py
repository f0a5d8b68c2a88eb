"""File call that leaves the file root.

Files are called from below the file root. A path with more `..` than folders leads out of it, where
the control does not look: it stops.

Source: spec/z32.md §6.4

Bad:

    !:L254-..\\X!
           ^^^^
    !:L254-A/../../X!
           ^^^^^^^^^

Good:

    !:L254-A/../X!
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("file_call",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the path."""
    path, depth = node.children[1], 0
    for part in line.said(path).replace("\\", "/").split("/"):
        depth += -1 if part == ".." else part not in ("", ".")
        if depth < 0:
            yield Report(
                Span(path.start, path.end),
                f"`{line.said(path)}` leads out of the file root; the control finds no file there",
            )
            return
