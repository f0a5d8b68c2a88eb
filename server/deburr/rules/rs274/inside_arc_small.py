"""Inside arc that is too small for the tool of cutter compensation.

To the left of the path (`G41.1`) a counterclockwise arc is an inside one, to the right (`G42.1`) a clockwise one; with a negative D it is
the other way round. The radius of such an arc must exceed that of the tool, half of D. The control stops with "Tool radius not less than
arc radius with comp". Arcs are judged whose radius the line tells by itself (R, or the centre as a way from the start), as far as lines
that are certain to run lead from the D word to them; the tools of `G41` and `G42` are the machine's.

Source: spec/rs274.md §5

Bad:

    F100
    G41.1 D10
    G1 X20
    G3 X22 Y2 R2
    ^^

Bad:

    F100
    G42.1 D10
    G1 X20
    G2 X24 I2
    ^^

Bad:

    F100
    G41.1 D-10
    G1 X20
    G2 X24 I2
    ^^

Good:

    F100
    G41.1 D10
    G1 X20
    G2 X24 I2
    G3 X40 I8
    G40
    G1 X50
    G3 X54 I2
"""

import re
from collections.abc import Iterator
from math import hypot
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.modal import State, modal_of
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.rs274._moves import change_of, share_of, without_words
from deburr.rules.rs274._words import ARCS, governs, motion, report, said, values, words
from deburr_grammar.dialect import Reading
from deburr_grammar.dialects.rs274.modality import AXES
from deburr_grammar.document import Piece
from deburr_grammar.line import Shape

_TOLD = re.compile(r"[Gg][^A-Za-z]*4[^A-Za-z]*[12][^A-Za-z]*\.")
_LEFT = {"G41.1": True, "G42.1": False}
_CHANGES = frozenset(("G40", "G41", "G41.1", "G42", "G42.1"))
_SPIRAL = 0.0283
"""By how much the radii to the ends of an arc may differ, in the larger of its units (arc-radius): within that nothing is said."""


class _Tool(NamedTuple):
    """What compensates: its radius, whether it keeps to the left, and the code of its units."""

    radius: float
    left: bool
    units: str | None


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the code, or the first word, of such arcs."""
    stateful, fold = analysis.ruleset.stateful, modal_of(analysis.dialect)
    if stateful is None or fold is None:
        return
    tool: _Tool | None = None
    for piece, start in stateful.states(analysis.document):
        yield None
        if tool is None and not _tells(piece):
            continue
        state: State | None = start
        for reading, first, shapes in piece.read():
            for index, shape in enumerate(shapes, first):
                if state is None or shape.marked:
                    # What a block leaves in force is told at the next piece.
                    state = tool = None
                    continue
                if reading.start is not None:
                    line = Line(piece.node(index), analysis.settings)
                    tool = _behind(line, state, tool, reading, shape)
                    if tool is not None and (why := _why(line, state, tool)):
                        found = words(line)
                        at = found.first(*(ARCS if not ARCS.isdisjoint(found.has) else AXES | set("IJR")))
                        yield report(line, at, f"`{said(line, at)}` {why}")._replace(line=piece.line + index)
                state = fold.plain(state, reading, shape)


def _tells(piece: Piece) -> bool:
    """Whether a chunk has a tool's radius; kept with it."""
    if "rs274 radius" not in piece.chunk.memo:
        piece.chunk.memo["rs274 radius"] = any(_TOLD.search(shape.text) for shape in piece.chunk.distinct)
    found: bool = piece.chunk.memo["rs274 radius"]
    return found


def _behind(line: Line, state: State, tool: _Tool | None, reading: Reading, shape: Shape) -> _Tool | None:
    """The tool for what a line does: its own, or the one before it if nothing on the line can change it."""
    if "word" not in shape.facts(reading).kinds:
        return None if without_words(reading, shape).loses else tool
    found = words(line)
    if change_of(line, state).loses:
        return None
    if found.has.isdisjoint(_CHANGES):
        return tool
    code = found.of("cutter-compensation")
    diameter = values(line).get("D")
    if code not in _LEFT or diameter is None or found.axes:
        return None
    return _Tool(abs(diameter) / 2, _LEFT[code] is (diameter > 0), _units(line, state))


def _units(line: Line, state: State) -> str | None:
    return words(line).of("units") or ("" if state.untouched("units") else state.code("units"))


def _why(line: Line, state: State, tool: _Tool) -> str:
    """What is wrong with an arc, or nothing."""
    found = words(line)
    made = motion(found, state)
    units = _units(line, state)
    if made not in ARCS or (made == "G3") is not tool.left or units is None or units != tool.units:
        return ""
    if governs(found, state, "plane") != "G17" or share_of(found, state) is None or not found.has.isdisjoint("K@^"):
        return ""
    said_of = values(line)
    if "R" in said_of:
        radius = said_of["R"]
    elif governs(found, state, "arc-distance") == "G91.1" and not found.has.isdisjoint("IJ"):
        i, j = said_of.get("I", 0.0), said_of.get("J", 0.0)
        radius = None if i is None or j is None else hypot(i, j)
    else:
        radius = None
    if radius is None or not abs(radius) + _SPIRAL < tool.radius:
        return ""
    return (
        f"is an inside arc of radius {abs(radius):g}, and cutter compensation keeps a tool of radius {tool.radius:g} beside it;"
        " the tool does not fit in"
    )
