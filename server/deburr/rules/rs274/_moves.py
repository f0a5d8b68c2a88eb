"""What a line does to the position of the tool, by its words and the modal state: axes go to a literal place, a literal way further, or nobody knows where."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from deburr.rules.rs274._words import ARCS, CYCLES, PROBES, UNKNOWN, governs, in_force, motion, values, words
from deburr_grammar.dialects.rs274.modality import AXES
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.modal import State
    from deburr.rule import Line
    from deburr.rules.rs274._words import Words
    from deburr_grammar.dialect import Reading
    from deburr_grammar.line import Shape

LINEAR = "XYZ"
MUST_PROBE = frozenset(("G38.2", "G38.4"))
"""Probes that are an error where they end without contact, or without losing it."""
_OTHERS = AXES - set(LINEAR)
MM_PER_INCH = 25.4


class Modes(NamedTuple):
    """What is in force when a move is made; None: only the run knows it.

    ``share``: the part of a word X that is a coordinate: half of it where X is a diameter (G7).
    """

    plane: str | None
    distance: str | None
    centre: str | None
    units: str | None
    share: float


class Way(Enum):
    """What becomes of a coordinate."""

    TO = "it is the value of a word"
    BY = "the value of a word is added"
    LOST = "it is uncertain"


class Change(NamedTuple):
    """What a line does to the position.

    ``factor``: what other units make of each coordinate before the line moves; None: nobody knows.
    ``axes``: what becomes of coordinates, and by which word; all others stay.
    ``share``: the part of a word X that is a coordinate.
    ``shifts``: whether offsets are changed before the move. ``loses``: whether nothing of them is certain any more.
    """

    factor: float | None
    axes: Mapping[str, tuple[Way, str]]
    share: float = 1.0
    shifts: bool = False
    loses: bool = False


STAYS = Change(1.0, {})
LOST = Change(1.0, {axis: (Way.LOST, axis) for axis in LINEAR}, loses=True)
_HARMLESS_CODES = (
    "G4 G7 G8 G17 G18 G19 G17.1 G18.1 G19.1 G28.1 G30.1 G61 G61.1 G64 G80 G90 G91 G90.1 G91.1 G93"
    " G94 G95 G96 G97 G98 G99 M0 M1 M3 M4 M5 M7 M8 M9 M19 M48 M49 M50 M51 M52 M53 M60 M62 M63 M64 M65 M66"
    " M67 M68"
)
_MOVES = ARCS | {"G0", "G1"}
_HARMLESS = frozenset(_HARMLESS_CODES.split()) | _MOVES | CYCLES | PROBES
_UNITS = frozenset(("G20", "G21"))
_HOMES = frozenset(("G28", "G30"))
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
"""The coordinate systems, from the first, as G10 counts them."""
_LAYS = frozenset(("G10", "G43.1", "G52", "G92"))
"""Codes to which the axis words of their line are offsets."""
_SHIFTS = _LAYS | {"G43", "G43.2", "G49", "G92.1", "G92.2", "G92.3"} | set(SYSTEMS)
_AWAY = frozenset(("G40", "G41", "G41.1", "G42", "G42.1", "M6"))
"""Codes behind which only the machine knows where it stands, in offsets that stay."""
_NOT_POLAR = frozenset((UNKNOWN, "", "G80", "G5.2", "G5.3"))
"""Motions of a line whose polar words are not looked at, or not for certain."""
_DEPTH = {"G17": "Z", "G18": "Y", "G19": "X"}
"""The axis that canned cycles drill along."""


def without_words(reading: Reading, shape: Shape) -> Change:
    """What a line without words does."""
    # A block, a call or a label: what ran before the next line is not certain. Settings may move offsets.
    facts = shape.facts(reading)
    return LOST if not facts.kinds.isdisjoint(("o_line", "setting")) or facts.problems else STAYS


def counts(line: Line, state: State) -> bool:
    """Whether what a line does hangs on numbers that its shape leaves out: repeated cycles."""
    found = words(line)
    return "L" in found.has and motion(found, state) in CYCLES


def may_shift(line: Line) -> bool:
    """Whether a line with words may change offsets, whatever is in force."""
    found = words(line)
    return not _is_plain(line, found) or not found.has.isdisjoint(_SHIFTS) or bool(_strange(found))


def change_of(line: Line, state: State) -> Change:
    """What a line with words does."""
    found = words(line)
    if not _is_plain(line, found) or _strange(found):
        return LOST
    codes = found.has - {"G40"} if _is_in_force(state, "G40") else found.has
    axes = _axes(line, found, state) if codes.isdisjoint(_AWAY) else _lost(LINEAR)
    share = share_of(found, state)
    if share is None and "X" in axes:
        axes["X"] = (Way.LOST, "X")
    return Change(_factor(found, state), axes, share or 1.0, shifts=not codes.isdisjoint(_SHIFTS))


def only_named(change: Change) -> Change:
    """The same change if only what an absolute move names counts as known: all that steps lead to is lost."""
    axes = {axis: (way if way is Way.TO else Way.LOST, letter) for axis, (way, letter) in change.axes.items()}
    return change._replace(axes=axes)


def _is_plain(line: Line, found: Words) -> bool:
    """Whether it is certain what a line asks for, and that it is executed."""
    letters = [letter for letter in found.letters if letter not in "GM"]
    return found.clear and len(letters) == len(set(letters)) and line.node.kinds.isdisjoint(("DELETE", "setting"))


def _strange(found: Words) -> Set[str]:
    """Codes of which nothing is known."""
    return {code for code in found.codes if code} - _HARMLESS - _UNITS - _SHIFTS - _HOMES - _AWAY - {"G53"}


def _is_in_force(state: State, code: str) -> bool:
    group = "cutter-compensation"
    return state.untouched(group) or state.code(group) == code


def _factor(found: Words, state: State) -> float | None:
    """What the units of the line make of a length in those before it."""
    new, old = found.of("units"), state.code("units")
    if new in ("", old):
        return 1.0
    if old is None:
        return None
    return 1 / MM_PER_INCH if new == "G20" else MM_PER_INCH


def _axes(line: Line, found: Words, state: State) -> dict[str, tuple[Way, str]]:
    given = found.has.intersection(LINEAR)
    if not found.has.isdisjoint(_HOMES):
        # Home is where the machine has it: along the axes that are written, or all.
        return _lost(_turning(given) if given else LINEAR)
    if "G53" in found.has:
        return _lost(_turning(given))
    if not found.has.isdisjoint(_LAYS):
        return {}
    if not found.axes:
        return {}
    made = motion(found, state)
    if not found.has.isdisjoint("@^"):
        given |= {"X", "Y"}
    elif made in _MOVES:
        return _moved(line, found, state, given)
    elif made in CYCLES:
        return _drilled(line, found, state, given)
    elif made not in PROBES:
        given = frozenset(LINEAR)
    # A probe stops on its way, and a radius and an angle lead nobody knows where.
    return _lost(given)


def _turning(given: Set[str]) -> Set[str]:
    """Axes that a move in the machine's coordinates changes: where a system is turned, X and Y go together."""
    return given if given.isdisjoint("XY") else given | {"X", "Y"}


def active_system(state: State) -> str | None:
    """The code of the coordinate system in force; a program starts in G54. None: only the run knows it."""
    return "G54" if state.untouched("coordinate-system") else state.code("coordinate-system")


def _moved(line: Line, found: Words, state: State, given: Set[str]) -> dict[str, tuple[Way, str]]:
    distance = governs(found, state, "distance")
    if distance not in ("G90", "G91"):
        return _lost(given)
    return _literal(line, given, Way.TO if distance == "G90" else Way.BY)


def _drilled(line: Line, found: Words, state: State, given: Set[str]) -> dict[str, tuple[Way, str]]:
    """A cycle ends above its hole: where it began, or (G99) at R."""
    depth = _DEPTH.get(governs(found, state, "plane") or "")
    if depth is None:
        return _lost(LINEAR)
    absolute = governs(found, state, "distance") == "G90"
    repeats = values(line)["L"] if "L" in found.has else 1.0
    once = repeats is not None and (repeats == 1 or (absolute and repeats > 1))
    across = _moved(line, found, state, given - {depth}) if once else _lost(given - {depth})
    to_r = once and absolute and "R" in found.has and governs(found, state, "canned-cycle-return") == "G99"
    above = (Way.TO if to_r and _is_literal(line, "R") else Way.LOST, "R")
    return {**across, depth: above}


def _literal(line: Line, axes: Iterable[str], way: Way) -> dict[str, tuple[Way, str]]:
    return {axis: (way if _is_literal(line, axis) else Way.LOST, axis) for axis in axes}


def _lost(axes: Iterable[str]) -> dict[str, tuple[Way, str]]:
    return {axis: (Way.LOST, axis) for axis in axes}


def arc_modes(line: Line, state: State) -> Modes | None:
    """Under which modes a line is an arc whose radius can be checked, wherever it leads to."""
    return _modes(line, state, ARCS, "XYZIJKR")


def probe_modes(line: Line, state: State) -> Modes | None:
    """Under which modes a line is a probe along X, Y and Z alone that must end as it says."""
    return _modes(line, state, MUST_PROBE, "XYZ") if words(line).has.isdisjoint(_OTHERS) else None


def polar_modes(line: Line, state: State) -> Modes | None:
    """Under which modes a move by polar words is not possible at the origin; None: it is possible there, or wrong in another way."""
    return _polar(line, state) if motion(words(line), state) not in CYCLES else None


def polar_cycle_modes(line: Line, state: State) -> Modes | None:
    """The same of a canned cycle."""
    return _polar(line, state) if motion(words(line), state) in CYCLES else None


def _polar(line: Line, state: State) -> Modes | None:
    found = words(line)
    made = motion(found, state)
    others = [letter for letter in found.letters if letter not in "GM"]
    if (
        found.has.isdisjoint("@^")
        or made in _NOT_POLAR
        or not found.has.isdisjoint(("X", "Y", "G53"))
        or len(others) != len(set(others))
    ):
        return None
    # The plane of the line itself comes too late.
    if in_force(state, "plane") not in ("G17", None):
        return None
    distance = governs(found, state, "distance")
    leaves_angle = "^" not in found.has and made not in CYCLES
    return Modes(None, distance, None, None, 1.0) if leaves_angle or distance == "G91" else None


def _modes(line: Line, state: State, motions: Set[str], letters: str) -> Modes | None:
    found = words(line)
    share = share_of(found, state) if "X" in found.has else 1.0
    if motion(found, state) not in motions or not _is_literal(line, letters) or share is None:
        return None
    said = [letter for letter in found.letters if letter not in "GM"]
    # Beside a code that takes the axis words no move is made: another rule speaks.
    if len(said) != len(set(said)) or not found.has.isdisjoint(("@", "^", *_LAYS)):
        return None
    if governs(found, state, "cutter-compensation") != "G40":
        return None
    plane, distance, centre = (governs(found, state, group) for group in ("plane", "distance", "arc-distance"))
    return Modes(plane, distance, centre, found.of("units") or state.code("units"), share)


def share_of(found: Words, state: State) -> float | None:
    """The part of a word X that is a coordinate. The code acts before the words beside it."""
    code = governs(found, state, "lathe-diameter")
    return None if code is None else 0.5 if code == "G7" else 1.0


def _is_literal(line: Line, letters: str) -> bool:
    """Whether all words of these letters are plain numbers."""
    return all(
        _is_number(word.children[-1]) for word in line.node.find("word") if line.text[word.start].upper() in letters
    )


def _is_number(part: Node | Token) -> bool:
    return isinstance(part, Token) or (part.kind == "signed" and _is_number(part.children[-1]))
