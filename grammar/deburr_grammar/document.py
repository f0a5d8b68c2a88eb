"""A program as an immutable tree of chunks: parse it whole, edit it in place. Never opens a file, never raises for a faulty program."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from functools import cached_property
from typing import NamedTuple, TypeVar

from deburr_grammar.chunk import SIZE, Branch, Chunk, grown
from deburr_grammar.dialect import Bracket, Dialect, Reading
from deburr_grammar.editing import Place, replaced
from deburr_grammar.fold import Fold, carried, through
from deburr_grammar.line import LineNode, Shape, shapes_of
from deburr_grammar.outline import Before, Outlined, Outliner, facts_of
from deburr_grammar.problem import Problem
from deburr_grammar.search import Partners, Step
from deburr_grammar.structure import Balance, StructureFault
from deburr_grammar.text import Edit, Pos, cut_points

S = TypeVar("S", bound=Hashable)


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
        runs = self.outlined.runs
        for number, (first, reading) in enumerate(runs):
            stop = runs[number + 1][0] if number + 1 < len(runs) else len(shapes)
            if first < stop:
                yield reading, first, shapes[first:stop]


class Document:
    """One version of a program. `edit` gives the next one and shares what it did not touch."""

    def __init__(self, dialect: Dialect, root: Branch, size: int = SIZE) -> None:
        self.dialect = dialect
        self._root = root
        self._size = size

    @classmethod
    def parse(cls, text: str, dialect: Dialect, size: int = SIZE) -> Document:
        """A document of the text, in chunks of about ``size`` characters. Nothing is read before it is asked for."""
        cuts = [0, *cut_points(text, size), len(text)]
        table = shapes_of(dialect)
        return cls(dialect, grown([Chunk(text[a:b], table) for a, b in zip(cuts, cuts[1:])]), size)

    @property
    def text(self) -> str:
        """The whole text, to the character as it was given."""
        return "".join(chunk.text for chunk in self.chunks())

    @property
    def line_count(self) -> int:
        """How many lines there are; a text that ends with a line end has an empty last one."""
        return self._root.eols + 1

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
        step = self._path(line)[-1]
        chunk = step.branch.children[step.number]
        assert isinstance(chunk, Chunk)
        return Piece(step.line, chunk, step.before, self._outliner.outlined(chunk, step.before))

    def pieces(self) -> Iterator[Piece]:
        """The chunks in order, each in its place."""
        first, before = 0, self._outliner.start
        for chunk in self.chunks():
            yield Piece(first, chunk, before, self._outliner.outlined(chunk, before))
            before = self._outliner.behind(chunk, before)
            first += chunk.eols

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
            for reading, first, shapes in piece.read():
                faulty = {shape for shape in set(shapes) if shape.facts(reading).problems}
                for index in (at for at, shape in enumerate(shapes, first) if shape in faulty) if faulty else ():
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

    @property
    def faults(self) -> tuple[StructureFault, ...]:
        """All faults of block structure, in order."""
        return self._outliner.reduction(self._root, self._outliner.start).all_faults()

    def partner(self, line: int, bracket: Bracket) -> tuple[int, Bracket] | None:
        """The other end of an opener or closer by depth alone; None where there is none in its region."""
        return Partners(self._outliner, self._path(line)).find(line, bracket)

    def state(self, fold: Fold[S], line: int) -> S:
        """The state of a fold before a line."""
        state = fold.start
        for step in self._path(line):
            before = step.top
            for child in step.branch.children[: step.number]:
                state = carried(fold, state, child, before, self._outliner)
                before = self._outliner.behind(child, before)
        piece = self.piece(line)
        return through(fold, state, piece.chunk, piece.outlined, line - piece.line)

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
        return Outliner(self.dialect, facts_of(self._root, self.dialect))

    def _path(self, line: int) -> list[Step]:
        """The way from the root to the chunk that holds a line."""
        path: list[Step] = []
        node: Branch | Chunk = self._root
        first, before = 0, self._outliner.start
        while isinstance(node, Branch):
            top, last = before, len(node.children) - 1
            for number, child in enumerate(node.children):
                if line < first + child.eols or number == last:
                    path.append(Step(node, number, first, top, before))
                    node = child
                    break
                before = self._outliner.behind(child, before)
                first += child.eols
        return path

    def _place(self, line: int) -> Place:
        """The chunk that holds a line, found without reading any."""
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
        start, end = self.offset(edit.start), self.offset(edit.end)
        if end < start:
            start, end = end, start
        left, right = self._place(start.line), self._place(end.line)
        root = replaced(self._root, left, right, start, end, edit.text, self._size)
        return Document(self.dialect, root, self._size)


def _chunks(node: Branch | Chunk) -> Iterator[Chunk]:
    if isinstance(node, Chunk):
        yield node
        return
    for child in node.children:
        yield from _chunks(child)
