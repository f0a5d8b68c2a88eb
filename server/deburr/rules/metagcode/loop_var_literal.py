"""Loop variable without bars.

What a loop counts must be written as it is in the G-code, between bars, so that it can be filled in
there. A bare word is a value, and a value cannot be divided into steps.

Source: spec/metagcode.md §4, §6

Bad:

    #LOOP1 Z 2 c
           ^
    #ENDLOOP1
    #LOOP1 |x| 2 c 10 1 r
                   ^^
    G0 X|x|
    #ENDLOOP1

Good:

    #LOOP1 |Z| 2 c
    G0 Z|Z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.fixers import advised
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import groups
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("header",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report each bare word."""
    for group in groups(node):
        if group.counter.kind != "VARIABLE":
            said = line.said(group.counter)
            yield Report(
                Span(group.counter.start, group.counter.end),
                f"`{said}` is no variable, so the loop has nothing to count; write `|{said}|`",
            )


fix = advised
