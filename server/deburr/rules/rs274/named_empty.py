"""Parameter without a name.

`#<>` runs in LinuxCNC as a parameter of its own; nobody means it.

Source: spec/rs274.md §4.2

Bad:

    #<>=3
     ^^

Good:

    #<a>=3
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("param",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the empty name."""
    if name(line, node) == "":
        said = node.children[1]
        yield Report(
            Span(said.start, said.end), f"`{line.said(node)}` has an empty name; the control takes it for a parameter"
        )
