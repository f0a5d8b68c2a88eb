"""Index of PAL or PAR outside 0 to 512.

There are PAL[0] to PAL[512] and PAR[0] to PAR[512]; the control stops at any other index. Reported where the line
alone decides it, and where it follows on every way on which the program comes to the line; then the settings,
conditions and calls are named that lead to it.

Source: spec/z32.md §5

Bad:

    PAL[513]1
        ^^^
    PAR[-1]1
        ^^
    X<PAR[500+13]>
          ^^^^^^

Good:

    PAR[512]1 PAL[0]1
    X<PAR[500+12]>
"""

from collections.abc import Iterator

from deburr.arithmetic.z32 import integer
from deburr.expand.z32.state import LAST
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import index, known
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("vector",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the index."""
    part = index(line, node)
    value = known(line, part)
    number = None if value is None else integer(value)
    if number is not None and not 0 <= number <= LAST:
        message = f"`{line.said(node)}` does not exist: the index goes from 0 to {LAST}, this one is {number}"
        yield Report(Span(part.start, part.end), message)
