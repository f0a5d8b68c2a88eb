"""Where the tool stands along a program, as far as literal words say it, and the arcs on the way. Never guesses: what is not certain is None."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import inf, isinf
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.modal import Modal, State, modal_of
from deburr.rule import Line
from deburr.rules.rs274._moves import Kind, Modes, arc_modes, kind_of, without_words
from deburr.rules.rs274._words import values, words
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Piece
    from deburr_grammar.line import Shape

Position = tuple[float | None, float | None, float | None]
"""X, Y and Z in the units in force."""
HOME: Position = (0.0, 0.0, 0.0)
"""Where a program starts for the interpreter."""
NOWHERE: Position = (None, None, None)
_BEFORE = inf
_BEFORE_IF_ZERO = -inf
"""No positions: what stood there before, and that if it was zero."""
_AS_BEFORE: Position = (_BEFORE, _BEFORE, _BEFORE)


class Arc(NamedTuple):
    """An arc: what is in force, where it starts, and its words."""

    modes: Modes
    start: Position
    numbers: dict[str, float]


Judge = Callable[[Arc], str]
"""What is wrong with an arc, or nothing."""
Faults = tuple[tuple[int, str], ...]
"""Lines of a chunk, counted from its first, and what is wrong with the arcs there."""


class _Step(NamedTuple):
    """A shape under a state: what it does to the position, whether it must be looked at, under which modes it is an arc, how its words are read, the axes in it, the state behind it (None: it depends on the line)."""

    kind: Kind
    matters: bool
    arc: Modes | None
    simple: bool
    axes: frozenset[str]
    after: State | None


_ARC = re.compile(r"[IJKRijkr]|[Gg][^A-Za-z]*[23]")
"""What a line may be an arc by."""
_SIMPLE = re.compile(r"[ \t]*(?:[A-Za-z][+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[ \t]*)+")
_WORD = re.compile(r"([IJKRXYZ])([+-]?[0-9.]+)")


def faults(analysis: Analysis, judge: Judge) -> Iterator[tuple[int, str]]:
    """The lines of arcs with which something is wrong, and what. Where a chunk has no arcs, nothing is followed."""
    stateful = analysis.ruleset.stateful
    fold = modal_of(analysis.dialect)
    if stateful is None or fold is None:
        return
    walk = _Walk(analysis, fold, judge)
    behind = HOME
    passed: list[tuple[Piece, State]] = []
    for piece, state in stateful.states(analysis.document):
        if not walk.has_arcs(piece):
            passed.append((piece, state))
            continue
        found, behind = walk.through(piece, state, walk.behind(passed, behind))
        passed.clear()
        yield from ((piece.line + index, why) for index, why in found)


class _Walk:
    """Follows the position through chunks."""

    def __init__(self, analysis: Analysis, fold: Modal, judge: Judge) -> None:
        self._judge = judge
        self._document = analysis.document
        self._settings = analysis.settings
        self._fold = fold
        self._steps: dict[tuple[State, str], dict[Shape, _Step]] = {}

    def has_arcs(self, piece: Piece) -> bool:
        """Whether any line may be an arc."""
        key = ("rs274 has arcs", self._document.key(piece))
        if key not in piece.chunk.memo:
            piece.chunk.memo[key] = any(self._may_be_arc(reading, shape) for reading, shape in piece.distinct())
        found: bool = piece.chunk.memo[key]
        return found

    def behind(self, passed: Sequence[tuple[Piece, State]], start: Position) -> Position:
        """The position behind chunks without arcs, seen from the last one: mostly it says all."""
        position = _AS_BEFORE
        for piece, state in reversed(passed):
            if not any(value is not None and isinf(value) for value in position):
                return position
            position = _filled(position, self.through(piece, state, _AS_BEFORE)[1])
        return _filled(position, start)

    def through(self, piece: Piece, state: State, position: Position) -> tuple[Faults, Position]:
        """What is wrong with the arcs of a chunk, and the position behind it; kept with the chunk."""
        key = ("rs274 arcs", self._document.key(piece), state, position)
        kept: tuple[Faults, Position] | None = piece.chunk.memo.get(key)
        if kept is None:
            kept = piece.chunk.memo[key] = self._through(piece, state, position)
        return kept

    def _may_be_arc(self, reading: Reading, shape: Shape) -> bool:
        if reading.start is None or "word" not in shape.facts(reading).kinds or not _ARC.search(shape.text):
            return False
        return not words(self._sample(reading, shape)).has.isdisjoint(("G2", "G3", "I", "J", "K", "R"))

    def _through(self, piece: Piece, state: State, position: Position) -> tuple[Faults, Position]:
        found: list[tuple[int, str]] = []
        held: dict[int, list[Bracket]] = {}
        for index, bracket in piece.outlined.brackets:
            held.setdefault(index, []).append(bracket)
        lines = piece.chunk.lines if piece.chunk.marked else ()
        path = _Path(position, piece, self._settings)
        for reading, first, shapes in piece.read():
            steps = self._under(state, reading)
            for index, shape in enumerate(shapes, first):
                step = steps.get(shape) or self._step(state, reading, shape)
                if step.matters:
                    if step.arc is not None and (why := self._judge(path.arc(index, step))):
                        found.append((index, why))
                    path.go(index, step)
                after = step.after
                if after is None:
                    after = self._fold.marked(state, LineNode(lines[index], reading, shape), held.get(index, ()))
                if after is not state:
                    state = after
                    steps = self._under(state, reading)
        return tuple(found), path.position()

    def _under(self, state: State, reading: Reading) -> dict[Shape, _Step]:
        return self._steps.setdefault((state, reading.name), {})

    def _step(self, state: State, reading: Reading, shape: Shape) -> _Step:
        after = None if shape.marked else self._fold.plain(state, reading, shape)
        if reading.start is None or "word" not in shape.facts(reading).kinds:
            kind = without_words(reading, shape)
            step = _Step(kind, kind is not Kind.SKIPS, None, False, frozenset(), after)
        else:
            line = self._sample(reading, shape)
            kind, arc = kind_of(line, state), arc_modes(line, state)
            simple = _SIMPLE.fullmatch(shape.text) is not None
            axes = words(line).has & {"X", "Y", "Z"}
            step = _Step(kind, arc is not None or kind is not Kind.SKIPS, arc, simple, axes, after)
        self._under(state, reading)[shape] = step
        return step

    def _sample(self, reading: Reading, shape: Shape) -> Line:
        return Line(LineNode(shape.text, reading, shape), self._settings)


class _Path:
    """The way through a chunk. Moves are only read when an arc, or the end, asks where they have led."""

    def __init__(self, start: Position, piece: Piece, settings: Mapping[str, Any]) -> None:
        self._start = start
        self._piece = piece
        self._lines = piece.chunk.lines
        self._settings = settings
        self._moves: list[tuple[int, _Step]] = []
        self._last: tuple[int, dict[str, float]] = (-1, {})

    def go(self, index: int, step: _Step) -> None:
        """Follow a line."""
        match step.kind:
            case Kind.MOVES:
                self._moves.append((index, step))
            case Kind.SWITCHES:
                self._start = _switched(self.position())
                self._moves.append((index, step))
            case Kind.LOSES:
                self._start, self._moves = NOWHERE, []

    def arc(self, index: int, step: _Step) -> Arc:
        """The arc that a line is."""
        assert step.arc is not None
        start = self.position()
        return Arc(step.arc, _switched(start) if step.kind is Kind.SWITCHES else start, self._numbers(index, step))

    def position(self) -> Position:
        """Where the moves have led."""
        x, y, z = self._start
        left = "XYZ"
        for index, step in reversed(self._moves):
            if step.axes.isdisjoint(left):
                continue
            numbers = self._numbers(index, step)
            x = numbers["X"] if "X" in left and "X" in step.axes else x
            y = numbers["Y"] if "Y" in left and "Y" in step.axes else y
            z = numbers["Z"] if "Z" in left and "Z" in step.axes else z
            left = "".join(axis for axis in left if axis not in step.axes)
            if not left:
                break
        self._start, self._moves = (x, y, z), []
        return self._start

    def _numbers(self, index: int, step: _Step) -> dict[str, float]:
        """The words of a line that are numbers. Arc follows arc, so the last one is often asked for again."""
        if index != self._last[0]:
            self._last = (index, self._read(index, step))
        return self._last[1]

    def _read(self, index: int, step: _Step) -> dict[str, float]:
        if step.simple:
            return {letter: float(number) for letter, number in _WORD.findall(self._lines[index].upper())}
        found = values(Line(self._piece.node(index), self._settings))
        return {letter: number for letter, number in found.items() if number is not None}


def _switched(position: Position) -> Position:
    """Where the tool stands in other units: only zero is the same."""
    x, y, z = (
        0.0 if value == 0 else _BEFORE_IF_ZERO if value is not None and isinf(value) else None for value in position
    )
    return x, y, z


def _filled(position: Position, before: Position) -> Position:
    """A position with what stood before where it says so."""
    switched = _switched(before)
    x, y, z = (
        old if now == _BEFORE else zero if now == _BEFORE_IF_ZERO else now
        for now, old, zero in zip(position, before, switched)
    )
    return x, y, z
