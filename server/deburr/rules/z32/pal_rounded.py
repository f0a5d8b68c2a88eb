"""Value with decimals stored in PAL.

PAL holds integers: the value is rounded to the nearest, halves away from 0. PAR keeps decimals. Reported where the
line alone decides it, and where it follows on every way on which the program comes to the line; then the settings,
conditions and calls are named that lead to it.

Source: spec/z32.md §5

Bad:

    PAL[1]2.5
          ^^^
    !PAL[1]=-7/2!
            ^^^^

Good:

    PAL[1]2.0 PAR[1]2.5
    !PAL[1]=NEI(7/2)!
"""

import re
from collections.abc import Iterator

from deburr.arithmetic.z32 import nearest, shown
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import is_pal, known, stored
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("vector",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the value."""
    part = stored(line, node) if is_pal(line, node) else None
    value = None if part is None else known(line, part)
    if part is not None and value is not None and nearest(value) != value:
        message = f"`{line.said(node)}` holds integers, so {shown(nearest(value))} is stored; PAR keeps decimals"
        yield Report(Span(part.start, part.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the integer that is stored."""
    stored = re.search(r"so (-?[0-9]+) is stored", broken.finding.message)
    if stored is not None:
        yield broken.replaced(stored[1])
