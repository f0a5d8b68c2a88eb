"""Value stored in PAL[256] to PAL[512].

The logic of the machine writes these; a program can only read them, and the control stops where it tries to store a
value. Reported where the line alone decides it, and where it follows on every way on which the program comes to the
line; then the settings, conditions and calls are named that lead to it.

Source: spec/z32.md §5

Bad:

    PAL[256]1
    ^^^^^^^^
    !PAL[512]=1!
     ^^^^^^^^
    PAL[255+1]<HA>
    ^^^^^^^^^^

Good:

    PAL[255]1 PAR[256]1
    !IF PAL[256]=1; EB! HA=2!
"""

from collections.abc import Iterator

from deburr.arithmetic.z32 import integer
from deburr.expand.z32.state import LAST, MACHINE
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._values import index, is_pal, known, stored
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("vector",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the parameter."""
    value = known(line, index(line, node))
    number = None if value is None else integer(value)
    if number is not None and MACHINE <= number <= LAST and is_pal(line, node) and stored(line, node) is not None:
        message = (
            f"`{line.said(node)}` is written by the machine only; the control stops here, PAL[0] to PAL[255] are free"
        )
        yield Report(whole(node), message)
