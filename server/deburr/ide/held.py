"""The findings of one program, kept so that an edit costs what it touched: in blocks that remember by how many lines they have moved."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from heapq import merge
from itertools import islice
from operator import attrgetter, itemgetter

from deburr.finding import Finding, Place
from deburr.steps import done, paced

_SIZE = 64
"""Findings of a block: so many are looked at for an edit among them, and all others a block at a time."""


@dataclass(frozen=True)
class _Block:
    """Some findings in order, as they stood ``shift`` lines higher; now the first begins on a line, and none ends behind another one."""

    shift: int
    first: int
    last: int
    findings: tuple[Finding, ...]

    @cached_property
    def now(self) -> tuple[Finding, ...]:
        """The findings where they stand: the same ones as long as nothing moves them."""
        return tuple(shifted(each, self.shift) for each in self.findings) if self.shift else self.findings

    def moved(self, lines: int) -> _Block:
        """The findings that many lines further down."""
        return _Block(self.shift + lines, self.first + lines, self.last + lines, self.findings)


class Held:
    """Findings of a program in order, each once. Immutable: an edit gives the next ones.

    Findings that point at other places are kept apart, for these places move as well.
    """

    def __init__(self, blocks: tuple[_Block, ...] = (), linked: tuple[Finding, ...] = ()) -> None:
        self._blocks = blocks
        self._linked = linked

    @classmethod
    def of(cls, findings: Iterable[Finding]) -> Held:
        """Findings in any order."""
        return done(cls.holding(findings))

    @classmethod
    def holding(cls, findings: Iterable[Finding]) -> Generator[None, None, Held]:
        """The same, made in steps; but for those that are nearly in order already the sorting is one."""
        seen: dict[Finding, tuple[object, ...]] = {}
        for each in paced(findings):
            if each is None:
                yield
            elif each not in seen:
                seen[each] = _order(each)
        every = [each for each, _ in sorted(seen.items(), key=itemgetter(1))]
        yield
        plain: list[Finding] = []
        linked: list[Finding] = []
        for each in paced(every):
            if each is None:
                yield
            else:
                (linked if each.related else plain).append(each)
        blocks: list[_Block] = []
        for block in paced(_in_blocks(plain)):
            if block is None:
                yield
            else:
                blocks.append(block)
        return cls(tuple(blocks), tuple(linked))

    @cached_property
    def _count(self) -> int:
        return sum(len(block.findings) for block in self._blocks) + len(self._linked)

    def __len__(self) -> int:
        """How many there are."""
        return self._count

    def __iter__(self) -> Iterator[Finding]:
        """All of them, in order."""
        plain = (finding for block in self._blocks for finding in block.now)
        return merge(plain, self._linked, key=_order) if self._linked else plain

    def first(self, count: int) -> list[Finding]:
        """The first ones."""
        return list(islice(self, count))

    def on(self, first: int, last: int) -> list[Finding]:
        """Those that begin on some lines, both included."""
        start = bisect_left(self._blocks, first, key=attrgetter("last"))
        stop = bisect_right(self._blocks, last, lo=start, key=attrgetter("first"))
        near = (finding for block in self._blocks[start:stop] for finding in block.now)
        return [each for each in merge(near, self._linked, key=_order) if first <= each.place.line <= last]

    def changed(self, first: int, last: int, shift: int, each: Callable[[Finding], Finding | None]) -> Held:
        """The findings when the lines from one to another, both included, have changed and all behind them stand elsewhere.

        ``each`` says where a finding stands then, or that it is gone; of plain ones it is asked only of those near these lines.
        """
        start = bisect_left(self._blocks, first, key=attrgetter("last"))
        stop = bisect_right(self._blocks, last, lo=start, key=attrgetter("first"))
        near = [found for block in self._blocks[start:stop] for one in block.now if (found := each(one)) is not None]
        behind = self._blocks[stop:]
        if shift:
            behind = tuple(block.moved(shift) for block in behind)
        blocks = self._blocks[:start] + _blocks(near) + behind
        linked = (found for one in self._linked if (found := each(one)) is not None)
        return Held(blocks, tuple(sorted(linked, key=_order)))

    def without(self, lines: Sequence[int], rules: frozenset[str]) -> Held:
        """Those that some rules did not find on some lines (in order), or that stand elsewhere."""
        if not lines:
            return self
        held = self
        chosen = frozenset(lines)

        def left(finding: Finding) -> Finding | None:
            return None if finding.place.line in chosen and finding.rule in rules else finding

        # Touched lines stand in a few groups: what is between them is not looked at.
        for first, last in _groups(lines):
            held = held.changed(first, last, 0, left)
        return held

    def also(self, findings: Iterable[Finding]) -> Held:
        """The findings and some more."""
        new = set(findings)
        if not new:
            return self
        linked = {each for each in new if each.related}
        blocks = list(self._blocks)
        for line in sorted({each.place.line for each in new - linked}):
            number = min(bisect_left(blocks, line, key=attrgetter("last")), len(blocks) - 1)
            there = {each for each in new - linked if each.place.line == line}
            if number < 0:
                blocks += _blocks(sorted(there, key=_order))
            else:
                blocks[number : number + 1] = _blocks(sorted({*blocks[number].now, *there}, key=_order))
        return Held(tuple(blocks), tuple(sorted({*self._linked, *linked}, key=_order)) if linked else self._linked)


def shifted(finding: Finding, lines: int) -> Finding:
    """A finding that many lines further down."""
    file, line, col, end, end_col = finding.place
    rule, severity, message, _, related, fix = finding
    return Finding(rule, severity, message, Place(file, line + lines, col, end + lines, end_col), related, fix)


def _blocks(findings: Sequence[Finding]) -> tuple[_Block, ...]:
    """Findings in order, in blocks; those of one line are never in two."""
    return tuple(_in_blocks(findings))


def _in_blocks(findings: Sequence[Finding]) -> Iterator[_Block]:
    start = 0
    while start < len(findings):
        stop = min(start + _SIZE, len(findings))
        while stop < len(findings) and findings[stop].place.line == findings[stop - 1].place.line:
            stop += 1
        part = tuple(findings[start:stop])
        yield _Block(0, part[0].place.line, max(each.place.end_line for each in part), part)
        start = stop


def _groups(lines: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Lines in order as stretches of neighbours."""
    start = last = lines[0]
    for line in lines[1:]:
        if line > last + 1:
            yield start, last
            start = line
        last = line
    yield start, last


def _order(finding: Finding) -> tuple[object, ...]:
    return (*finding.order, finding.related)
