"""Operator that does not exist.

The operators are `greaterthan`, `lessthan`, `equalto` and `notequalto`, in any case; they stand
between the two values. There are no signs. There is no operator for "at least" either: write the
lines twice, under `greaterthan` and under `equalto`. The condition cannot be decided, so nothing is
built.

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
    #IF1 |Dia| >= 10 n
               ^^
    #ENDIF1
    #IF1 equalto |Tool| 4 n
                 ^^^^^^
    #ENDIF1

Good:

    #IF1 |a| EqualTo 1 n
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.fixers import advised
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._words import MEANT, OPERATORS, OR_EQUAL
from deburr.suggest import suggestion
from deburr_grammar.dialects.metagcode.forms import condition
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the operator's place."""
    items = condition(node)
    operator = items.operator
    if operator.kind != "OPERATOR":
        said = line.said(operator)
        misplaced = [each for each in (line.said(items.left), line.said(items.right)) if each.lower() in OPERATORS]
        hint = f"`{misplaced[0]}` belongs between the two values" if misplaced else _hint(said.lower())
        yield Report(Span(operator.start, operator.end), f"`{said}` is no operator; {hint}")


def _hint(said: str) -> str:
    if said in MEANT:
        return f"did you mean `{MEANT[said]}`?"
    if said in OR_EQUAL:
        return f"write the lines twice, in an `#IF` with `{OR_EQUAL[said]}` and in one with `equalto`"
    near = suggestion(said, OPERATORS).removeprefix("; ")
    return near or "there are `greaterthan`, `lessthan`, `equalto` and `notequalto`"


fix = advised
