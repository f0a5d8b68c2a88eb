"""Motion code beside a code that takes the axis words itself.

`G10`, `G28`, `G30`, `G52` and `G92` use the axis words of their line for something else than the
motion code does, so the two may not share a line. The control stops with "Cannot use two g codes
that both use axis values". The motion in force is no matter: it only waits for a line.

Source: spec/rs274.md §5

Bad:

    G28 G1 X1 F100
        ^^
    G0 G92 X0
    ^^
    G10 L2 P1 X0 G0
                 ^^
    G92 X0 G1 Y5 F100
           ^^

Good:

    G28 X1
    G92 X0
    G80 G28 X1
"""

import itertools
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import moved_above
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._parting import between, line_of
from deburr.rules.rs274._words import TAKES_AXES, report, said, words
from deburr_grammar.dialects.rs274.modality import AXES
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report the motion code."""
    found = words(line)
    if not found.clear or TAKES_AXES.isdisjoint(found.has):
        return
    taker = said(line, found.first(*TAKES_AXES))
    for at in found.groups.get("motion", ()):
        if found.codes[at] != "G80":
            yield report(
                line,
                at,
                f"`{said(line, at)}` and `{taker}` both use the axis words of the line; write them on two lines",
            )


_RETURNS = frozenset(("G28", "G30"))


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the motion on a line of its own: with its axis words where both codes have some, alone where it has none or is the rapid of a return."""
    _, found, starts = line_of(broken)
    at = starts.index(broken.span.start)
    own = itertools.takewhile(lambda letter: letter not in "GM", found.letters[at + 1 :])
    returns = found.codes[at] == "G0" and not _RETURNS.isdisjoint(found.has)
    if parting := list(between(broken, found.first(*TAKES_AXES))):
        yield from parting
    elif returns or AXES.isdisjoint(own):
        yield from moved_above(broken)
