"""Texts that differ only in case.

An alpha comparison tells upper case from lower case: only the operator may be written in any case.
Two values that differ in nothing else are different, so `equalto` never holds for them, which is
seldom what was meant.

Source: spec/metagcode.md §5.3, §6

Bad:

    #IF1 steel equalto Steel a
         ^^^^^^^^^^^^^^^^^^^
    #ENDIF1

Bad (variables=part.vars):

    #IF1 |Mat| EqualTo Steel a
         ^^^^^^^^^^^^^^^^^^^
    S800
    #ENDIF1
    -- part.vars --
    Mat=STEEL

Good (variables=part.vars):

    #IF1 |Mat| EqualTo Steel a
    S800
    #ENDIF1
    #IF1 |Coolant| EqualTo flood a
    M8
    #ENDIF1
    -- part.vars --
    Mat=Steel
    Coolant=mist
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import condition, is_numeric
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("condition",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the two values."""
    left, _, right, type_ = condition(node)
    if "VARIABLE" in (left.kind, right.kind) or type_.kind != "TYPE" or is_numeric(line.said(type_)):
        return
    one, two = line.said(left), line.said(right)
    if one != two and one.casefold() == two.casefold():
        yield Report(
            Span(left.start, right.end), f"`{one}` and `{two}` are different texts: upper and lower case count"
        )
