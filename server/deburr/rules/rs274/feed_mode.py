"""Feed mode in which a motion is not possible.

Canned cycles are not possible in inverse time (G93), probing is not possible in feed per turn
(G95). The control stops, as with "Cannot use inverse time feed with canned cycles".

Source: spec/rs274.md §5

Bad:

    G93
    G81 X1 Z-1 R1
    ^^^

Bad:

    G95 F0.1
    G38.2 Z-5
    ^^^^^

Good:

    G93
    G1 X1 F2
    G94 F100
    G81 X1 Z-1 R1
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import CYCLES, PROBES, governs, motion, report, said, words
from deburr_grammar.dialects.rs274.modality import AXES

_IMPOSSIBLE = {"G93": (CYCLES, "a canned cycle"), "G95": (PROBES, "probing")}


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the motion code, or the first axis word of a line that goes on in it."""
    found = words(line)
    made = motion(found, state)
    mode = governs(found, state, "feed-mode") or ""
    impossible, what = _IMPOSSIBLE.get(mode, (frozenset(), ""))
    if made in impossible and found.axes:
        at = found.first(made) if made in found.has else found.first(*AXES)
        yield report(
            line, at, f"`{said(line, at)}`: {what} is not possible in `{mode}`; write `G94` and a feed rate before it"
        )
