"""Step type that is neither cumulative nor relative.

A loop fills in either the sum of the steps so far, for absolute moves, or the single step, for
relative ones: `c` or `r`, and letters may follow. One for the other cuts somewhere else.

Source: spec/metagcode.md §3, §6, §10

Bad:

    #LOOP1 |z| 2 x
                 ^
    #ENDLOOP1
    #LOOP1 |z| c 2
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

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._items import changed_places
from deburr.rules.metagcode._letters import lettered
from deburr_grammar.dialects.metagcode.forms import groups
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("header",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the step type's place."""
    for group in groups(node):
        if group.mode.kind != "MODE":
            said = line.said(group.mode)
            hint = "write `c` for cumulative or `r` for relative values"
            if changed_places(line, group):
                hint = f"maxStep and step type have changed places, write `{said} {line.said(group.step)}`"
            yield Report(Span(group.mode.start, group.mode.end), f"`{said}` is no step type; {hint}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the type that its first letter says, or let the two items change places."""
    yield from lettered(broken, "cr")
