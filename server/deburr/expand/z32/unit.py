"""A file of Z32 code as it runs: its lines, block numbers, sections, and the loops that jumps back make. Runs nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Generator, Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.arithmetic.z32 import NEAR_INTEGER, constant
from deburr.includes import z32 as stores
from deburr.steps import done, paced
from deburr_grammar.dialects.z32.forms import number_of, section_number

if TYPE_CHECKING:
    from collections.abc import Mapping

    from deburr_grammar.document import Document

Op = Callable[[], int]
"""A compiled line: it runs and gives the next row, or one of the signs of `flow.py`."""
ACTIVE = frozenset(("word", "g_word", "axis_alias", "stray", "advanced", "mixed"))
"""Kinds of parts that make a line do something."""


class Program(NamedTuple):
    """A program: the lines of a file from ``first`` to before ``last``."""

    unit: Unit
    first: int
    last: int


class Unit:
    """One file. ``code`` holds the compiled lines, each made when it first runs."""

    def __init__(self, file: str, document: Document) -> None:
        self.file = file
        self.document = document
        self.code: list[Op | None] = [None] * document.line_count
        self.ran = bytearray(document.line_count)
        """Which lines have run."""
        self.ends: set[int] = set()
        """Lines at which a jump has returned or is to return."""

    @property
    def whole(self) -> Program:
        """All of the file."""
        return Program(self, 0, len(self.code))

    def section(self, number: int) -> list[Program]:
        """The sections of that number, each to the start of the next one."""
        bounds = [*self.sections, len(self.code)]
        rows = [at for at, row in enumerate(self.sections) if section_number(self.document.line(row)) == number]
        return [Program(self, bounds[at], bounds[at + 1]) for at in rows]

    def rows_of(self, program: Program, near: int, value: float, computed: bool) -> Sequence[int]:
        """The lines of a program with a block number. Sections have numbers of their own: only those of that of line ``near`` count, if it has any."""
        rows = [row for row in self._numbered(value, computed) if program.first <= row < program.last]
        own = self._section_at(near)
        return [row for row in rows if self._section_at(row) == own] or rows if len(rows) > 1 else rows

    def _numbered(self, value: float, computed: bool) -> Sequence[int]:
        exact = self.labels.get(value)
        if exact is not None or not computed:
            return exact or ()
        at = bisect_left(self.numbers, value - NEAR_INTEGER)
        near = self.numbers[at] if at < len(self.numbers) else None
        return self.labels[near] if near is not None and near <= value + NEAR_INTEGER else ()

    def _section_at(self, row: int) -> int:
        return bisect_right(self.sections, row)

    def placing(self) -> Iterator[None]:
        """Find its block numbers and the loops that jumps back make, in steps."""
        self.labels = yield from self._labelling()
        self.jumps_back = yield from self._jumping_back()
        yield

    @cached_property
    def labels(self) -> Mapping[float, Sequence[int]]:
        """The lines by their block numbers."""
        return done(self._labelling())

    def _labelling(self) -> Generator[None, None, Mapping[float, Sequence[int]]]:
        found: dict[float, list[int]] = {}
        for row in paced(self.rows_with("nword")):
            if row is None:
                yield
            elif (value := number_of(self.document.line(row))) is not None:
                found.setdefault(value, []).append(row)
        return found

    @cached_property
    def numbers(self) -> Sequence[float]:
        """All block numbers in order."""
        return sorted(self.labels)

    @cached_property
    def sections(self) -> Sequence[int]:
        """The lines that start a section."""
        return list(self.rows_with("section"))

    @cached_property
    def first_line(self) -> int:
        """The first line of the program that is not blank: behind the `%` if there is one."""
        nodes = ((row, self.document.node(row)) for row in range(len(self.code)))
        lines = (
            row
            for row, node in nodes
            if node.reading.start is not None and "PERCENT" not in node.kinds and node.text.strip()
        )
        return next(lines, 0)

    @cached_property
    def first_block(self) -> int:
        """The first line that does anything; behind the last line if none does."""
        return next(self.rows_with(*ACTIVE), len(self.code))

    @cached_property
    def jumps_back(self) -> Mapping[int, int]:
        """The lines to which jumps go back, with the last line that does so. Where a jump is calculated it makes no loop."""
        return done(self._jumping_back())

    def _jumping_back(self) -> Generator[None, None, Mapping[int, int]]:
        found: dict[int, int] = {}
        for row in paced(self.rows_with("jump")):
            if row is None:
                yield
                continue
            node = self.document.node(row)
            for jump in node.find("jump"):
                value = constant(node.text, jump.children[1])
                targets = self.rows_of(self.whole, row, value, True) if isinstance(value, float) else ()
                if len(targets) == 1 and targets[0] <= row and jump.node("range_end") is None:
                    found[targets[0]] = max(row, found.get(targets[0], 0))
        return found

    @cached_property
    def loops(self) -> Mapping[int, int]:
        """The first lines of loops with their last ones. Of two that cross, the one that starts before takes in all of the other."""
        found: dict[int, int] = {}
        inner: list[tuple[int, int]] = []
        for first in sorted(self.jumps_back, reverse=True):
            last = self.jumps_back[first]
            while inner and inner[-1][0] <= last:
                last = max(last, inner.pop()[1])
            inner.append((first, last))
            found[first] = last
        return found

    @cached_property
    def turns(self) -> frozenset[int]:
        """The lines at which a loop starts or has been left."""
        return frozenset((*self.loops, *(last + 1 for last in self.loops.values())))

    def is_main(self, settings: Mapping[str, Any]) -> bool:
        """Whether it is certain that the operator starts this program: its main part ends in M2 or M30, and not at a jump target."""
        if stores.is_stored(self.file, settings):
            return False
        last = self.sections[0] if self.sections else len(self.code)
        row = self.last_block(Program(self, 0, last))
        return "M_END" in self.document.node(row).kinds and not self._is_target(row)

    def last_block(self, program: Program) -> int:
        """The last line of a program that does anything; its first line if none does."""
        rows = range(program.last - 1, program.first - 1, -1)
        found = (row for row in rows if not ACTIVE.isdisjoint(self.document.node(row).kinds))
        return next(found, program.first)

    def _is_target(self, row: int) -> bool:
        value = number_of(self.document.line(row))
        targets = [constant(text, part) for text, part in self._targets()]
        return value is not None and any(target is None or target == value for target in targets)

    def _targets(self) -> Iterator[tuple[str, Any]]:
        for row in self.rows_with("jump"):
            node = self.document.node(row)
            yield from ((node.text, jump.children[1]) for jump in node.find("jump"))

    def rows_with(self, *kinds: str) -> Iterator[int]:
        """The lines that hold one of some kinds of parts."""
        for piece in self.document.pieces():
            for reading, first, shapes in piece.read():
                held = {shape for shape in set(shapes) if not shape.facts(reading).kinds.isdisjoint(kinds)}
                for index in (at for at, shape in enumerate(shapes, first) if shape in held) if held else ():
                    yield piece.line + index
