"""Comparison or step by something that is no number.

A numeric comparison and a loop calculate, so their values must be plain decimal numbers: digits, a
point, a sign. There is no exponent and no decimal comma. A value that is written in the program
fails on every run, one that a variable has on the run that reaches the line.

Source: spec/metagcode.md §5.3, §6, §10

Bad:

    #IF1 Steel equalto 1 n
         ^^^^^
    #ENDIF1
    #IF1 1,5 lessthan 1e9 n
         ^^^          ^^^
    #ENDIF1
    #LOOP1 |Depth| 2mm c
                   ^^^
    G1 Z-|Depth|
    #ENDLOOP1
    #LOOP1 |z| two c
               ^^^
    G0 Z|z|
    #ENDLOOP1

Bad (variables=part.vars):

    #IF1 |Cut| equalto no a
    #LOOP1 |Depth| |Step| c
                   ^^^^^^
    G1 Z-|Depth|
    #ENDLOOP1
    #ENDIF1
    -- part.vars --
    Cut=no
    Depth=6
    Step=1,5

Good (variables=part.vars):

    #IF1 |Cut| equalto yes a
    #LOOP1 |Depth| 2 c
    G1 Z-|Depth|
    #ENDLOOP1
    #ENDIF1
    -- part.vars --
    Cut=no
    Depth=none

Good:

    #IF1 |Mat| equalto Steel a
    #ENDIF1
    #IF1 -1. lessthan +.5 n
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.arithmetic.metagcode import number_meant
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import advised
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._items import changed_places
from deburr.rules.metagcode._words import OPERATORS
from deburr_grammar.dialects.metagcode.forms import condition, groups, is_numeric, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


@rule(Severity.ERROR, Nodes(("condition", "header"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the values that are no numbers."""
    text = "; write `a` for the type to compare texts" if node.kind == "condition" else ""
    for value in _values(line, node):
        said = line.said(value)
        if value.kind != "VARIABLE" and number(said) is None:
            message = f"`{said}` is no number, so there is nothing to calculate with{number_meant(said) or text}"
            yield Report(Span(value.start, value.end), message)


def _values(line: Line, node: Node) -> list[Token]:
    """The items that must be numbers, but for those in whose place stands what another rule says."""
    if node.kind == "header":
        return [group.step for group in groups(node) if not changed_places(line, group)]
    items = condition(node)
    if items.type.kind != "TYPE" or not is_numeric(line.said(items.type)):
        return []
    misplaced = OPERATORS if items.operator.kind != "OPERATOR" else ()
    return [value for value in (items.left, items.right) if line.said(value).lower() not in misplaced]


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the number that is meant; what a variable holds is written elsewhere."""
    if "|" not in broken.said:
        yield from advised(broken)
