"""Negative step.

maxStep is the greatest step allowed, a magnitude. Its sign is ignored: which way the loop goes is
decided by the sign of the variable. Who writes a sign may expect it to turn the direction round.

It is also said where the conditions around the line make it so for every value that is given.

Source: spec/metagcode.md §5.4, §6

Bad:

    #LOOP1 |z| -2 c
               ^^
    #ENDLOOP1

Bad (variables=part.vars):

    #LOOP1 |Depth| |Step| c
                   ^^^^^^
    G1 Z-|Depth|
    #ENDLOOP1
    -- part.vars --
    Depth=6
    Step=-2

Good:

    #LOOP1 |z| +2 c
    G0 Z-|z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.fixers import advised, safe
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import groups, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("header",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the step."""
    for group in groups(node):
        step = number(line.said(group.step))
        if step is not None and step < 0:
            said = line.said(group.step)
            yield Report(
                Span(group.step.start, group.step.end),
                f"the sign of `{said}` is ignored; the direction is that of the variable, write `{said[1:]}`",
            )


fix = safe(advised)
