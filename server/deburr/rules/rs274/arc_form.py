"""Arc without a radius, or with words that do not go together.

An arc takes its centre from I, J and K or its radius from R, one of them and not both. In G17 the
centre is I and J, in G18 I and K, in G19 J and K; an R arc needs a word for its end; in G90.1 both
words of the centre are needed. The control stops, as with "R i j k words all missing for arc".

Source: spec/rs274.md §5

Bad:

    F100
    G2 X1
    ^^
    G2 X1 I1 R1
    ^^
    G17 G2 X1 K1
              ^^
    G17 G3 R1
        ^^

Bad:

    F100
    G2 X1 I0.5
    X2
    ^^

Bad:

    F100 G90.1
    G2 X1 I0.5
    ^^

Bad:

    F100
    G17.1
    G2 X1 I1
    ^^

Good:

    F100
    G2 X1 I0.5
    G3 X0 R0.5
    G2 I1
    G18 G2 Z1 K0.5
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import ARCS, Words, governs, motion, report, said, words
from deburr_grammar.dialects.rs274.modality import AXES

_PLANES = {"G17": ("XY", "IJ"), "G18": ("XZ", "IK"), "G19": ("YZ", "JK")}
"""The axes of a plane, and the words of a centre in it."""


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the arc, or the word that it does not take."""
    found = words(line)
    made = motion(found, state)
    if made not in ARCS:
        return
    arc = found.first(made) if made in found.has else found.first(*AXES, "I", "J", "K")
    centre = [at for at, letter in enumerate(found.letters) if letter in "IJK"]
    if "R" in found.has and centre:
        word = said(line, centre[0])
        yield report(
            line, arc, f"`{said(line, arc)}` has a radius R and a centre `{word}`; the control takes one of them"
        )
    elif "R" not in found.has and not centre:
        goes_on = "" if made in found.has else f" goes on in `{made}` and"
        yield report(line, arc, f"`{said(line, arc)}`{goes_on} is an arc without a radius: it needs I, J, K or R")
    else:
        yield from _in_plane(line, found, state, arc, centre)


def _in_plane(line: Line, found: Words, state: State, arc: int, centre: list[int]) -> Iterator[Report]:
    plane = governs(found, state, "plane")
    if plane not in _PLANES:
        if plane is not None:
            yield report(line, arc, f"`{said(line, arc)}` is an arc, and `{plane}` is no plane for one")
        return
    axes, wanted = _PLANES[plane]
    wrong = [at for at in centre if found.letters[at] not in wanted]
    for at in wrong:
        yield report(line, at, f"`{said(line, at)}` is no centre in `{plane}`: there it is {wanted[0]} and {wanted[1]}")
    if not centre and found.has.isdisjoint((*axes, "@", "^")):
        yield report(
            line, arc, f"`{said(line, arc)}` is an arc of radius R without an end: {axes[0]} or {axes[1]} is missing"
        )
    missing = [letter for letter in wanted if letter not in found.has]
    if centre and not wrong and missing and governs(found, state, "arc-distance") == "G90.1":
        yield report(line, arc, f"`{said(line, arc)}` has no {missing[0]} word; in `G90.1` the centre needs both")
