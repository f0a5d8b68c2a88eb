"""EXISTS of something that is no named parameter.

EXISTS asks whether a named parameter has been set. Of a numbered one LinuxCNC always says yes, and
anything else stops it.

Source: spec/rs274.md §3.3

Bad:

    #1=EXISTS[1]
              ^
    #2=EXISTS[#1]
              ^^

Good:

    #1=EXISTS[#<depth>]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("exists",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the argument."""
    argument = node.children[2]
    if not isinstance(argument, Node) or argument.kind != "param" or name(line, argument) is None:
        yield Report(
            Span(argument.start, argument.end),
            f"`{line.said(argument)}` is no named parameter; EXISTS only asks for those",
        )
