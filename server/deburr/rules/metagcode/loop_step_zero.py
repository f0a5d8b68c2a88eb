"""Step of zero.

The number of passes is the total divided by maxStep, so with a maxStep of 0 there is none and nothing
is built. It is an error even if the total is 0 as well.

It is also said where the conditions around the line make it so for every value that is given.

Source: spec/metagcode.md §5.4, §6, §10

Bad:

    #LOOP1 |z| 0 c
               ^
    #ENDLOOP1
    #LOOP1 |z| -0.00 c |x| 1 c
               ^^^^^
    G0 X|x| Z|z|
    #ENDLOOP1

Bad (variables=part.vars):

    #LOOP1 |Depth| |Step| c
                   ^^^^^^
    G1 Z-|Depth|
    #ENDLOOP1
    -- part.vars --
    Depth=0
    Step=0.0

Good:

    #LOOP1 |z| 0.01 c
    G0 Z|z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import groups, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("header",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the step."""
    for group in groups(node):
        if number(line.said(group.step)) == 0:
            yield Report(
                Span(group.step.start, group.step.end),
                f"with a step of `{line.said(group.step)}` there is no number of passes; write one greater than 0",
            )
