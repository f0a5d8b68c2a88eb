"""Variable that a loop counts twice.

Each variable of a loop has one total and is divided into steps once. Counted twice, it would have
two values in the same pass.

Source: spec/metagcode.md §4, §6

Bad:

    #LOOP1 |z| 2 c |z| 1 r
                   ^^^
    #ENDLOOP1
    #LOOP1 |x| 2 c | x | 2 c
                   ^^^^^
    G0 X|x|
    #ENDLOOP1

Good:

    #LOOP1 |z| 2 c |Z| 1 r
    G0 Z|z| W|Z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import counters, groups
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("header",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report each variable that is named again."""
    seen: set[str] = set()
    for name, token in counters(line.node):
        if name in seen:
            yield Report(
                Span(token.start, token.end),
                f"`|{name}|` is counted by this loop already; it would have two values in one pass",
            )
        seen.add(name)


def fix(broken: Broken) -> Iterator[Fix]:
    """The variable is counted as it is named first: its second maxStep and step type go with it."""
    for header in broken.node.find("header"):
        for group in groups(header):
            if group.counter.start == broken.span.start:
                yield broken.deleted(group.counter.start, group.mode.end)
