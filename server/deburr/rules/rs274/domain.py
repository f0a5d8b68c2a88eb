"""Function or power of a value it does not take.

SQRT of a negative number, LN of a number that is not above 0, ACOS and ASIN outside -1 to 1, and a
negative number raised to a power that is no integer stop the control.

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
