"""Move at the feed rate where none is known.

G1, arcs, splines, probing and canned cycles need a feed rate, an F word on their line or on one
before it. The control stops, as with "Cannot do g1 with zero feed rate". Of several such moves the first
is reported. `G94` and `G95` forget the feed rate, even if they change nothing, and in `G93` every
line with G1, G2 or G3 needs an F word of its own. In `G95` a spindle speed must be
known, too.

Source: spec/rs274.md §5

Bad:

    G1 X1
    ^^
    X2

Bad:

    G2 X1 I0.5
    ^^

Bad:

    G94 F100
    G1 X1
    G94
    X2
    ^^

Bad:

    G93 G1 X1 F2
    X2
    ^^

Bad:

    G95 F0.1
    G1 X1
    ^^

Good:

    G0 X1
    G1 F100 X2
    X3
    G93 G1 X4 F2
    G94 F100 G1 X5
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import PROBES, Words, governs, motion, report, said, words
from deburr_grammar.dialects.rs274 import modality

_EACH = frozenset(("G1", "G2", "G3"))
_INVERSE = _EACH | frozenset(("G5", "G5.1"))
"""Motions that take an F word of their own in G93."""
_UNSET = "moves at a feed rate, and none is set; write an F word on this line or before it"


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the motion code, or the first word of a line that goes on in one."""
    found = words(line)
    made = motion(found, state)
    if made in modality.FEEDS and (why := _why(found, state, made)):
        at = found.first(made) if made in found.has else found.first(*modality.AXES, "I", "J", "K")
        yield report(line, at, f"`{said(line, at)}` {why}")


def _why(found: Words, state: State, made: str) -> str:
    mode = governs(found, state, "feed-mode")
    if mode == "G93" and made in _INVERSE:
        return "has no F word; in `G93` every feed move needs its own" if "F" not in found.has else ""
    if mode == "G93":
        # There an F word tells the time of its own line; probing needs a rate from before.
        return _UNSET if made in PROBES and state.untouched("F") and state.untouched(modality.FED) else ""
    if "F" not in found.has and _forgotten(found, state) and (made in found.has or state.untouched(modality.LOST)):
        return _UNSET
    if mode == "G95" and made in _EACH and "S" not in found.has and state.untouched("S"):
        return "feeds by spindle turns in `G95`, and no spindle speed is set; write an S word before it"
    return ""


def _forgotten(found: Words, state: State) -> bool:
    """Whether no feed rate is known, and no move before has been reported for that."""
    return found.of("feed-mode") in ("G94", "G95") or (state.untouched("F") and state.untouched(modality.FED))
