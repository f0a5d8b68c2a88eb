"""Division by zero.

The control stops at the line with "Attempt to divide by zero". Reported where the line alone
decides the divisor.

Source: spec/rs274.md §3.2

Bad:

    #1=[4/0]
          ^
    G0 X[#1/[2-2]]
            ^^^^^
    #2=[1/[-0.0]]
          ^^^^^^

Good:

    #1=[4/0.5]
    #2=[0/4]
    #3=[1/SIN[180]]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import faults
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("quotient",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the divisor."""
    yield from faults(line, node, "divide-by-zero")
