"""Code without a word that it needs.

Some codes mean nothing without a value: `G33` needs the way per turn K, `G41.1` the diameter D,
`M62` the number of the output P, and motion codes other than G0 to G3, `G52` and `G92` need axis words. The control stops,
as with "K word missing with g33/g33.1". For arcs, cycles, splines and dwells see `arc-form`,
`cycle-word`, `spline-form` and `dwell-missing`.

Source: spec/rs274.md §5

Bad:

    M3 S500
    G33 Z-5
    ^^^
    G10 X0
    ^^^
    G10 L2 X0
    ^^^
    G92
    ^^^
    G38.2 F50
    ^^^^^
    M62
    ^^^
    M66 L0
    ^^^
    M67 Q5
    ^^^
    M61
    ^^^
    G96
    ^^^
    G43.2
    ^^^^^
    G41.1
    ^^^^^

Bad:

    M3 S500
    G33 Z-5 K1
    Z-10
    ^^^^

Bad (whole):

    G18
    M3 S500
    G76 Z-10 I-1 J0.1
    ^^^
    M2

Good:

    G10 L2 P1 X0
    G92 X0
    G96 S200
    M66 E0
    G41.1 D5
    G40
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import CYCLES, Words, entry, motion, report, said, words
from deburr_grammar.dialects.rs274.modality import AXES

_ELSEWHERE = CYCLES | frozenset(("G5", "G5.1"))
"""Codes whose words other rules ask for."""
_NO_AXES = frozenset(("G0", "G1", "G2", "G3", "G5.2", "G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2", "G80"))
"""Motion codes that may stand without axis words."""
_ONE_OF = {"M66": ("PE", "an input: P for a digital or E for an analog one")}


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the code, or the first word of a line that goes on in one."""
    found = words(line)
    if not found.clear:
        return
    codes = [(at, code) for at, code in enumerate(found.codes) if code]
    made = motion(found, state)
    if made and made not in found.has and found.axes:
        codes.append((found.first(*AXES), made))
    for at, code in codes:
        if code not in _ELSEWHERE and (missing := _missing(line, found, code)):
            moves = "" if code in found.has else f" goes on in `{code}` and"
            yield report(line, at, f"`{said(line, at)}`{moves} needs {' and '.join(missing)}; the control stops here")


def _missing(line: Line, found: Words, code: str) -> list[str]:
    needs = dict(entry(line, code).get("needs", {}))
    if code == "G10" and "L" in found.has:
        needs = {"P": "which of them to set"}
    missing = [f"{letter} ({what})" for letter, what in needs.items() if letter not in found.has]
    letters, what = _ONE_OF.get(code, ("", ""))
    if letters and found.has.isdisjoint(letters):
        missing.append(what)
    if code == "G43.2" and "H" not in found.has and not found.axes:
        missing.append("a tool number H or axis words")
    moves = entry(line, code).get("group") == "motion" and code not in _NO_AXES
    if (moves or code in ("G52", "G92")) and not found.axes:
        missing.append("an axis word")
    return missing
