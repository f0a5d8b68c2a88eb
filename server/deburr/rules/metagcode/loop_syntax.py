"""Loop header that is not made of groups of three.

`#LOOP` takes groups of three items, set off by blanks: a variable, its maxStep, its step type.
`#ENDLOOP` takes nothing. With an item too few or too many the groups cannot be told apart.

Source: spec/metagcode.md §3, §6, §10

Bad:

    #LOOP1 |z| 2
    ^^^^^^^^^^^^
    G0 Z|z|
    #ENDLOOP1 x
              ^

Bad:

    #LOOP1
    ^^^^^^
    #ENDLOOP1
    #LOOP2 |z| 2 c |x|
    ^^^^^^^^^^^^^^^^^^
    #ENDLOOP2
    #LOOP3 |z|2 c
              ^
    #ENDLOOP3
    #LOOP4 |Run| 5 r |Drop| r
    ^^^^^^^^^^^^^^^^^^^^^^^^^
    #ENDLOOP4

Good:

    #LOOP1 |z| 2 c |x| |Max| r
    G0 X|x| Z|z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._items import misfit, surplus
from deburr_grammar.tree import Node

_ITEMS = ("a variable", "its maxStep", "its step type (`c` cumulative, `r` relative)")


@rule(Severity.ERROR, Nodes(("loop", "endloop"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what does not fit."""
    found = surplus(line, node) if node.kind == "endloop" else misfit(line, node, "header", _ITEMS)
    if found is not None:
        yield Report(*found)


def fix(broken: Broken) -> Iterator[Fix]:
    """Set items off by blanks, leave out what is too much."""
    if "must be set off" in broken.finding.message:
        yield broken.inserted(broken.span.start, " ")
    elif "takes nothing" in broken.finding.message:
        yield broken.deleted(*broken.span)
