"""Call of a program whose number is no integer.

Programs of the memory are numbered with integers; the control stops at any other number. Reported where the line
alone decides it, and where it follows on every way on which the program comes to the line; then the settings,
conditions and calls are named that lead to it.

Source: spec/z32.md §6.4

Bad:

    !GOP<1.5>!
        ^^^^^
    !GOS2.5!
        ^^^

Good:

    !GOP<3/1.5>!
    :2
"""

from collections.abc import Iterator

from deburr.arithmetic.z32 import integer, shown
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import known
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("call",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number."""
    part = node.children[1]
    value = known(line, part)
    if value is not None and integer(value) is None:
        message = f"there is no program {shown(value)}: the number of a program is an integer; the control stops here"
        yield Report(Span(part.start, part.end), message)
