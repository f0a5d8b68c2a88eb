"""What the rules on literal values share."""

from collections.abc import Iterator

from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.cgt import constant
from deburr.rule import Line, Report
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


def faults(line: Line, node: Node, rule: str) -> Iterator[Report]:
    """The fault of that name for which the operation itself is to blame, not one inside it."""
    value = constant(line.text, node)
    if isinstance(value, ArithmeticFault) and value.rule == rule and _own(line.text, node, value.part):
        said = line.text[node.start : node.end]
        yield Report(Span(value.part.start, value.part.end), f"`{said}` is {value.why}; it has no value")


def _own(text: str, node: Node, part: Node | Token) -> bool:
    """A fault lies in the operation, or in an operand that has a value of its own."""
    return part is node or (any(part is child for child in node.children) and isinstance(constant(text, part), float))
