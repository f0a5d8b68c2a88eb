"""Operator that does not exist.

The operators are `greaterthan`, `lessthan`, `equalto` and `notequalto`, in any case. There are no
signs, and no operator for "at least". The condition cannot be decided, so nothing is built.

Source: spec/metagcode.md §3, §6

Bad:

    #IF1 |a| = 1 n
             ^
    #ENDIF1
    #IF1 |a| equalsto 1 n
             ^^^^^^^^
    #ENDIF1
    #IF1 |a| |op| 1 n
             ^^^^
    #ENDIF1

Good:

    #IF1 |a| EqualTo 1 n
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.suggest import suggestion
from deburr_grammar.dialects.metagcode.forms import condition
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_OPERATORS = ("greaterthan", "lessthan", "equalto", "notequalto")
_SIGNS = {
    **dict.fromkeys(("=", "==", "eq", "is", "equals"), "equalto"),
    **dict.fromkeys(("<>", "!=", "ne", "not"), "notequalto"),
    **dict.fromkeys((">", "gt"), "greaterthan"),
    **dict.fromkeys(("<", "lt"), "lessthan"),
}


@rule(Severity.ERROR, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the operator's place."""
    operator = condition(node).operator
    if operator.kind != "OPERATOR":
        said = line.said(operator)
        yield Report(Span(operator.start, operator.end), f"`{said}` is no operator{_hint(said.lower())}")


def _hint(said: str) -> str:
    if said in _SIGNS:
        return f"; did you mean `{_SIGNS[said]}`?"
    return suggestion(said, _OPERATORS) or "; there are `greaterthan`, `lessthan`, `equalto` and `notequalto`"
