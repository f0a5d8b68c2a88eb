"""What a line does to the position of the tool, by its shape and the modal state: nothing, a move to a literal place, an arc, or nobody knows what."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from deburr.rules.rs274._words import ARCS, governs, motion, words
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.modal import State
    from deburr.rule import Line
    from deburr_grammar.dialect import Reading
    from deburr_grammar.line import Shape


class Modes(NamedTuple):
    """What is in force when an arc is made; None: only the run knows it."""

    plane: str | None
    distance: str | None
    centre: str | None
    units: str | None


class Kind(Enum):
    """What a line does to the position."""

    SKIPS = "leaves the position as it is"
    MOVES = "moves to where its words say"
    SWITCHES = "changes the units, and may move"
    LOSES = "leaves it uncertain where the tool stands"


_HARMLESS_CODES = (
    "G0 G1 G2 G3 G4 G17 G18 G19 G17.1 G18.1 G19.1 G28.1 G30.1 G61 G61.1 G64 G80 G90 G91 G90.1 G91.1 G93"
    " G94 G95 G96 G97 G98 G99 M0 M1 M3 M4 M5 M7 M8 M9 M19 M48 M49 M50 M51 M52 M53 M60 M62 M63 M64 M65 M66"
    " M67 M68"
)
_HARMLESS = frozenset(_HARMLESS_CODES.split())
_LASTING = {"G40": "cutter-compensation", "G49": "tool-length", "G54": "coordinate-system", "G8": "lathe-diameter"}
"""Codes that change nothing where they are in force, or where nothing else has been."""
_UNITS = frozenset(("G20", "G21"))
_MOVES = ARCS | {"G0", "G1"}


def without_words(reading: Reading, shape: Shape) -> Kind:
    """What a line without words does."""
    # A block, a call or a label: what ran before the next line is not certain. Settings may move offsets.
    facts = shape.facts(reading)
    return Kind.LOSES if not facts.kinds.isdisjoint(("o_line", "setting")) or facts.problems else Kind.SKIPS


def kind_of(line: Line, state: State) -> Kind:
    """What a line with words does."""
    found = words(line)
    letters = [letter for letter in found.letters if letter not in "GM"]
    if not found.clear or len(letters) != len(set(letters)) or not line.node.kinds.isdisjoint(("DELETE", "setting")):
        return Kind.LOSES
    codes = {code for code in found.codes if code} - _HARMLESS
    codes -= {code for code in codes if _is_in_force(state, code)}
    if codes - _UNITS or not found.has.isdisjoint("@^"):
        return Kind.LOSES
    if not found.axes:
        return Kind.SWITCHES if codes else Kind.SKIPS
    straight = motion(found, state) in _MOVES and governs(found, state, "distance") == "G90"
    if not straight or not _is_literal(line, "XYZ") or _in_g7(state):
        return Kind.LOSES
    return Kind.SWITCHES if codes else Kind.MOVES


def _is_in_force(state: State, code: str) -> bool:
    if code in _UNITS:
        return state.code("units") == code
    group = _LASTING.get(code)
    return group is not None and (state.untouched(group) or state.code(group) == code)


def arc_modes(line: Line, state: State) -> Modes | None:
    """Under which modes a line is an arc whose radius can be checked, wherever it leads to."""
    found = words(line)
    if motion(found, state) not in ARCS or not _is_literal(line, "XYZIJKR") or _in_g7(state):
        return None
    letters = [letter for letter in found.letters if letter not in "GM"]
    if len(letters) != len(set(letters)) or not found.has.isdisjoint(("@", "^", "G7")):
        return None
    if governs(found, state, "cutter-compensation") != "G40":
        return None
    plane, distance, centre = (governs(found, state, group) for group in ("plane", "distance", "arc-distance"))
    return Modes(plane, distance, centre, found.of("units") or state.code("units"))


def _in_g7(state: State) -> bool:
    return not (state.untouched("lathe-diameter") or state.code("lathe-diameter") == "G8")


def _is_literal(line: Line, letters: str) -> bool:
    """Whether all words of these letters are plain numbers."""
    return all(
        _is_number(word.children[-1]) for word in line.node.find("word") if line.text[word.start].upper() in letters
    )


def _is_number(part: Node | Token) -> bool:
    return isinstance(part, Token) or (part.kind == "signed" and _is_number(part.children[-1]))
