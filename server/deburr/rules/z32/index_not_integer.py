"""Index of PAL or PAR that is no integer.

A rounded index could hit the wrong parameter, so one with decimals is refused. Reported where the line alone decides
it, and where it follows on every way on which the program comes to the line; then the settings, conditions and calls
are named that lead to it.

Source: spec/z32.md §5

Bad:

    PAR[1.5]1
        ^^^
    X<PAL[5/2]>
          ^^^

Good:

    PAR[1.0]1
    X<PAL[4/2]>
"""

from collections.abc import Iterator

from deburr.arithmetic.z32 import integer, shown
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import index, known
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("vector",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the index."""
    part = index(line, node)
    value = known(line, part)
    if value is not None and integer(value) is None:
        message = f"the index of `{line.said(node)}` is {shown(value)}, which is no integer; `NEI(...)` or `INT(...)` makes it one"
        yield Report(Span(part.start, part.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Round it to the nearest integer."""
    yield broken.replaced(f"NEI({broken.said})")
