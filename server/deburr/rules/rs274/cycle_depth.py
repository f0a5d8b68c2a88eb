"""Canned cycle whose depth lies above the level R, of which it takes one over.

The lines after the start of a cycle take over what they do not say, and the level R must not lie below the
depth: Z in G17, Y in G18, X in G19. A change of the plane takes over both numbers, along the new axis. Under `G91` the depth is a way down from R, so it must not be above 0. Numbers are taken over as they
were written, whatever units, offsets and distance mode are in force by then. The control stops, as with "R less than z in cycle
in xy plane".

Source: spec/rs274.md §5

Bad:

    F100
    G81 X1 Z-5 R2
    X2 R-6
       ^^^

Bad:

    F100
    G81 X1 Z-5 R2
    G20
    X2 Z5
       ^^

Bad:

    F100
    G91 G81 X1 Z1 R2
               ^^

Bad:

    F100
    G17 G81 X1 Z-5 R2
    G18 Y30
        ^^^

Good:

    F100
    G81 X1 Z-5 R2
    X2 R-4
    X3 Z-6
"""

import re
from collections.abc import Generator, Iterator
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.modal import State, modal_of
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.rs274._words import CYCLES, Words, governs, in_force, motion, report, said, values, words
from deburr_grammar.dialect import Reading
from deburr_grammar.dialects.rs274.modality import AXES
from deburr_grammar.line import Shape

_SIGN = re.compile(r"[Gg][ \t0+]*[78]")
_DEPTH = {"G17": "Z", "G18": "Y", "G19": "X"}
_LEAVES = frozenset(("M2", "M30", "M70", "M72", "M73", "M98", "M99", "G7", "G8"))
"""Codes behind which the next line need not come next, other modes may be in force, or a word X means something else."""


class _Number(NamedTuple):
    """A number with where it is written."""

    value: float | None
    """None: only the run knows it."""
    row: int
    letter: str


class _Held:
    """What a cycle takes over: R and the depth, which is one number for all planes."""

    def __init__(self, start: int) -> None:
        self.level, self.depth = _Number(None, start, "R"), _Number(None, start, "")

    def take(self, numbers: dict[str, float | None], axis: str, at: int) -> None:
        """What a line says in a plane whose depth lies along an axis."""
        if "R" in numbers:
            self.level = _Number(numbers["R"], at, "R")
        if axis in numbers:
            self.depth = _Number(numbers[axis], at, axis)

    def is_faulty(self, steps: bool) -> bool:
        """Whether the depth is certain to lie above R; in steps it is a way from there."""
        depth, level = self.depth.value, self.level.value
        return depth is not None and (depth > 0 if steps else level is not None and depth > level)


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the word that is written last."""
    behind = 0
    for start in _starts(analysis):
        if start >= behind:
            behind = yield from _of_cycle(analysis, start)


def _starts(analysis: Analysis) -> Iterator[int]:
    """The lines where a cycle may start."""
    for piece in analysis.document.pieces():
        yield from (piece.line + index for index, _, _ in piece.where(_may_start))


def _may_start(reading: Reading, shape: Shape) -> bool:
    return reading.start is not None and "word" in shape.facts(reading).kinds and bool(_SIGN.search(shape.text))


def _of_cycle(analysis: Analysis, start: int) -> Generator[Report, None, int]:
    """Follow a cycle from its start; the first line at which another may start."""
    document, fold = analysis.document, modal_of(analysis.dialect)
    assert fold is not None
    state, held = document.state(fold, start), None
    for at in range(start, document.line_count):
        line = Line(document.node(at), analysis.settings)
        found = words(line)
        made = motion(found, state)
        if _ends(line, found) or (made not in CYCLES and (made or at == start)):
            return at + 1
        if made:
            axis = _depth_axis(found, state)
            if not axis:
                return at + 1
            if held is None or in_force(state, "motion") != made:
                held = _Held(at)
            numbers = values(line)
            held.take(numbers, axis, at)
            distance = governs(found, state, "distance")
            if held.is_faulty(steps=distance == "G91") and distance in ("G90", "G91"):
                # With both of them on a line under G90 the line alone tells what is wrong.
                if distance == "G91" or not numbers.keys() >= {axis, "R"}:
                    yield _report(analysis, held, axis, at, steps=distance == "G91")
                return at + 1
        state = fold.plain(state, line.node.reading, line.node.shape)
    return document.line_count


def _ends(line: Line, found: Words) -> bool:
    """Whether what comes next is not certain."""
    read = line.node
    unclear = read.reading.start is None or bool(read.problems) or not found.clear
    return unclear or not read.kinds.isdisjoint(("o_line", "DELETE")) or not found.has.isdisjoint(_LEAVES)


def _depth_axis(found: Words, state: State) -> str:
    """The letter of the depth in the plane of a line; empty where that is not followed or a diameter."""
    axis = _DEPTH.get(governs(found, state, "plane") or "", "")
    return axis if axis != "X" or in_force(state, "lathe-diameter") in ("", "G8") else ""


def _report(analysis: Analysis, held: _Held, axis: str, at: int, steps: bool) -> Report:
    """On the word of the line that goes wrong: R or the depth, or its first axis word where it writes neither."""
    line = Line(analysis.document.node(at), analysis.settings)
    found = words(line)
    own = next((letter for letter in (axis, "R") if letter in found.has), "")
    above = "is a way up from R under `G91`" if steps else f"lies above the level {_written(analysis, held.level)}"
    if own == axis:
        why = above
    elif own and not steps:
        why = f"lies below the depth {_written(analysis, held.depth)}"
    else:
        why = f"goes on to the depth {_written(analysis, held.depth)}, which {above}"
    word = found.first(*([own] if own else AXES))
    return report(line, word, f"`{said(line, word)}` {why}; the control stops here")._replace(line=at)


def _written(analysis: Analysis, number: _Number) -> str:
    line = Line(analysis.document.node(number.row), analysis.settings)
    return f"`{said(line, words(line).first(number.letter))}` of line {number.row + 1}"
