"""What several rules on literal values share."""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.rs274 import constant
from deburr.rule import Line, Report
from deburr_grammar.dialects.rs274.names import name_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

NEAR = 1e-4
"""How near to an integer a value must be where one is required (spec/rs274.md §1.2)."""
_RUN = frozenset(("param", "exists"))


def faults(line: Line, node: Node, rule: str) -> Iterator[Report]:
    """The fault of that name for which an operation of its own is to blame, not one inside it."""
    value = constant(line.text, node, line.settings)
    if isinstance(value, ArithmeticFault) and value.rule == rule and _own(node, value):
        said = line.text[node.start : node.end]
        yield Report(Span(value.part.start, value.part.end), f"`{said}` is {value.why}; the control stops here")


def _own(node: Node, fault: ArithmeticFault) -> bool:
    """A division is blamed on its divisor, all else on the operation itself."""
    at_divisor = fault.rule == "divide-by-zero" and any(fault.part is child for child in node.children)
    return at_divisor or fault.part is node


def literal(part: Node | Token) -> bool:
    """Whether the value of a part hangs on numbers alone: on no parameter, which only the run knows."""
    return all(each.kind not in _RUN for each in walk(part))


def index(line: Line, param: Node) -> float | None:
    """The number of a numbered parameter if the line alone decides it."""
    value = constant(line.text, param.children[1], line.settings)
    # Four hundred digits make an infinite double; it is as far out of range as any, and can be rounded.
    return max(-1e300, min(value, 1e300)) if isinstance(value, float) else None


def name(line: Line, param: Node) -> str | None:
    """The name of a named parameter as the control compares it: lower case, without blanks; None for a numbered one."""
    said = param.children[1]
    if said.kind != "NAME":
        return None
    return name_of(line.text[said.start : said.end])


def asked(line: Line, param: Node) -> bool:
    """Whether a parameter is what an EXISTS asks for: then it is not read."""
    return any(exists.start <= param.start < exists.end for exists in line.node.find("exists"))


def given(analysis: Analysis) -> frozenset[str]:
    """The parameters that a run is given values for: names as the control compares them, and numbers."""
    return frozenset(map(name_of, analysis.inputs.define))
