"""Where the tool stands along a program, as far as literal words say it, and the moves on the way that a rule looks at. Never guesses: what is not certain is None."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from math import isnan, nan
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.formats.tools import read
from deburr.modal import Modal, State, modal_of
from deburr.rule import Line, Report
from deburr.rules.rs274._moves import (
    LINEAR,
    STAYS,
    Change,
    Modes,
    Way,
    change_of,
    counts,
    may_shift,
    only_named,
    without_words,
)
from deburr.rules.rs274._offsets import HOME, Offsets, Point, at_start, behind, unknown
from deburr.rules.rs274._words import Words, report, said, values, words
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Piece
    from deburr_grammar.line import Shape


class Move(NamedTuple):
    """A move: what is in force, where it starts, and its words; X is a coordinate, and no diameter."""

    modes: Modes
    start: Point
    numbers: dict[str, float]


class Watch(NamedTuple):
    """What a rule looks at.

    ``sign``, ``words``: a line is such a move by what the one finds, and by one of these letters and codes, or follows one.
    ``modes``: under which modes it is made; None: it is no such move.
    ``needs_start``: whether where it starts has a say under these modes.
    ``judge``: what is wrong with one, or nothing.
    ``exact``: whether only a coordinate that an absolute word names counts as known. The control reckons with offsets and
    steps, and what comes of it may differ in the last digit.
    """

    name: str
    sign: re.Pattern[str]
    words: frozenset[str]
    modes: Callable[[Line, State], Modes | None]
    needs_start: Callable[[Modes], bool]
    judge: Callable[[Move], str]
    exact: bool = False


class _From(NamedTuple):
    """A coordinate by what it was at the start of a chunk: so many times that (no number: nobody knows how many), plus so much."""

    times: float
    plus: float


_Place = tuple[_From | None, _From | None, _From | None]
_BEFORE = _From(1.0, 0.0)
_START: _Place = (_BEFORE, _BEFORE, _BEFORE)


class _Open(NamedTuple):
    """A move that starts where a chunk starts, or so much further."""

    line: int
    modes: Modes
    start: _Place
    numbers: dict[str, float]


class _Way(NamedTuple):
    """A chunk: its lines, counted from its first, with moves in which something is wrong, moves that hang on what stands before it, and where it leads."""

    faults: tuple[tuple[int, str], ...]
    open: tuple[_Open, ...]
    end: _Place
    offsets: Offsets | None = None
    """Where offsets are followed, those behind it."""


class _Step(NamedTuple):
    """A shape under a state: what it does to the position (None: that hangs on numbers of the line), whether it must be looked at, under which modes it is a move to look at, how its words are read, the state behind it (None: it depends on the line)."""

    change: Change | None
    matters: bool
    modes: Modes | None
    simple: bool
    after: State | None


_SIMPLE = re.compile(r"[ \t]*(?:[A-Za-z][+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[ \t]*)+")
_WORD = re.compile(r"([IJKRXYZ])([+-]?[0-9.]+)")
_OF_TOOLS = re.compile("10|43")
"""Digits of codes that tell offsets of tools."""


def faults(analysis: Analysis, watch: Watch) -> Iterator[tuple[int, str] | None]:
    """The lines of moves with which something is wrong, and what, with a None before each chunk. Where a chunk has none to look at, nothing is followed."""
    stateful = analysis.ruleset.stateful
    fold = modal_of(analysis.dialect)
    if stateful is None or fold is None:
        return
    walk = _Walk(analysis, fold, watch)
    offsets, here = at_start(analysis, walk.steady)
    passed: list[tuple[Piece, State]] = []
    for piece, state in stateful.states(analysis.document):
        yield None
        shifts = walk.shifts(piece)
        if not shifts and not walk.concerns(piece):
            passed.append((piece, state))
            continue
        here = walk.behind(passed, here)
        passed.clear()
        way = walk.among(piece, state, offsets, here) if shifts else walk.through(piece, state)
        offsets = way.offsets or offsets
        judged = [(move.line, watch.judge(Move(move.modes, _at(move.start, here), move.numbers))) for move in way.open]
        yield from ((piece.line + index, why) for index, why in sorted([*way.faults, *judged]) if why)
        here = _at(way.end, here)


def reports(analysis: Analysis, watch: Watch, number_of: Callable[[Words], int]) -> Iterator[Report | None]:
    """The same as reports on a word of each line: ``number_of`` tells which one. None where the work can be left."""
    for fault in faults(analysis, watch):
        if fault is None:
            yield None
            continue
        at, why = fault
        line = Line(analysis.document.node(at), analysis.settings)
        number = number_of(words(line))
        yield report(line, number, f"`{said(line, number)}` {why}")._replace(line=at)


class _Walk:
    """Follows the position through chunks."""

    def __init__(self, analysis: Analysis, fold: Modal, watch: Watch) -> None:
        self._watch = watch
        self._document = analysis.document
        self._settings = analysis.settings
        self._fold = fold
        self._steps: dict[tuple[State, str], dict[Shape, _Step]] = {}
        self.steady = _steady(analysis)
        """The axes along which no tool has an offset."""

    def concerns(self, piece: Piece) -> bool:
        """Whether any line may be a move to look at."""
        key = ("rs274 has", self._watch.name, self._document.key(piece))
        if key not in piece.chunk.memo:
            piece.chunk.memo[key] = any(self._may_be_one(reading, shape) for reading, shape in piece.distinct())
        found: bool = piece.chunk.memo[key]
        return found

    def behind(self, passed: Sequence[tuple[Piece, State]], start: Point) -> Point:
        """The position behind chunks without such moves, seen from the last one: mostly it says all."""
        place = _START
        for piece, state in reversed(passed):
            if all(each is None or not each.times for each in place):
                break
            place = _after(self.through(piece, state).end, place)
        return _at(place, start)

    def through(self, piece: Piece, state: State) -> _Way:
        """What is wrong with the moves of a chunk, and where it leads; kept with the chunk."""
        key = ("rs274 moves", self._watch.name, self._document.key(piece), state, self.steady)
        kept: _Way | None = piece.chunk.memo.get(key)
        if kept is None:
            kept = piece.chunk.memo[key] = self._through(piece, state)
        return kept

    def shifts(self, piece: Piece) -> bool:
        """Whether any line may change offsets."""
        key = ("rs274 shifts", self._document.key(piece))
        if key not in piece.chunk.memo:
            piece.chunk.memo[key] = any(self._may_shift(reading, shape) for reading, shape in piece.distinct())
        found: bool = piece.chunk.memo[key]
        return found

    def among(self, piece: Piece, state: State, offsets: Offsets, here: Point) -> _Way:
        """The same of a chunk that changes offsets, behind what is known of them and of the place; kept with the chunk."""
        key = ("rs274 shifted", self._watch.name, self._document.key(piece), state, self.steady)
        kept: tuple[Offsets, Point, _Way] | None = piece.chunk.memo.get(key)
        if kept is None or kept[:2] != (offsets, here):
            kept = piece.chunk.memo[key] = (offsets, here, self._through(piece, state, offsets, here))
        return kept[2]

    def _may_shift(self, reading: Reading, shape: Shape) -> bool:
        if reading.start is None or "word" not in shape.facts(reading).kinds:
            return without_words(reading, shape).loses
        return may_shift(self._sample(reading, shape))

    def _may_be_one(self, reading: Reading, shape: Shape) -> bool:
        if reading.start is None or "word" not in shape.facts(reading).kinds or not self._watch.sign.search(shape.text):
            return False
        return not words(self._sample(reading, shape)).has.isdisjoint(self._watch.words)

    def _through(self, piece: Piece, state: State, offsets: Offsets | None = None, here: Point = HOME) -> _Way:
        held: dict[int, list[Bracket]] = {}
        for index, bracket in piece.outlined.brackets:
            held.setdefault(index, []).append(bracket)
        lines = piece.chunk.lines if piece.chunk.marked else ()
        path = _Path(piece, self._settings, self._watch, self.steady)
        if offsets is not None:
            path.start(offsets, here)
        for reading, first, shapes in piece.read():
            steps = self._under(state, reading)
            for index, shape in enumerate(shapes, first):
                step = steps.get(shape) or self._step(state, reading, shape)
                if step.matters:
                    change = step.change
                    if change is None:
                        change = self._change(Line(piece.node(index), self._settings), state)
                    if change.shifts:
                        path.shift(Line(piece.node(index), self._settings), state, change)
                    path.go(index, change, step.modes, step.simple)
                after = step.after
                if after is None:
                    after = self._fold.marked(state, LineNode(lines[index], reading, shape), held.get(index, ()))
                if after is not state:
                    state = after
                    steps = self._under(state, reading)
        return path.way()

    def _under(self, state: State, reading: Reading) -> dict[Shape, _Step]:
        return self._steps.setdefault((state, reading.name), {})

    def _step(self, state: State, reading: Reading, shape: Shape) -> _Step:
        after = None if shape.marked else self._fold.plain(state, reading, shape)
        if reading.start is None or "word" not in shape.facts(reading).kinds:
            change = without_words(reading, shape)
            step = _Step(change, change != STAYS, None, False, after)
        else:
            line = self._sample(reading, shape)
            modes, simple = self._watch.modes(line, state), _SIMPLE.fullmatch(shape.text) is not None
            own = None if counts(line, state) else self._change(line, state)
            step = _Step(own, modes is not None or own != STAYS, modes, simple, after)
        self._under(state, reading)[shape] = step
        return step

    def _change(self, line: Line, state: State) -> Change:
        change = change_of(line, state)
        return only_named(change) if self._watch.exact else change

    def _sample(self, reading: Reading, shape: Shape) -> Line:
        return Line(LineNode(shape.text, reading, shape), self._settings)


class _Path:
    """The way through a chunk. Lines are only read when a move to look at, or the end, asks where they have led."""

    def __init__(self, piece: Piece, settings: Mapping[str, Any], watch: Watch, steady: Set[str]) -> None:
        self._place = _START
        self._piece = piece
        self._lines = piece.chunk.lines
        self._settings = settings
        self._watch = watch
        self._moves: list[tuple[int, Change, bool]] = []
        self._last: tuple[int, dict[str, float]] = (-1, {})
        self._faults: list[tuple[int, str]] = []
        self._open: list[_Open] = []
        self._steady = steady
        self._offsets: Offsets | None = None

    def start(self, offsets: Offsets, here: Point) -> None:
        """Follow offsets, too, from what is known of them and of the place."""
        self._offsets = offsets
        self._place = _placed(here)

    def shift(self, line: Line, state: State, change: Change) -> None:
        """Follow what a line does to offsets before it moves."""
        place = self._reckoned()
        here = _at(_scaled(place, change.factor) if change.factor != 1 else place, HOME)
        self._offsets, there = behind(self._offsets or unknown(self._steady), here, line, state, self._steady)
        if self._watch.exact:
            # What G92 names is certain to the last digit; all else is reckoned with offsets.
            named = "G92" in words(line).has
            x, y, z = (new if new == old or named else None for old, new in zip(here, there))
            self._offsets, there = unknown(self._steady), (x, y, z)
        self._place = _placed(there)

    def go(self, index: int, change: Change, modes: Modes | None, simple: bool) -> None:
        """Follow a line. ``simple``: whether it holds nothing but letters and plain numbers."""
        if change.loses and self._offsets is not None:
            self._offsets = unknown(self._steady)
        if change.factor != 1 and not change.shifts:
            self._place = _scaled(self._reckoned(), change.factor)
        if modes is not None:
            numbers = self._numbers(index, simple)
            if modes.share != 1 and "X" in numbers:
                numbers = {**numbers, "X": numbers["X"] * modes.share}
            self._look_at(_Open(index, modes, self._reckoned(), numbers))
        if change.axes:
            self._moves.append((index, change, simple))

    def way(self) -> _Way:
        """All of it."""
        return _Way(tuple(self._faults), tuple(self._open), self._reckoned(), self._offsets)

    def _look_at(self, move: _Open) -> None:
        x, y, z = move.start
        hangs = (x is not None and x.times) or (y is not None and y.times) or (z is not None and z.times)
        if hangs and self._watch.needs_start(move.modes):
            self._open.append(move)
            return
        start = _at(move.start, HOME) if hangs else (x and x.plus, y and y.plus, z and z.plus)
        if why := self._watch.judge(Move(move.modes, start, move.numbers)):
            self._faults.append((move.line, why))

    def _reckoned(self) -> _Place:
        """Where the moves have led: each coordinate from the last place that is known, and all ways behind it."""
        if not self._moves:
            return self._place
        found: dict[str, _From | None] = {}
        ways: dict[str, list[float]] = {}
        for index, change, simple in reversed(self._moves):
            for axis, (way, letter) in change.axes.items():
                if axis in found:
                    continue
                number = None if way is Way.LOST else self._numbers(index, simple).get(letter)
                if number is not None and letter == "X":
                    number *= change.share
                if number is not None and way is Way.BY:
                    ways.setdefault(axis, []).append(number)
                else:
                    found[axis] = None if number is None else _From(0.0, number)
            if len(found) == len(LINEAR):
                break
        x, y, z = self._place
        self._moves = []
        self._place = found.get("X", x), found.get("Y", y), found.get("Z", z)
        if ways:
            x, y, z = (_further(place, ways.get(axis, [])) for axis, place in zip(LINEAR, self._place))
            self._place = x, y, z
        return self._place

    def _numbers(self, index: int, simple: bool) -> dict[str, float]:
        """The words of a line that are numbers. Arc follows arc, so the last one is often asked for again."""
        if index != self._last[0]:
            self._last = (index, self._read(index, simple))
        return self._last[1]

    def _read(self, index: int, simple: bool) -> dict[str, float]:
        if simple:
            return {letter: float(number) for letter, number in _WORD.findall(self._lines[index].upper())}
        found = values(Line(self._piece.node(index), self._settings))
        return {letter: number for letter, number in found.items() if number is not None}


def _steady(analysis: Analysis) -> frozenset[str]:
    """The axes along which no tool of the configured table has an offset; none if the table is not known, or the program changes it or says an offset itself."""
    path = analysis.settings["tool-table"]
    table = analysis.host.read(path) if path else None
    if table is None or any(_changes_tools(piece, analysis) for piece in analysis.document.pieces()):
        return frozenset()
    return frozenset(axis for axis in LINEAR if not any(tool.get(axis) for tool in read(table).words.values()))


def _changes_tools(piece: Piece, analysis: Analysis) -> bool:
    for reading, first, shapes in piece.read():
        data = {shape for shape in set(shapes) if "word" in shape.facts(reading).kinds and _OF_TOOLS.search(shape.text)}
        for index, shape in enumerate(shapes, first) if data else ():
            if shape in data:
                line = Line(piece.node(index), analysis.settings)
                has = words(line).has
                if "G43.1" in has or ("G10" in has and values(line).get("L") not in (2, 20)):
                    return True
    return False


def _further(place: _From | None, ways: list[float]) -> _From | None:
    """A coordinate behind ways of which the last stands first."""
    if place is None:
        return None
    plus = place.plus
    for way in reversed(ways):
        plus += way
    return _From(place.times, plus)


def _scaled(place: _Place, factor: float | None) -> _Place:
    """The same place in other units: where nobody knows which they were, only zero is the same."""
    x, y, z = (each and _joined(each, _From(nan if factor is None else factor, 0.0)) for each in place)
    return x, y, z


def _after(first: Iterable[_From | None], then: _Place) -> _Place:
    """One way behind another."""
    x, y, z = (two if two is None or not two.times else one and _joined(one, two) for one, two in zip(first, then))
    return x, y, z


def _placed(point: Point) -> _Place:
    """A place that hangs on nothing."""
    x, y, z = (None if each is None else _From(0.0, each) for each in point)
    return x, y, z


def _at(place: _Place, start: Point) -> Point:
    """A place by where its chunk starts."""
    there = _after((None if x is None else _From(0.0, x) for x in start), place)
    x, y, z = (each and each.plus for each in there)
    return x, y, z


def _joined(one: _From, two: _From) -> _From | None:
    plus = _times(two.times, one.plus) + two.plus
    return None if isnan(plus) else _From(_times(two.times, one.times), plus)


def _times(factor: float, value: float) -> float:
    """A product in which zero is zero whatever the factor."""
    return factor * value if value else 0.0
