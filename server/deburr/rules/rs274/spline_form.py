"""Spline with words that do not go together, or out of place.

A G5 needs P and Q and both or none of I and J; G5.1 needs I and J; a point of G5.2 needs X and Y.
They lie in the plane XY and move no other axis. G5.3 ends what G5.2 has begun. The control
stops, as with "Must specify both P and Q with G5".

Source: spec/rs274.md §5

Bad:

    F100
    G5 X1 Y1 I1 J1 P1
    ^^
    G5 X1 Y1 I1 P1 Q1
    ^^
    G5.1 X1 Y1 I1
    ^^^^
    G5.1 X1 Y1 Z1 I1 J1
               ^^
    G5.2 X1 P1
    ^^^^

Bad:

    G5.3
    ^^^^

Bad:

    F100
    G18 G5.1 X1 Y1 I1 J1
        ^^^^

Good:

    F100
    G17 G5 X1 Y1 I1 J1 P1 Q1
    G5.1 X2 Y2 I1 J1
    G5.2 X3 Y1 P1
    X4 Y2 P1
    X5 Y1 P1
    G5.3
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import Words, entry, governs, in_force, motion, report, said, words

_SPLINES = frozenset(("G5", "G5.1", "G5.2"))
_OTHERS = "ZABC"


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the spline, or the axis that it does not move."""
    found = words(line)
    if not found.clear:
        return
    if "G5.3" in found.has and in_force(state, "motion") not in (None, "G5.2"):
        at = found.first("G5.3")
        yield report(line, at, f"`{said(line, at)}` ends a curve that no `G5.2` has begun")
    made = motion(found, state)
    if made not in _SPLINES or made not in found.has:
        return
    at = found.first(made)
    plane = governs(found, state, "plane")
    if made != "G5.2" and plane not in (None, "G17"):
        yield report(
            line, at, f"`{said(line, at)}` lies in the plane XY, and `{plane}` is in force; write `G17` before it"
        )
    elif made == "G5.2" and governs(found, state, "feed-mode") not in ("G94", "G95"):
        # In inverse time a point of a curve is not even looked at.
        return
    elif why := _why(line, found, made):
        yield report(line, at, f"`{said(line, at)}` {why}; the control stops here")
    elif made != "G5.2":
        for other, letter in enumerate(found.letters):
            if letter in _OTHERS:
                yield report(line, other, f"`{said(line, other)}` is not possible here: a spline moves X and Y alone")


def _why(line: Line, found: Words, made: str) -> str:
    if made == "G5.2":
        return (
            "has one of X and Y; a point of the curve needs both"
            if ("X" in found.has) is not ("Y" in found.has)
            else ""
        )
    missing = [f"{letter} ({what})" for letter, what in entry(line, made)["needs"].items() if letter not in found.has]
    if missing:
        return f"needs {' and '.join(missing)}"
    if not found.axes:
        return "needs an axis word"
    return "has one of I and J; it needs both, or none" if ("I" in found.has) is not ("J" in found.has) else ""
