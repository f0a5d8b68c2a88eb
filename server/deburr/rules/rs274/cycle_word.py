"""Canned cycle without a word that it needs, or with one that it does not take.

The line that starts a cycle needs the level R and the depth: Z in G17, Y in G18, X in G19; G73 and
G83 need Q, G82, G86, G88 and G89 the dwell P, G87 the offset I, J and K. The lines after it take
over what they do not say, another cycle does not. A cycle turns no rotary axis. The control stops,
as with "R clearance plane unspecified in cycle".

Source: spec/rs274.md §5

Bad:

    F100
    G81 X1 Z-1
    ^^^

Bad:

    F100
    G17 G81 X1 R1
        ^^^

Bad:

    F100
    G83 X1 Z-5 R1
    ^^^

Bad:

    F100
    G81 X1 Z-1 R1
    G82 X2 P1
    ^^^

Bad:

    F100
    G81 X1 Z-1 R1 A90
                  ^^^

Bad:

    F100
    G81 R1
    ^^^

Good:

    F100
    G81 X1 Z-1 R1
    X2
    G81 X3
    G80
    G83 X1 Z-5 R1 Q1
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import CYCLES, Words, entry, governs, motion, report, said, starts, words

_DEPTH = {"G17": "Z", "G18": "Y", "G19": "X", "G17.1": "W", "G18.1": "V", "G19.1": "U"}
_ANGLED = "ABC"


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the cycle that lacks a word, or the word that it does not take."""
    found = words(line)
    made = motion(found, state)
    if made not in CYCLES:
        return
    plane = governs(found, state, "plane")
    for at, letter in enumerate(found.letters):
        if letter in _ANGLED or plane in _DEPTH and letter in _foreign(plane):
            yield report(line, at, f"`{said(line, at)}` stands in the cycle `{made}`, which does not move that axis")
    if made in found.has and (missing := _missing(line, found, state, made, plane)):
        at = found.first(made)
        yield report(
            line, at, f"`{said(line, at)}` starts a cycle without {' and '.join(missing)}; the control stops here"
        )


def _missing(line: Line, found: Words, state: State, made: str, plane: str | None) -> list[str]:
    if not found.axes:
        return ["axis words"]
    if not starts(found, state, made):
        return []
    needs = {"R": "the level to which it withdraws", **entry(line, made).get("needs", {})}
    if plane is not None:
        needs = {_DEPTH[plane]: "the depth", **needs}
    return [f"{letter} ({what})" for letter, what in needs.items() if letter not in found.has]


def _foreign(plane: str) -> str:
    """Axes that no cycle of a plane moves: those of the other set of linear axes."""
    return "XYZ" if plane.endswith(".1") else "UVW"
