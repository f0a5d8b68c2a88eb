"""A file of RS274 code as it runs: its lines, which O-words belong together, where its subprograms start. Runs nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr_grammar.dialect import Bracket, Role

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.finding import Finding
    from deburr_grammar.document import Document

_OF_PROGRAMS = ("program-end-missing", "percent")
"""What is wrong with a program that is none with a file that is called."""
Op = Callable[[], int]
"""A compiled line: it runs and gives the next row, or one of the signs of `run.py`."""


class Block:
    """A flow block: the rows of its O-words. ``close`` is behind the last line while it is not known."""

    __slots__ = ("close", "inside", "kind", "label", "middles", "open")

    def __init__(self, bracket: Bracket, row: int, close: int, inside: Block | None) -> None:
        self.kind = bracket.kind
        self.label = bracket.label
        self.open = row
        self.close = close
        self.inside = inside
        self.middles: list[int] = []

    def outward(self) -> Iterator[Block]:
        """This block and those around it, innermost first."""
        block: Block | None = self
        while block is not None:
            yield block
            block = block.inside


class Unit:
    """One file. ``code`` holds the compiled lines, each made when it first runs."""

    def __init__(self, file: str, document: Document) -> None:
        self.file = file
        self.document = document
        self.code: list[Op | None] = [None] * document.line_count
        self.blocks: dict[int, Block] = {}
        """The block of each row that holds a flow command: the one that it opens, closes or stands in."""
        self.subs: dict[str, int] = {}
        self.ends: dict[int, int] = {}
        """The row of each subprogram's end."""
        self.returns: list[int] = []
        """Rows of `return` and `endsub`, whose values the control calculates even where it skips them."""
        self._read()

    def _read(self) -> None:
        last = len(self.code)
        inner: Block | None = None
        sub: int | None = None
        for row, bracket in self.document.brackets():
            match bracket.role:
                case Role.OPEN:
                    inner = self.blocks[row] = Block(bracket, row, last, inner)
                case Role.CLOSE if inner is not None:
                    self.blocks[row] = inner
                    inner.close = row
                    inner = inner.inside
                case Role.MIDDLE if inner is not None:
                    self.blocks[row] = inner
                    if bracket.kind == inner.kind:
                        inner.middles.append(row)
                case Role.REGION:
                    sub, inner = row, None
                    self.ends[row] = last
                    if bracket.label is not None:
                        self.subs.setdefault(bracket.label, row)
                case Role.END_REGION:
                    if sub is not None:
                        self.ends[sub] = row
                    sub, inner = None, None
            if bracket.word in ("return", "endsub"):
                self.returns.append(row)

    @cached_property
    def numbered(self) -> dict[str, int]:
        """Rows of the bare O-words at which programs start that M98 calls."""
        from deburr_grammar.dialects.rs274.outline import label_of

        found: dict[str, int] = {}
        for row in self._bare():
            node = self.document.node(row)
            for o_line in node.find("o_line"):
                label = o_line.node("label")
                if label is not None and (name := label_of(node.text, label)) is not None:
                    found.setdefault(name, row)
        return found

    def _bare(self) -> Iterator[int]:
        flow = {row for row, _ in self.document.brackets()}
        for piece in self.document.pieces():
            for reading, first, shapes in piece.read():
                held = {shape for shape in set(shapes) if "o_line" in shape.facts(reading).kinds}
                for index in (at for at, shape in enumerate(shapes, first) if shape in held) if held else ():
                    row = piece.line + index
                    if row not in flow and "CALL" not in piece.node(index).kinds:
                        yield row

    @cached_property
    def closing_sign(self) -> int | None:
        """The row of the second percent sign."""
        rows = (row for row in range(len(self.code)) if self.document.line(row).strip() == "%")
        return next(islice(rows, 1, None), None)

    def skipped_returns(self, first: int, stop: int) -> list[int]:
        """The returns between two rows, both excluded."""
        if not self.returns:
            return []
        return self.returns[bisect_right(self.returns, first) : bisect_left(self.returns, stop)]

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
