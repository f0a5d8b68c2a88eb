"""Function of a value that it does not take.

RQ of a negative number, TAN of an odd multiple of 90 degrees, and a result too large for a number stop the control.
Reported where the line alone decides it, and where it follows on every way on which the program comes to the line;
then the settings, conditions and calls are named that lead to it.

Source: spec/z32.md §4, §11

Bad:

    HA<RQ(-1)>
       ^^^^^^
    X<1+RQ(2-3)>
        ^^^^^^^
    !HA=TAN(-90)!
        ^^^^^^^^
    HB<TAN(270)>
       ^^^^^^^^

Good:

    HA<RQ(0)>
    !HA=TAN(89)+TAN(180)!
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import faults
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function", "product", "sum")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the operation."""
    yield from faults(line, node, "domain")
