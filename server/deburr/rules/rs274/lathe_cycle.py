"""Lathe cycle outside the plane XZ.

G70, G71 and G72 with their kinds follow a contour in X and Z and need `G18`. The control stops with
"G71.0 can only be used in XZ plane (G18)".

Source: spec/rs274.md §5

Bad:

    o100 sub
      G0 X10
      G1 Z-20
    o100 endsub
    F100
    G71 Q100 D0.5 I1 R0.5
    ^^^

Good:

    o100 sub
      G0 X10
      G1 Z-20
    o100 endsub
    F100
    G18 G71 Q100 D0.5 I1 R0.5
"""

from collections.abc import Iterator

from deburr.fixers import line_before
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import governs, motion, report, said, words

_LATHE = ("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2")


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the code."""
    found = words(line)
    made = motion(found, state)
    plane = governs(found, state, "plane")
    if made in _LATHE and made in found.has and plane not in (None, "G18"):
        at = found.first(made)
        yield report(
            line, at, f"`{said(line, at)}` works in the plane XZ, and `{plane}` is in force; write `G18` before it"
        )


fix = line_before
