"""Two G codes of one modal group on a line.

Codes of one group exclude each other: only one motion, one plane, one unit of length can be
meant. The control stops with "Two g codes used from same modal group". `G80` alone may stand
beside another motion code, which then wins.

Source: spec/rs274.md §5

Bad:

    G0 G1 X1 F100
       ^^
    G90 G91
        ^^^
    G54 G17 G55
            ^^^
    G28 G53 G0 X1
        ^^^
    G0 X1 G1 Y2 F100
          ^^

Good:

    G90 G21 G17 G40 G49 G80 G94
    G80 G0 X1
"""

from collections.abc import Iterator

from deburr.fixers import either
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._parting import copy_left_out, group_parted
from deburr.rules.rs274._words import clashes
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report each code behind the first of its group."""
    yield from clashes(line, "G", "the control takes one of them on a line")


fix = either(group_parted, copy_left_out)
