"""TAN of a right angle.

TAN[90] is infinite. The control gives a number of 20 digits instead of an error, and goes on with it.

Source: spec/rs274.md §3.3

Bad:

    #1=TAN[90]
       ^^^^^^^
    #1=TAN[-270]
       ^^^^^^^^^
    #2=TAN[#1] #3=TAN[45*2]
                  ^^^^^^^^^

Good:

    #1=TAN[89.9]
    #1=TAN[180]
    #1=SIN[90]
"""

import math
from collections.abc import Iterator

from deburr.arithmetic.rs274 import constant, spelled
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import literal
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_NEAR = math.degrees(1e-12)


def _may(line: Line, node: Node) -> bool:
    return spelled(line.text, node.children[0]) == "TAN" and literal(node)


@rule(Severity.WARNING, Nodes(("function",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the function."""
    name, argument = node.children
    if spelled(line.text, name) != "TAN":
        return
    angle = constant(line.text, argument, line.settings)
    if isinstance(angle, float) and abs(math.fmod(abs(angle), 180.0) - 90.0) < _NEAR:
        message = f"`{line.said(node)}` is infinite; the control goes on with a number of 20 digits"
        yield Report(Span(node.start, node.end), message)
