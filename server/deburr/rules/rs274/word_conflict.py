"""Words that may not stand together.

A word can be right by itself and still not fit another one: polar `@` and `^` beside X and Y,
P and E of `M66`, H and axis words of `G43.2`, an F word beside `G33`, `G4` beside an arc, because both
would use P. The control stops, as with "Cannot specify both polar coordinate and X word".

Source: spec/rs274.md §5

Bad:

    G0 @5 ^30 X1
       ^^

Bad:

    F100
    G2 X1 I0.5 G4 P1
               ^^

Bad:

    M66 P1 E1
           ^^
    G0 G43.2 H1 X5
             ^^
    G10 L20 P1 R30
               ^^^
    G10 L2 P1 I1
              ^^
    G92 @5
        ^^

Bad:

    M3 S100
    G33 Z-5 K1 F100
               ^^^^

Bad:

    G18
    G0 @5 ^30
       ^^

Bad:

    G41.1 D5 L2
             ^^

Good:

    G0 @5 ^30 Z1
    M66 P1
    G10 L2 P1 R30
    G43.2 H1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import moved_above
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import ARCS, TAKES_AXES, Words, governs, in_force, motion, report, said, values, words

_POLAR = ("@", "^")
_SYNCHRONIZED = ("G33", "G33.1")


def _may(line: Line, state: State) -> bool:
    return any(True for _ in _found(line, words(line), state, dict.fromkeys(words(line).has, None)))


@rule(Severity.ERROR, Modal(("word",), where=_may))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the word that does not fit."""
    for at, why in _found(line, words(line), state, values(line)):
        yield report(line, at, f"`{said(line, at)}` {why}")


def _found(line: Line, found: Words, state: State, numbers: dict[str, float | None]) -> Iterator[tuple[int, str]]:
    if not found.clear:
        return
    if not found.has.isdisjoint(_POLAR) and (why := _polar(line, found, state)):
        yield found.first(*_POLAR), why
    made = motion(found, state)
    if "G4" in found.has and made in ARCS and made in found.has:
        yield found.first("G4"), "and an arc would both use P; write the dwell on a line of its own"
    if "M66" in found.has and {"P", "E"} <= found.has:
        yield found.first("E"), "and P stand beside `M66`, which reads one input: P is a digital, E an analog one"
    if "G43.2" in found.has and "H" in found.has and found.axes:
        yield found.first("H"), "and axis words stand beside `G43.2`, which takes one of the two"
    if made in _SYNCHRONIZED and "F" in found.has:
        yield (
            found.first("F"),
            f"stands beside `{made}`, whose feed is K times the spindle speed; write it on another line",
        )
    if "G10" in found.has:
        yield from _in_g10(found, numbers)
    compensated = found.of("cutter-compensation")
    if compensated in ("G41.1", "G42.1") and "L" in found.has and governs(found, state, "plane") not in (None, "G18"):
        yield found.first("L"), f"stands beside `{compensated}`, which takes a lathe tool's orientation in `G18` only"
    if made == "G76" and (turned := found.has & {"A", "B", "C"}):
        yield found.first(*turned), "stands beside `G76`, which moves no rotary axis"


def _polar(line: Line, found: Words, state: State) -> str:
    straight = [letter for letter in "XY" if letter in found.has]
    takers = found.has & (TAKES_AXES | {"G43.1"})
    if straight:
        return f"is polar, and {straight[0]} on the same line is not; the control takes one of the two"
    if "G80" in found.has and not takers:
        return ""
    if takers and motion(found, state) in ("", "G80"):
        return f"is polar, which only motions are, not `{next(iter(sorted(takers)))}`"
    if "G53" in found.has and motion(found, state) in ("G0", "G1"):
        return "is polar, which machine coordinates (`G53`) are not"
    # The plane of the line itself comes too late: words are looked at before.
    plane = in_force(state, "plane")
    return f"is polar, and `{plane}` is in force; polar words are for `G17`" if plane not in (None, "G17") else ""


def _in_g10(found: Words, numbers: dict[str, float | None]) -> Iterator[tuple[int, str]]:
    kind = numbers.get("L", 0.0)
    if kind in (None, 2.0, 20.0) and not found.has.isdisjoint("IJ"):
        yield found.first("I", "J"), "is an angle of a lathe tool; `G10 L2` sets a coordinate system and takes none"
    if kind in (None, 20.0) and "R" in found.has:
        yield found.first("R"), "stands beside `G10 L20`, which turns nothing; a rotation is set by `G10 L2`"


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the word on a line of its own."""
    if "write it on another line" in broken.finding.message:
        yield from moved_above(broken)
