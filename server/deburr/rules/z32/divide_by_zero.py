"""Division by zero.

The control stops at a division by 0. Reported are divisors that are 0 whatever the parameters hold, and those that
are 0 on every way on which the program comes to the line; then the settings, conditions and calls are named that lead
to it.

Source: spec/z32.md §4

Bad:

    HA<1/0>
         ^
    X<Y/(2-2)>
        ^^^^^
    !HA=1/SN(180)!
          ^^^^^^^
    G1 X<60/(3-3)> F200
            ^^^^^

Good:

    G1 X<60/(4-1)> F200
    HA<1/0.5>
    X<0/2>
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._values import faults
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("product",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the divisor."""
    yield from faults(line, node, "divide-by-zero")
