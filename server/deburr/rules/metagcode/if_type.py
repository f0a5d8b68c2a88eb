"""Comparison type that is neither alpha nor numeric.

The type decides whether `10` is greater than `9`: as numbers it is, as text it is not. It is `a` or
`n`, and letters may follow. Anything else leaves the comparison open, so nothing is built.

Source: spec/metagcode.md §3, §6, §10

Bad:

    #IF1 |a| equalto 1 text
                       ^^^^
    #ENDIF1
    #IF1 |a| equalto 1 n1
                       ^^
    #ENDIF1
    #IF1 |a| equalto 1 |t|
                       ^^^
    #ENDIF1

Good:

    #IF1 |a| equalto 1 Numeric
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import condition
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the type's place."""
    type_ = condition(node).type
    if type_.kind != "TYPE":
        yield Report(
            Span(type_.start, type_.end),
            f"`{line.said(type_)}` is no type; write `a` to compare as text or `n` to compare as numbers",
        )
