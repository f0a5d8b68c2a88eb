"""Comparison or step by something that is no number.

A numeric comparison and a loop calculate, so their values must be plain decimal numbers: digits, a
point, a sign. There is no exponent and no decimal comma. Here the value is written in the program,
so the line fails on every run.

Source: spec/metagcode.md §5.3, §6, §10

Bad:

    #IF1 Steel equalto 1 n
         ^^^^^
    #ENDIF1
    #IF1 1,5 lessthan 1e9 n
         ^^^          ^^^
    #ENDIF1
    #LOOP1 |z| two c
               ^^^
    G0 Z|z|
    #ENDLOOP1

Good:

    #IF1 |Mat| equalto Steel a
    #ENDIF1
    #IF1 -1. lessthan +.5 n
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import condition, groups, is_numeric, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


@rule(Severity.ERROR, Nodes(("condition", "header"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the values that are no numbers."""
    for value in _values(line, node):
        if value.kind != "VARIABLE" and number(line.said(value)) is None:
            yield Report(
                Span(value.start, value.end),
                f"`{line.said(value)}` is no number, so there is nothing to calculate with",
            )


def _values(line: Line, node: Node) -> list[Token]:
    if node.kind == "header":
        return [group.step for group in groups(node)]
    left, _, right, type_ = condition(node)
    return [left, right] if type_.kind == "TYPE" and is_numeric(line.said(type_)) else []
