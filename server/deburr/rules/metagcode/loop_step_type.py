"""Step type that is neither cumulative nor relative.

A loop fills in either the sum of the steps so far, for absolute moves, or the single step, for
relative ones: `c` or `r`, and letters may follow. One for the other cuts somewhere else.

Source: spec/metagcode.md §3, §6, §10

Bad:

    #LOOP1 |z| 2 x
                 ^
    #ENDLOOP1
    #LOOP1 |z| 2 c1 |x| |y| |r|
                 ^^         ^^^
    G0 X|x| Z|z|
    #ENDLOOP1

Good:

    #LOOP1 |z| 2 Cumulative |x| 1 r
    G0 X|x| Z|z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import groups
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("header",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the step type's place."""
    for group in groups(node):
        if group.mode.kind != "MODE":
            yield Report(
                Span(group.mode.start, group.mode.end),
                f"`{line.said(group.mode)}` is no step type; write `c` for cumulative or `r` for relative values",
            )
