"""The findings of one program, kept so that an edit costs what it touched: in blocks that remember by how many lines they have moved."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice, zip_longest
from operator import attrgetter, is_, itemgetter
from typing import NamedTuple

from deburr.finding import Finding, Place, Related
from deburr.steps import MANY, done, paced

_SIZE = 64
"""Findings of a block: so many are looked at for an edit among them, and all others a block at a time."""


class _Links(NamedTuple):
    """The lines to which those links of some findings point that have one place in their lists, in order, as they stood ``shift`` lines higher."""

    shift: int
    lines: tuple[int, ...]

    def behind(self, first: int, last: int, shift: int) -> _Links | None:
        """The same behind a change of lines that moved what is behind them; None if some of them stand where it was made, or only some move."""
        first, last = first - self.shift, last - self.shift
        if not self.lines or self.lines[-1] < first:
            return self
        if self.lines[0] > last:
            return self._replace(shift=self.shift + shift) if shift else self
        at = bisect_left(self.lines, first)
        return self if not shift and self.lines[at] > last else None


@dataclass(frozen=True)
class _Block:
    """Some findings in order, as they stood ``shift`` lines higher; now the first begins on a line, and none ends behind another one.

    What they point to in their own file moves by itself: in most blocks the first ``links`` point to one stretch, the second ones to another.
    """

    shift: int
    first: int
    last: int
    findings: tuple[Finding, ...]
    links: tuple[_Links, ...] = ()

    @cached_property
    def now(self) -> tuple[Finding, ...]:
        """The findings where they stand: the same ones as long as nothing moves them."""
        shifts = [links.shift for links in self.links]
        if any(shifts):
            return tuple(shifted(_linked(each, shifts), self.shift) for each in self.findings)
        return tuple(shifted(each, self.shift) for each in self.findings) if self.shift else self.findings

    def behind(self, first: int, last: int, shift: int) -> _Block | None:
        """The block behind a change of lines on which none of its findings begins; None if what these point to has to be looked at."""
        own = shift if self.first > last else 0
        if not self.links:
            return self.moved(own) if own else self
        links = tuple(each.behind(first, last, shift) for each in self.links)
        known = tuple(each for each in links if each is not None)
        if len(known) < len(links):
            return None
        return self if known == self.links and not own else self.moved(own, known)

    def moved(self, lines: int, links: tuple[_Links, ...] = ()) -> _Block:
        """The findings that many lines further down."""
        return _Block(self.shift + lines, self.first + lines, self.last + lines, self.findings, links)


class Held:
    """Findings of a program in order, each once. Immutable: an edit gives the next ones."""

    def __init__(self, blocks: tuple[_Block, ...] = ()) -> None:
        self._blocks = blocks

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
        blocks: list[_Block] = []
        for block in paced(_in_blocks(every), MANY // _SIZE):
            if block is None:
                yield
            else:
                blocks.append(block)
        return cls(tuple(blocks))

    @cached_property
    def _count(self) -> int:
        return sum(len(block.findings) for block in self._blocks)

    def __len__(self) -> int:
        """How many there are."""
        return self._count

    def __iter__(self) -> Iterator[Finding]:
        """All of them, in order."""
        return (finding for block in self._blocks for finding in block.now)

    def first(self, count: int) -> list[Finding]:
        """The first ones."""
        return list(islice(self, count))

    def on(self, first: int, last: int) -> list[Finding]:
        """Those that begin on some lines, both included."""
        near = (finding for block in self._blocks[self._near(first, last)] for finding in block.now)
        return [each for each in near if first <= each.place.line <= last]

    def changed(self, first: int, last: int, shift: int, each: Callable[[Finding], Finding | None]) -> Held:
        """The findings when the lines from one to another, both included, have changed and all behind them stand elsewhere.

        ``each`` says where a finding stands then, or that it is gone. It is asked only of those near these lines, and of those
        that are kept with one that points to them, or with some that point to both sides of them while these move apart.
        """
        near = self._near(first, last)
        above, below = self._blocks[: near.start], self._blocks[near.stop :]
        among = _asked(self._blocks[near], each)
        return Held((*_behind(above, first, last, shift, each), *among, *_behind(below, first, last, shift, each)))

    def without(self, lines: Sequence[int], rules: frozenset[str]) -> Held:
        """Those that some rules did not find on some lines (in order), or that stand elsewhere."""
        held = self
        chosen = frozenset(lines)

        def left(finding: Finding) -> Finding | None:
            return None if finding.place.line in chosen and finding.rule in rules else finding

        # Touched lines stand in a few groups: what is between them is not looked at.
        for first, last in _groups(lines):
            near, blocks = held._near(first, last), held._blocks
            held = Held((*blocks[: near.start], *_asked(blocks[near], left), *blocks[near.stop :]))
        return held

    def also(self, findings: Iterable[Finding]) -> Held:
        """The findings and some more."""
        new = set(findings)
        if not new:
            return self
        blocks = list(self._blocks)
        for line in sorted({each.place.line for each in new}):
            number = min(bisect_left(blocks, line, key=attrgetter("last")), len(blocks) - 1)
            there = {each for each in new if each.place.line == line}
            if number < 0:
                blocks += _in_blocks(sorted(there, key=_order))
            else:
                blocks[number : number + 1] = _in_blocks(sorted({*blocks[number].now, *there}, key=_order))
        return Held(tuple(blocks))

    def _near(self, first: int, last: int) -> slice:
        """The blocks in which a finding may begin on some lines, both included."""
        start = bisect_left(self._blocks, first, key=attrgetter("last"))
        return slice(start, bisect_right(self._blocks, last, lo=start, key=attrgetter("first")))


def shifted(finding: Finding, lines: int) -> Finding:
    """A finding that many lines further down."""
    file, line, col, end, end_col = finding.place
    rule, severity, message, _, related, fix = finding
    return Finding(rule, severity, message, Place(file, line + lines, col, end + lines, end_col), related, fix)


def _linked(finding: Finding, shifts: Sequence[int]) -> Finding:
    """A finding whose links point so many lines further down, each by its own number."""
    file = finding.place.file
    pairs = zip(finding.related, shifts)
    return finding._replace(
        related=tuple(_pointing(each, lines) if lines and each.place.file == file else each for each, lines in pairs)
    )


def _pointing(related: Related, lines: int) -> Related:
    (file, line, col, end, end_col), message, entered = related
    return Related(Place(file, line + lines, col, end + lines, end_col), message, entered)


def _behind(
    blocks: Iterable[_Block], first: int, last: int, shift: int, each: Callable[[Finding], Finding | None]
) -> Iterator[_Block]:
    """Blocks that are not near lines which have changed."""
    for block in blocks:
        found = block.behind(first, last, shift)
        if found is None:
            yield from _asked((block,), each)
        else:
            yield found


def _asked(blocks: Sequence[_Block], each: Callable[[Finding], Finding | None]) -> Iterable[_Block]:
    """Neighbouring blocks, each of their findings looked at: the same ones if nothing becomes of any."""
    before = [finding for block in blocks for finding in block.now]
    after = [found for one in before if (found := each(one)) is not None]
    if len(after) == len(before) and all(map(is_, after, before)):
        return blocks
    if any(block.links for block in blocks):
        after.sort(key=_order)
    return _in_blocks(after)


def _in_blocks(findings: Sequence[Finding]) -> Iterator[_Block]:
    """Findings in order, in blocks; those of one line are never in two."""
    start = 0
    while start < len(findings):
        stop = min(start + _SIZE, len(findings))
        while stop < len(findings) and findings[stop].place.line == findings[stop - 1].place.line:
            stop += 1
        part = tuple(findings[start:stop])
        yield _Block(0, part[0].place.line, max(each.place.end_line for each in part), part, tuple(_links(part)))
        start = stop


def _links(findings: Sequence[Finding]) -> Iterator[_Links]:
    """What findings point to, the first links of all of them, then the second ones and so on."""
    for pairs in zip_longest(
        *(((each.place.file, link.place) for link in each.related) for each in findings if each.related)
    ):
        places = (pair[1] for pair in pairs if pair is not None and pair[0] == pair[1].file)
        yield _Links(0, tuple(sorted({line for place in places for line in range(place.line, place.end_line + 1)})))


def _groups(lines: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Lines in order as stretches of neighbours."""
    if not lines:
        return
    start = last = lines[0]
    for line in lines[1:]:
        if line > last + 1:
            yield start, last
            start = line
        last = line
    yield start, last


def _order(finding: Finding) -> tuple[object, ...]:
    return (*finding.order, finding.related)
