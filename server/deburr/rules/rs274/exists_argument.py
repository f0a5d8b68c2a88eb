"""EXISTS of something that is no named parameter.

EXISTS asks whether a named parameter has been set. Of a numbered one LinuxCNC always says yes, or
no where there is no such number; that is a warning. Anything else stops it.

Source: spec/rs274.md §3.3

Bad:

    #1=EXISTS[1]
              ^
    #2=EXISTS[#1+1]
              ^^^^

Bad:

    #1=EXISTS[#1]
              ^^

Good:

    #1=EXISTS[#<depth>]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("exists",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the argument."""
    argument = node.children[2]
    span = Span(argument.start, argument.end)
    if not isinstance(argument, Node) or argument.kind != "param":
        yield Report(span, f"`{line.said(argument)}` is no named parameter `#<name>`; the control stops here")
    elif name(line, argument) is None:
        message = f"`{line.said(argument)}` is a numbered parameter; EXISTS only says something of those with a name"
        yield Report(span, message, severity=Severity.WARNING)
