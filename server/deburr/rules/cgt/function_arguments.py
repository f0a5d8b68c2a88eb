"""Function with too few or too many arguments.

Each function takes a fixed number of arguments, separated by commas.

Source: spec/cgt.md §5.8, §11

Bad:

    #EVAL(#V1=MAX(1))
              ^^^^^^
    #EVAL(#V1=MAX(1,2,3))
              ^^^^^^^^^^
    #EVAL(#V1=PI(1)+SQR())
              ^^^^^
                    ^^^^^

Good:

    #EVAL(#V1=MAX(1,MIN(#V2,3))+PI()*PI+TOTEL())
"""

from collections.abc import Iterator

from deburr.arithmetic.cgt import arguments_of
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.templates.symbols import functions
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the call."""
    name = line.said(node.children[0]).upper()
    fewest, most = functions().get(name, (0, len(arguments_of(node))))
    count = len(arguments_of(node))
    if not fewest <= count <= most:
        takes = "no argument" if not most else "one argument" if most == 1 else f"{most} arguments"
        yield Report(Span(node.start, node.end), f"`{name}` takes {takes}, not {count}")
