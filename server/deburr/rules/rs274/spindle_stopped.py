"""Threading, tapping or boring while the spindle does not turn.

G33, G33.1, G76 and the cycles G74, G84, G86, G87 and G88 need a turning spindle, G84 clockwise and G74
counterclockwise. The control stops, as with "Spindle not turning in G33".

Source: spec/rs274.md §5

Bad:

    G33 Z-10 K1.5
    ^^^

Bad:

    F100 S300 M4
    G84 X1 Z-10 R1
    ^^^

Bad:

    S300 M3
    M5
    G33.1 Z-10 K1
    ^^^^^

Good:

    F100 S300 M3
    G84 X1 Z-10 R1
    G33 Z-10 K1.5
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import governs, motion, report, said, values, words

_TURNS = {
    "G33": ("M3", "M4"),
    "G33.1": ("M3", "M4"),
    "G74": ("M4",),
    "G76": ("M3", "M4"),
    "G84": ("M3",),
    "G86": ("M3", "M4"),
    "G87": ("M3", "M4"),
    "G88": ("M3", "M4"),
}
"""Which way the spindle must turn."""


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the motion code."""
    found = words(line)
    made = motion(found, state)
    spindle = governs(found, state, "spindle")
    if made not in _TURNS or made not in found.has or spindle is None or spindle in _TURNS[made]:
        return
    # A further spindle is chosen by `$`; which of them turns is not followed.
    if values(line).get("$", 0.0) != 0:
        return
    at = found.first(made)
    what = f"it turns the wrong way (`{spindle}`)" if spindle in ("M3", "M4") else "it does not turn here"
    needed = " or ".join(f"`{code}`" for code in _TURNS[made])
    yield report(line, at, f"`{said(line, at)}` needs the spindle to turn, and {what}; write {needed} before it")
