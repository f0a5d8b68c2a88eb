"""Machine coordinates without a straight move in them.

`G53` needs `G0` or `G1`, on its line or in force with axis words behind it, and absolute
positions (G90). The control stops with "Must use g0 or g1 with g53" or "Cannot use g53
incremental".

Source: spec/rs274.md §5

Bad:

    G53
    ^^^

Bad:

    G91
    G53 G0 Z0
    ^^^

Bad:

    F100
    G53 G2 X1 I0.5
    ^^^

Good:

    G53 G0 Z0
    G53 X0
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import UNKNOWN, governs, motion, report, said, words


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the code."""
    found = words(line)
    if "G53" not in found.has:
        return
    made = motion(found, state)
    at = found.first("G53")
    # Axis words without any motion are reported for themselves.
    if made not in ("G0", "G1", UNKNOWN) and (made not in ("", "G80") or not found.axes):
        yield report(line, at, f"`{said(line, at)}` needs a straight move: write `G0` or `G1` and axis words beside it")
    elif made in ("G0", "G1") and governs(found, state, "distance") == "G91":
        yield report(
            line, at, f"`{said(line, at)}` names a point of the machine, but steps are in force; write `G90` beside it"
        )


def fix(broken: Broken) -> Iterator[Fix]:
    """Move in absolute coordinates."""
    if "write `G90` beside it" in broken.finding.message:
        yield broken.inserted(broken.span.start, "G90 ")
