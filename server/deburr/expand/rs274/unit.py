"""A file of RS274 code as it runs: its lines, which O-words belong together, where its subprograms start. Runs nothing."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Generator, Iterator
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.expand.rs274.copying import Stretches
from deburr.finding import Severity
from deburr.steps import paced
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.rs274.outline import label_of

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.finding import Finding
    from deburr_grammar.document import Document, Piece

_OF_PROGRAMS = ("program-end-missing", "percent")
"""What is wrong with a program that is none with a file that is called."""
_LOOPS = ("while", "do")
ELSEWHERE, END, COPIED, PAUSED = -1, -2, -3, -4
"""What a line gives instead of the next row: the run goes on in another file or subprogram, is over, or a whole stretch is to be copied; others have their turn first."""
Op = Callable[[], int]
"""A compiled line: it runs and gives the next row, or one of the signs above."""


_CALLED = "rs274 called"


class Block:
    """A flow block: the rows of its O-words. ``close`` is behind the last line while it is not known."""

    __slots__ = ("breaks", "close", "crossed", "kind", "label", "middles", "open")

    def __init__(self, bracket: Bracket, row: int, close: int) -> None:
        self.kind = bracket.kind
        self.label = bracket.label
        self.open = row
        self.close = close
        self.middles: list[int] = []
        """Rows of `elseif` and `else`."""
        self.breaks: list[int] = []
        """Rows of its `break`s, which the interpreter also meets where it passes over them."""
        self.crossed = False
        """Whether it overlaps another block."""

    def takes(self, kinds: tuple[str, ...], label: str | None) -> bool:
        """Whether a bracket of these kinds and this label can belong to it."""
        return self.kind in kinds and (label is None or self.label is None or self.label == label)


class Unit:
    """One file. ``code`` holds the compiled lines, each made when it first runs."""

    def __init__(self, file: str, document: Document) -> None:
        self.file = file
        self.document = document
        rows = document.rows
        self.code: list[Op | None] = [None] * rows
        self.met = bytearray(rows)
        """Which lines have run: one that shares what is compiled is only kept when it runs again."""
        self.blocks: dict[int, Block] = {}
        """The block of each row with a flow command: the one that it opens, closes, branches or leaves."""
        self.subs: dict[str, list[int]] = {}
        """The rows at which subprograms start, by label."""
        self.ends: dict[int, int] = {}
        """The row of each subprogram's end."""
        self.returns: dict[int, list[int]] = {}
        """The rows of `return` and `endsub` of a subprogram that bear its own label."""
        self.passed: set[int] = set()
        """Rows of definitions that the run has come by or called."""
        self.faulty: frozenset[int] = frozenset()
        """Rows at which a run stops that only heeds what it reaches, and those whose lines it has to judge."""
        self.seen: list[int] = []
        """Rows of which such a run may mind something even where it passes over them, in order."""

    @cached_property
    def stretches(self) -> Stretches:
        """Its lines that can be copied as they are."""
        return Stretches(self)

    @classmethod
    def making(cls, file: str, document: Document) -> Generator[None, None, Unit]:
        """A file as it runs, read in steps."""
        unit = cls(file, document)
        yield from unit._read()
        return unit

    def sub_behind(self, label: str, row: int) -> int | None:
        """The first subprogram of a label behind a row."""
        rows = self.subs.get(label, [])
        at = bisect_right(rows, row)
        return rows[at] if at < len(rows) else None

    def numbered_behind(self, label: str, row: int) -> int | None:
        """The first bare O-word of a label behind a row."""
        rows = self._numbered.get(label, [])
        at = bisect_right(rows, row)
        return rows[at] if at < len(rows) else None

    def bare_in(self, row: int) -> int | None:
        """The first bare O-word in the subprogram that starts at a row."""
        at = bisect_right(self._bare, row)
        return self._bare[at] if at < len(self._bare) and self._bare[at] < self.ends[row] else None

    def _read(self) -> Iterator[None]:
        last = len(self.code)
        around: list[Block] = []
        outside: list[tuple[tuple[int, str | None] | None, list[Block]]] = []
        sub: tuple[int, str | None] | None = None
        for each in paced(self.document.brackets()):
            if each is None:
                yield
                continue
            row, bracket = each
            match bracket.role:
                case Role.OPEN:
                    self.blocks[row] = Block(bracket, row, last)
                    around.append(self.blocks[row])
                case Role.CLOSE:
                    self._closed(around, bracket, row)
                case Role.MIDDLE:
                    self._middle(around, bracket, row)
                case Role.REGION:
                    outside.append((sub, around))
                    sub, around = (row, bracket.label), []
                    self._started(row, bracket.label, last)
                case Role.END_REGION if sub is not None:
                    self.ends[sub[0]] = row
            if sub is not None and bracket.word in ("return", "endsub") and bracket.label == sub[1] is not None:
                self.returns[sub[0]].append(row)
            if bracket.role is Role.END_REGION and outside:
                sub, around = outside.pop()

    def _started(self, row: int, label: str | None, last: int) -> None:
        self.ends[row], self.returns[row] = last, []
        if label is not None:
            self.subs.setdefault(label, []).append(row)

    def _closed(self, around: list[Block], bracket: Bracket, row: int) -> None:
        at = next((at for at in reversed(range(len(around))) if around[at].takes((bracket.kind,), bracket.label)), None)
        if at is None:
            return
        block = self.blocks[row] = around[at]
        block.close = row
        if at + 1 < len(around):
            for crossed in around[at:]:
                crossed.crossed = True
        del around[at]

    def _middle(self, around: list[Block], bracket: Bracket, row: int) -> None:
        kinds = _LOOPS if bracket.kind == "loop" else (bracket.kind,)
        block = next((block for block in reversed(around) if block.takes(kinds, bracket.label)), None)
        if block is None:
            return
        self.blocks[row] = block
        if bracket.word == "break":
            block.breaks.append(row)
        elif bracket.kind == "if":
            block.middles.append(row)

    @cached_property
    def _numbered(self) -> dict[str, list[int]]:
        """Rows of the bare O-words at which programs start that M98 calls."""
        found: dict[str, list[int]] = {}
        for row in self._bare:
            node = self.document.node(row)
            for o_line in node.find("o_line"):
                label = o_line.node("label")
                if label is not None and (name := label_of(node.text, label)) is not None:
                    found.setdefault(name, []).append(row)
        return found

    @property
    def called(self) -> frozenset[str | None]:
        """The labels of all calls; None for those that only the run knows."""
        return self.document.gathered(_CALLED, _called)

    def calling(self) -> Iterator[None]:
        """Find these labels, in steps."""
        yield from self.document.gathering(_CALLED, _called)

    @cached_property
    def _bare(self) -> tuple[int, ...]:
        """Rows of O-words without a command, in order."""
        flow = {row for row, _ in self.document.brackets()}
        held = (row for row in self._with("o_line") if row not in flow)
        return tuple(row for row in held if "CALL" not in self.document.node(row).kinds)

    def _with(self, kind: str) -> Iterator[int]:
        """The rows of lines with a node of a kind."""
        for piece in self.document.pieces():
            for reading, first, shapes in piece.read():
                held = {shape for shape in set(shapes) if kind in shape.facts(reading).kinds}
                if held:
                    yield from (piece.line + at for at, shape in enumerate(shapes, first) if shape in held)

    @property
    def does_something(self) -> bool:
        """Whether anything stands outside subprograms: else the file is no program of its own."""
        acting = {*self._with("word"), *self._with("setting"), *self._with("o_line")}
        return any(not any(start <= row <= end for start, end in self.ends.items()) for row in acting)

    @cached_property
    def signs(self) -> tuple[int, ...]:
        """The rows of the first two percent signs."""
        rows = (
            piece.line + at
            for piece in self.document.pieces()
            for at, shape in enumerate(piece.chunk.shapes)
            if shape.text.strip() == "%"
        )
        return tuple(islice(rows, 2))

    @cached_property
    def is_framed(self) -> bool:
        """Whether the first line that is not blank is a percent sign."""
        return bool(self.signs) and not any(self.document.line(row).strip() for row in range(self.signs[0]))

    def errors(self, job: Job) -> dict[int, Finding]:
        """What a check of the file calls wrong, by row: a file that is called has not been checked before."""
        if self._errors is None:
            findings = Analysis(self.document, job.ruleset, self.file, job.host).findings()
            self._errors = {
                finding.place.line: finding
                for finding in reversed(findings)
                if finding.severity is Severity.ERROR
                and finding.place.file == self.file
                and finding.rule.partition(".")[2] not in _OF_PROGRAMS
            }
        return self._errors

    _errors: dict[int, Finding] | None = None


def _called(piece: Piece) -> frozenset[str | None]:
    nodes = (piece.node(at) for at, _, _ in piece.where(lambda reading, shape: "CALL" in shape.facts(reading).kinds))
    return frozenset(label_of(node.text, label) for node in nodes for label in node.find("label"))
