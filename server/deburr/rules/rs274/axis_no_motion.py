"""Axis words without a motion code that uses them.

At the start of a program, and behind `G80`, no motion is in force. A line that then holds only
axis words does not move: the control stops with "Cannot use axis values without a g code that
uses them". Of several such lines the first is reported, and of several such words on a line.

Source: spec/rs274.md §5

Bad:

    X1
    ^^

Bad:

    G0 X1
    G80
    Y2 Z3
    ^^
    Y4

Bad:

    G80 X1
        ^^

Bad:

    G54 @1 ^45
        ^^

Bad:

    G53 X0
        ^^

Good:

    G0 X1
    Y2 Z3
    G28 X0
    G80 G92 X0
    G43.1 Z10
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import TAKES_AXES, motion, report, said, words
from deburr_grammar.dialects.rs274.modality import AXES, LOST


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the axis words where no motion is in force."""
    found = words(line)
    if not found.axes or _known_otherwise(found.has) or motion(found, state) not in ("", "G80"):
        return
    if "G80" in found.has:
        why = "`G80` on this line ends all motion"
    elif not state.untouched(LOST):
        return
    else:
        why = "no motion code is in force here; write `G0` or `G1` on this line or before it"
    first, *others = [at for at, letter in enumerate(found.letters) if letter in AXES]
    axes = " ".join(said(line, at) for at in (first, *others))
    yield report(line, first, f"`{axes}` {'move' if others else 'moves'} nothing: {why}")


def _known_otherwise(has: frozenset[str]) -> bool:
    """Whether the axis words belong to another code, or something else is said of them."""
    taken = not TAKES_AXES.isdisjoint(has) or ("G43.1" in has and "G80" not in has)
    return taken or ("G4" in has and "P" not in has)


def fix(broken: Broken) -> Iterator[Fix]:
    """Say how it moves: a rapid move, or a feed move."""
    if "write `G0` or `G1`" in broken.finding.message:
        yield broken.inserted(broken.span.start, "G0 ")
        yield broken.inserted(broken.span.start, "G1 ")
