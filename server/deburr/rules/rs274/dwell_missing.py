"""Dwell without a time.

`G4` needs a P word, the time in seconds. Fanuc's `G4 X2` and `G4 U2` are refused, too: the control
stops with "Dwell time missing with g4".

Source: spec/rs274.md §5

Bad:

    G4
    ^^

Bad:

    G0 X1
    G4 X2
    ^^

Good:

    G4 P0.5
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._words import report, said, words
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report the dwell."""
    found = words(line)
    if "G4" in found.has and "P" not in found.has and found.clear:
        at = found.first("G4")
        yield report(line, at, f"`{said(line, at)}` has no time: write the seconds as a P word, as in `G4 P0.5`")
