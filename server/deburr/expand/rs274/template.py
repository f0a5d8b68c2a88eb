"""Lines that differ in nothing but numbers: compiled once, with the numbers as arguments. Knows no flow.

A line's numbers stand in the same places as its shape's. Those of parameters and in names decide what is
compiled, all others are put where it reads them before a line runs.
"""

from __future__ import annotations

from itertools import accumulate
from typing import TYPE_CHECKING

from deburr.arithmetic.rs274 import number
from deburr.expand.rs274.lines import ACTS, Line
from deburr.expand.rs274.shapes import fixed
from deburr.expand.rs274.source import Source
from deburr.expand.rs274.values import Numbers
from deburr.expand.rs274.words import COMMENT, NUMBERS, starts
from deburr_grammar.dialects.rs274.outline import PROGRAM
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from deburr.expand.rs274.compiling import Compiler
    from deburr.expand.rs274.lines import Piece
    from deburr.expand.rs274.run import Run
    from deburr.expand.rs274.unit import Op, Unit
    from deburr_grammar.line import Shape

_MOST = 50_000


_Cut = tuple[int, int, int, int]
"""From where to where: columns of the shape without its numbers, each with how many of them stand before it. An end below 0 is that of the line."""


class Template:
    """What lines of one shape, and of the same parameters, are compiled to."""

    def __init__(self, run: Run, compiler: Compiler, shape: Shape, source: Source) -> None:
        self._compiler = compiler
        self._source = source
        numbers = Numbers(starts(shape.text))
        node = LineNode(shape.text, PROGRAM, shape)
        self._line = line = Line(run.state, source, node, numbers)
        self._pieces = _cuts(shape.text, line.stretches())
        self._numbers = numbers
        # Blanks in a number are part of the shape.
        self._number: Callable[[str], float] = (
            number if any(" " in said or "\t" in said for said in NUMBERS.findall(shape.text)) else float
        )
        self._read = compiler.read(line)

    def op(self, unit: Unit, row: int, text: str, found: Sequence[str]) -> Op:
        """One of the lines; ``found`` are all its numbers."""
        source, read, values, behind = self._source, self._read, self._numbers.values, row + 1
        as_number = self._number
        own = [as_number(found[at]) for at in self._numbers.used]
        file = unit.file
        pieces = self._cut(text, found)
        write = self._compiler.write(unit, row, self._line, pieces) if pieces or self._line.words else None

        def executed() -> int:
            source.file, source.row, source.text = file, row, text
            values[:] = own
            found = read()
            if write is not None:
                write(found)
            return behind

        return executed

    def _cut(self, text: str, found: Sequence[str]) -> list[Piece]:
        lengths = [0, *accumulate(map(len, found))]
        pieces: list[Piece] = []
        for piece in self._pieces:
            if isinstance(piece, int):
                pieces.append(piece)
            else:
                start, before, end, inside = piece
                pieces.append(text[start + lengths[before] : end + lengths[inside] if end >= 0 else None])
        return pieces


class Templates:
    """The templates of one run."""

    def __init__(self, run: Run, compiler: Compiler) -> None:
        self._run = run
        self._compiler = compiler
        self._known: dict[tuple[Shape, tuple[str, ...]], Template] = {}

    def op(self, unit: Unit, row: int, text: str, shape: Shape) -> Op:
        """A line whose shape is shared."""
        found = NUMBERS.findall(text)
        key = shape, tuple(found[at] for at in fixed(shape) or ())
        template = self._known.get(key)
        if template is None:
            if len(self._known) >= _MOST:
                self._known.clear()
            source = Source(unit.file, row, text, shape)
            template = self._known[key] = Template(self._run, self._compiler, shape, source)
        return template.op(unit, row, text, found)


def _cuts(sample: str, stretches: list[Span | int]) -> list[_Cut | int]:
    """The pieces of a flat line by the sample of its shape; what touches is one piece, and comments stand behind all else."""
    comment = COMMENT.search(sample)
    behind = len(sample) if comment is None else comment.start()
    spans: list[Span | int] = []
    for piece in stretches:
        if isinstance(piece, int):
            spans += [piece] if piece != ACTS else []
            continue
        start, end = piece.start, min(piece.end, behind)
        if start < end and spans and isinstance(last := spans[-1], Span) and last.end == start:
            spans[-1] = Span(last.start, end)
        elif start < end:
            spans.append(Span(start, end))
    found: list[_Cut | int] = [
        piece if isinstance(piece, int) else (*_place(sample, piece.start), *_place(sample, piece.end))
        for piece in spans
    ]
    return found if comment is None else [*found, (*_place(sample, behind), -1, 0)]


def _place(sample: str, column: int) -> tuple[int, int]:
    before = [match[0] for match in NUMBERS.finditer(sample) if match.end() <= column]
    return column - sum(map(len, before)), len(before)
