"""A program as an immutable tree of chunks: parse it whole, edit it in place. Never opens a file, never raises for a faulty program."""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterator, Sequence
from functools import cached_property
from itertools import islice, pairwise
from typing import Generic, NamedTuple, TypeVar

from deburr_grammar.chunk import SIZE, Branch, Chunk, grown
from deburr_grammar.dialect import Bracket, Dialect, Reading
from deburr_grammar.dialect import Step as Done
from deburr_grammar.editing import Place, replaced
from deburr_grammar.fold import Fold, carried, keep, through
from deburr_grammar.line import LineNode, Shape, shapes_of
from deburr_grammar.outline import Before, Outlined, Outliner, Stepped, facts_of
from deburr_grammar.problem import Problem
from deburr_grammar.search import Partners, Step
from deburr_grammar.structure import Balance, StructureFault, faults_of
from deburr_grammar.text import Edit, Pos, cut_points

S = TypeVar("S", bound=Hashable)
T = TypeVar("T")
G = TypeVar("G")


class Piece(NamedTuple):
    """A chunk in its place: its first line's number, what holds before it, and how its lines are read."""

    line: int
    chunk: Chunk
    before: Before
    outlined: Outlined

    @property
    def lines(self) -> int:
        """How many lines the chunk holds, its tail included."""
        return len(self.chunk.shapes)

    def node(self, index: int) -> LineNode:
        """A line of the chunk, counted from its first."""
        return LineNode(self.chunk.line(index), self.outlined.reading(index), self.chunk.shapes[index])

    def read(self) -> Iterator[tuple[Reading, int, list[Shape]]]:
        """Stretches of lines under one reading: the reading, its first line, the shapes."""
        shapes = self.chunk.shapes
        for reading, first, stop in self._stretches():
            yield reading, first, shapes if stop - first == len(shapes) else shapes[first:stop]

    def distinct(self) -> Iterator[tuple[Reading, Shape]]:
        """What lines there are: each reading with each of its shapes once, if it is in one stretch."""
        for reading, first, stop in self._stretches():
            yield from ((reading, shape) for shape in self._distinct(first, stop))

    def where(self, says: Callable[[Reading, Shape], object]) -> Iterator[tuple[int, Reading, Shape]]:
        """The lines whose shapes are such as ``says`` says, in order; it is asked once for each shape of a stretch."""
        shapes = self.chunk.shapes
        for reading, first, stop in self._stretches():
            wanted = {shape for shape in self._distinct(first, stop) if says(reading, shape)}
            yield from ((index, reading, shapes[index]) for index in self.chunk.where(wanted, first, stop))

    def _stretches(self) -> Iterator[tuple[Reading, int, int]]:
        """The readings, each with its first line and the line behind its last."""
        runs = self.outlined.runs
        for number, (first, reading) in enumerate(runs):
            stop = runs[number + 1][0] if number + 1 < len(runs) else len(self.chunk.shapes)
            if first < stop:
                yield reading, first, stop

    def _distinct(self, first: int, stop: int) -> Collection[Shape]:
        shapes = self.chunk.shapes
        return self.chunk.distinct if stop - first == len(shapes) else set(shapes[first:stop])


class Gathering(NamedTuple, Generic[G]):
    """What is gathered from pieces. It may hang on a piece's text, its readings and ``key`` alone, and is kept with chunks and branches.

    ``join`` is given what parts come to that stand one behind the other, or a piece alone.
    """

    key: Hashable
    of: Callable[[Piece], G]
    join: Callable[[Sequence[G]], G]


class _Way(NamedTuple):
    """From the root to a chunk, and the chunk in its place."""

    path: list[Step]
    piece: Piece


class Document:
    """One version of a program. `edit` gives the next one and shares what it did not touch."""

    def __init__(self, dialect: Dialect, root: Branch, size: int = SIZE, given: frozenset[str] = frozenset()) -> None:
        self.dialect = dialect
        self._root = root
        self._size = size
        self._given = given
        self._last_way: _Way | None = None
        self._last_places: tuple[Place, ...] = ()
        self._known_pieces: list[Piece] = []

    @classmethod
    def parse(cls, text: str, dialect: Dialect, size: int = SIZE, given: frozenset[str] = frozenset()) -> Document:
        """A document of the text, in chunks of about ``size`` characters. Nothing is read before it is asked for.

        ``given``: facts for the outline that come from elsewhere, `Dialect.given`.
        """
        cuts = [0, *cut_points(text, size), len(text)]
        table = shapes_of(dialect)
        return cls(dialect, grown([Chunk(text[a:b], table) for a, b in pairwise(cuts)]), size, given)

    def under(self, given: frozenset[str]) -> Document:
        """The same text under other facts from elsewhere."""
        return self if given == self._given else Document(self.dialect, self._root, self._size, given)

    @property
    def text(self) -> str:
        """The whole text, to the character as it was given."""
        return "".join(chunk.text for chunk in self.chunks())

    @property
    def line_count(self) -> int:
        """How many lines there are; a text that ends with a line end has an empty last one."""
        return self._root.eols + 1

    @property
    def rows(self) -> int:
        """How many lines a control reads: what stands behind the last line end is one if anything stands there."""
        last = self._root.eols
        return last + (self.line(last) != "")

    def chunks(self) -> Iterator[Chunk]:
        """The chunks in order."""
        return _chunks(self._root)

    def line(self, line: int) -> str:
        """A line's text without its ending."""
        place = self._place(line)
        return place.chunk.line(line - place.line)

    def node(self, line: int) -> LineNode:
        """A line as it is read where it stands."""
        piece = self.piece(line)
        index = line - piece.line
        shapes = piece.chunk.shapes
        shape = shapes[index] if index < len(shapes) else piece.chunk.table[""]
        return LineNode(piece.chunk.line(index), piece.outlined.reading(index), shape)

    def nodes(self) -> Iterator[LineNode]:
        """All lines."""
        return (self.node(line) for line in range(self.line_count))

    def piece(self, line: int) -> Piece:
        """The chunk that holds a line."""
        return self._way(line).piece

    def pieces(self) -> Iterator[Piece]:
        """The chunks in order, each in its place."""
        at = 0
        while True:
            # Each is placed when it is first come to: whoever works in steps must be able to leave between two.
            if at == len(self._known_pieces) and (piece := next(self._placing, None)):
                self._known_pieces.append(piece)
            if at == len(self._known_pieces):
                return
            yield self._known_pieces[at]
            at += 1

    @cached_property
    def _placing(self) -> Iterator[Piece]:
        """The pieces that have not been come to yet."""
        return self._all_pieces()

    def _all_pieces(self) -> Iterator[Piece]:
        first = 0
        for chunk, before in self._placed(self._root, self._outliner.start):
            yield Piece(first, chunk, before, self._outliner.outlined(chunk, before))
            first += chunk.eols

    def steps(self, piece: Piece) -> Iterator[Stepped]:
        """The marked lines of a piece, each with what holds before and behind it."""
        return self._outliner.steps(piece.chunk, piece.before)

    def step(self, before: Before, shape: Shape, text: str) -> Done:
        """What a line would do where that holds before it."""
        return self._outliner.step(before, shape, text)

    def key(self, piece: Piece) -> Hashable:
        """What the lines of a piece depend on besides their text: room for findings can be kept under it."""
        return self._outliner.key(piece.chunk, piece.before)

    @property
    def facts(self) -> frozenset[str]:
        """What the dialect's outline gathered from the whole text."""
        return self._outliner.facts

    def problems(self) -> Iterator[tuple[int, Problem]]:
        """All syntax faults with their lines, in order. Only lines that are read have any."""
        for piece in self.pieces():
            for index, _, _ in piece.where(lambda reading, shape: shape.facts(reading).problems):
                for problem in piece.node(index).problems:
                    yield piece.line + index, problem

    def brackets(self) -> Iterator[tuple[int, Bracket]]:
        """All openers, closers and boundaries with their lines, in order."""
        for piece in self.pieces():
            for index, bracket in piece.outlined.brackets:
                yield piece.line + index, bracket

    @property
    def balance(self) -> Balance:
        """What the whole program closes and opens too much."""
        return self._outliner.behind(self._root, self._outliner.start).balance

    @cached_property
    def faults(self) -> tuple[StructureFault, ...]:
        """All faults of block structure, in order: mostly the same object where an edit changed none and moved none."""
        whole = self._outliner.reduction(self._root, self._outliner.start)
        return faults_of(whole, self.dialect.file_ends_region)

    def partner(self, line: int, bracket: Bracket) -> tuple[int, Bracket] | None:
        """The other end of an opener or closer by depth alone; None where there is none in its region."""
        return Partners(self._outliner, self._way(line).path).find(line, bracket)

    def around(self, line: int, col: int) -> tuple[int, Bracket] | None:
        """The opener of the innermost block that is open at a place, by depth alone; None outside all blocks of its region."""
        return Partners(self._outliner, self._way(line).path).around(line, col)

    def gathered(
        self,
        key: Hashable,
        of: Callable[[Piece], frozenset[S]],
        cut: Callable[[frozenset[S]], frozenset[S]] = lambda found: found,
    ) -> frozenset[S]:
        """What the pieces hold, united. It may hang on a piece's text, its readings and ``key`` alone, and is kept with chunks and branches.

        ``cut`` leaves what is wanted of many: what a whole loses so, its parts may lose before they are united. It belongs to the key.
        """
        return self.joined(Gathering(key, of, lambda parts: cut(_united(parts))))

    def gathering(self, key: Hashable, of: Callable[[Piece], frozenset[S]]) -> Iterator[None]:
        """Find what `gathered` gives without a ``cut``, in work that can be left behind each chunk."""
        return self.joining(Gathering(key, of, _united))

    def holding(self, key: Hashable, of: Callable[[Piece], frozenset[S]], item: S) -> Iterator[Piece]:
        """The pieces that hold an item of what is `gathered`, in order; branches without it are passed over."""
        found = self.led(Gathering(key, of, _united), None, lambda _, held: item in held, lambda state, _: state)
        return (piece for piece, _ in found)

    def joined(self, gathering: Gathering[G]) -> G:
        """What all pieces come to."""
        return self._joined(self._root, self._outliner.start, gathering)

    def alone(self, piece: Piece, gathering: Gathering[G]) -> G:
        """What a piece comes to."""
        return self._joined(piece.chunk, piece.before, gathering)

    def joining(self, gathering: Gathering[G]) -> Iterator[None]:
        """Find what `joined` gives, in work that can be left behind each chunk."""
        yield from self._joining(self._root, self._outliner.start, gathering)

    def led(
        self, gathering: Gathering[G], start: T, wanted: Callable[[T, G], bool], behind: Callable[[T, G], T]
    ) -> Iterator[tuple[Piece, T]]:
        """The pieces that are wanted, in order, with the state before each that goes through the program; branches that are not wanted are passed over.

        ``wanted`` and ``behind`` are given the state before a part, and what is gathered from it.
        """
        waiting: list[tuple[Branch | Chunk, Before, T, int]] = [(self._root, self._outliner.start, start, 0)]
        while waiting:
            node, before, state, line = waiting.pop()
            if not wanted(state, self._joined(node, before, gathering)):
                continue
            if isinstance(node, Chunk):
                yield Piece(line, node, before, self._outliner.outlined(node, before)), state
                continue
            inner = []
            for child, held in self._outliner.inner(node, before):
                inner.append((child, held, state, line))
                state = behind(state, self._joined(child, held, gathering))
                line += child.eols
            waiting += reversed(inner)

    def _joining(self, node: Branch | Chunk, before: Before, gathering: Gathering[G]) -> Iterator[None]:
        if (gathering.key, self._outliner.key(node, before)) in node.memo:
            return
        for child, held in self._outliner.inner(node, before) if isinstance(node, Branch) else ():
            yield from self._joining(child, held, gathering)
        self._joined(node, before, gathering)
        yield

    def _joined(self, node: Branch | Chunk, before: Before, gathering: Gathering[G]) -> G:
        full = (gathering.key, self._outliner.key(node, before))
        found: G | None = node.memo.get(full)
        if found is None:
            if isinstance(node, Chunk):
                found = gathering.join((gathering.of(Piece(0, node, before, self._outliner.outlined(node, before))),))
            else:
                inner = self._outliner.inner(node, before)
                found = gathering.join([self._joined(child, held, gathering) for child, held in inner])
            self._outliner.keep(node, full, found)
        return found

    def state(self, fold: Fold[S], line: int) -> S:
        """The state of a fold before a line."""
        state = fold.start
        path, piece = self._way(line)
        for step in path:
            for child, before in islice(self._outliner.inner(step.branch, step.top), step.number):
                state = carried(fold, state, child, before, self._outliner)
        return through(fold, state, piece.chunk, piece.outlined, line - piece.line)

    def keep_state(self, fold: Fold[S], piece: Piece, before: S, behind: S) -> None:
        """Keep the state behind a piece that somebody found in another way than by `state`, under the one before it."""
        keep(fold, before, piece.chunk, self.key(piece), behind)

    def edit(self, *edits: Edit) -> Document:
        """The document after the edits, each made in what the one before it left."""
        document = self
        for edit in edits:
            document = document._edited(edit)
        return document

    def offset(self, pos: Pos) -> Pos:
        """A position that exists: past a line's or the document's end becomes that end."""
        if pos.line > self._root.eols:
            last = self._root.eols
            return Pos(last, len(self.line(last)))
        return Pos(pos.line, min(pos.col, len(self.line(pos.line))))

    @cached_property
    def _outliner(self) -> Outliner:
        return Outliner(self.dialect, facts_of(self._root, self.dialect) | self._given)

    def _way(self, line: int) -> _Way:
        """The way from the root to the chunk that holds a line. What is asked of a line is often followed by more of it."""
        kept = self._last_way
        if kept is None or not (
            line == kept.piece.line or kept.piece.line <= line < kept.piece.line + kept.piece.chunk.eols
        ):
            kept = self._last_way = self._found_way(line)
        return kept

    def _found_way(self, line: int) -> _Way:
        path: list[Step] = []
        node: Branch | Chunk = self._root
        first, before = 0, self._outliner.start
        while isinstance(node, Branch):
            top, start, last = before, first, len(node.children) - 1
            for number, (child, before) in enumerate(self._outliner.inner(node, top)):
                if line < first + child.eols or number == last:
                    path.append(Step(node, number, start, first, top, before))
                    node = child
                    break
                first += child.eols
        return _Way(path, Piece(first, node, before, self._outliner.outlined(node, before)))

    def _placed(self, node: Branch | Chunk, before: Before) -> Iterator[tuple[Chunk, Before]]:
        if isinstance(node, Chunk):
            yield node, before
            return
        for child, inner in self._outliner.inner(node, before):
            yield from self._placed(child, inner)

    def _place(self, line: int) -> Place:
        """The chunk that holds a line, found without reading any; whoever goes along the lines looks for it once."""
        for kept in self._last_places:
            if kept.line <= line < kept.line + kept.chunk.eols:
                return kept
        # Whoever goes along lines of which each points to another goes along two stretches in turn.
        found = self._found_place(line)
        self._last_places = (found, *self._last_places[:1])
        return found

    def _found_place(self, line: int) -> Place:
        node: Branch | Chunk = self._root
        first = index = 0
        while isinstance(node, Branch):
            last = len(node.children) - 1
            for number, child in enumerate(node.children):
                if line < first + child.eols or number == last:
                    node = child
                    break
                first += child.eols
                index += child.chunks if isinstance(child, Branch) else 1
        return Place(index, first, node)

    def _edited(self, edit: Edit) -> Document:
        start = self.offset(edit.start)
        end = start if edit.end == edit.start else self.offset(edit.end)
        if end < start:
            start, end = end, start
        left = self._place(start.line)
        right = left if end.line == start.line else self._place(end.line)
        root = replaced(self._root, left, right, start, end, edit.text, self._size)
        return Document(self.dialect, root, self._size, self._given)


def _chunks(node: Branch | Chunk) -> Iterator[Chunk]:
    if isinstance(node, Chunk):
        yield node
        return
    for child in node.children:
        yield from _chunks(child)


def _united(parts: Sequence[frozenset[S]]) -> frozenset[S]:
    first, *others = parts
    return first.union(*others) if others else first
