"""What several rules on literal values share."""

from collections.abc import Iterator

from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.z32 import constant
from deburr.rule import Line, Report
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


def faults(line: Line, node: Node, rule: str) -> Iterator[Report]:
    """The fault of that name for which this operation is to blame, not one inside it."""
    value = constant(line.text, node)
    if isinstance(value, ArithmeticFault) and value.rule == rule and _own(node, value):
        message = f"`{line.said(value.part)}` is {value.why}; the control stops here"
        if rule == "divide-by-zero":
            message = f"`{line.said(value.part)}` is 0; the control stops at a division by zero"
        yield Report(Span(value.part.start, value.part.end), message)


def _own(node: Node, fault: ArithmeticFault) -> bool:
    """A division blames its divisor, everything else itself."""
    blamed = node.children if fault.rule == "divide-by-zero" else (node,)
    return any(fault.part is part for part in blamed)


def known(line: Line, part: Node | Token) -> float | None:
    """The value of a part if the line alone decides it."""
    value = constant(line.text, part)
    return value if isinstance(value, float) else None


def index(line: Line, vector: Node) -> Node | Token:
    """What stands between the brackets of a PAL or PAR."""
    return vector.children[2]


def is_pal(line: Line, vector: Node) -> bool:
    """Whether the vector is PAL and not PAR."""
    return line.text[vector.start : vector.start + 3].upper() == "PAL"


def stored(line: Line, vector: Node) -> Node | Token | None:
    """The value that the line stores in a PAL or PAR; None where it is read."""
    for part in line.node.find("word", "assign"):
        if part.children[0] == vector:
            return part.children[-1]
    return None
