"""Function or power of a value it does not take.

SQRT of a negative number, LN of a number that is not above 0, ACOS and ASIN outside -1 to 1, and a
negative number raised to a power that is no integer stop the control. Reported where the line alone
decides it, and where it follows on every way on which the program comes to the line.

Source: spec/rs274.md §3.2, §3.3

Bad:

    #1=SQRT[-1]
       ^^^^^^^^
    #2=LN[0]
       ^^^^^
    #3=ACOS[1.1]
       ^^^^^^^^^
    #4=[-8 ** 0.5]
        ^^^^^^^^^

Bad:

    #5=#5420
    o1 if [#5 GT 10]
      G0 XSQRT[10-#5]
          ^^^^^^^^^^^
    o1 endif

Good:

    #1=SQRT[0]
    #3=ACOS[1]
    #4=[[-8]**2]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import faults, literal
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function", "power"), where=lambda _, node: literal(node)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the operation."""
    yield from faults(line, node, "domain")
