"""Division by zero.

The control stops at the line with "Attempt to divide by zero". Reported where the line alone
decides the divisor, and where it is 0 on every way on which the program comes to the line, whatever
the inputs are; then the settings, conditions and calls are named that lead to it.

Source: spec/rs274.md §3.2

Bad:

    #1=[4/0]
          ^
    G0 X[#1/[2-2]]
            ^^^^^
    #2=[1/[-0.0]]
          ^^^^^^

Bad:

    #5=12
    o1 while [#5 GT 0]
      #5=[#5-4]
    o1 endwhile
    G0 X[#5420/#5]
               ^^

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
