"""Where a program can go from a line: jumps, returns and ends, from the text alone (spec/z32.md §6.3). Never follows a call: it comes back."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Generator, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from deburr.analysis import Analysis
from deburr.rules.z32._program import Jump, jumps, labels, numbers_of, ready_jumps, within
from deburr.steps import done, kept, paced
from deburr_grammar.line import LineNode

_STEPS = 1000
"""Stretches that are followed from one line; a program that is more entangled decides nothing."""


@dataclass(frozen=True)
class Flow:
    """The lines from which it does not simply go on to the next one, in order, and the lines to which it may go from each."""

    turns: tuple[int, ...]
    ways: Mapping[int, frozenset[int]]
    last: int

    def reaches(self, start: int, wanted: int) -> bool | None:
        """Whether a run from one line can come to another; None if that takes too long to find out. The line behind the last is the end."""
        waiting, seen = [start], {start}
        while waiting:
            first = waiting.pop()
            at = bisect_left(self.turns, first)
            turn = self.turns[at] if at < len(self.turns) else self.last
            if first <= wanted <= turn:
                return True
            new = self.ways.get(turn, frozenset()) - seen
            seen |= new
            waiting += new
            if len(seen) > _STEPS:
                return None
        return False


def ready(analysis: Analysis) -> Iterator[None]:
    """Find what the flow stands on, in steps."""
    yield from ready_jumps(analysis)
    yield from _reading(analysis)


def flowing(analysis: Analysis, first: int, last: int, *, returns: bool) -> Generator[None, None, Flow | None]:
    """The flow in the lines from ``first`` to before ``last``, found in steps; None where a jump is calculated or cannot be read.

    ``returns``: the last block of a range always returns; else it is also taken to go on, as it
    does where no range is under way.
    """
    every = jumps(analysis)
    found = every[bisect_left(every, first, key=_line) : bisect_left(every, last, key=_line)]
    unknown = any(jump.target is None or (jump.end_span is not None and jump.end is None) for jump in found)
    if unknown or within(_unread(analysis), first, last):
        return None
    ways: dict[int, set[int]] = {}
    for jump in paced(found):
        if jump is None:
            yield
            continue
        ways.setdefault(jump.line, set()).update(_targets(analysis, jump))
        if jump.end_span is not None or not jump.certain:
            ways[jump.line].add(jump.line + 1)
    yield
    stops = [at for at in within(numbers_of(analysis, "M_END", "G26"), first, last) if ends(analysis.document.node(at))]
    for end, behind in _ends(analysis, found).items():
        on = ways.setdefault(end, {end + 1})
        if returns:
            on.discard(end + 1)
        on |= behind
    ways |= {at: set[int]() for at in stops}
    inside = {at: frozenset(to for to in tos if first <= to <= last) for at, tos in ways.items()}
    return Flow(tuple(sorted(inside)), inside, last)


def open_ranges(analysis: Analysis) -> Sequence[Jump]:
    """The jumps with a return that never comes: no way leads from their first block to their last."""
    return done(_opening(analysis))


def ready_ranges(analysis: Analysis) -> Iterator[None]:
    """Find these jumps, in steps."""
    yield from ready(analysis)
    yield from _opening(analysis)


def _opening(analysis: Analysis) -> Generator[None, None, Sequence[Jump]]:
    return kept(analysis.memo, "z32 open ranges", lambda: _all_open(analysis))


def _all_open(analysis: Analysis) -> Generator[None, None, Sequence[Jump]]:
    ranges = [jump for jump in jumps(analysis) if jump.target is not None and jump.end is not None]
    if not ranges:
        return []
    ways = yield from flowing(analysis, 0, analysis.document.line_count, returns=False)
    found: list[Jump] = []
    for jump in ranges if ways is not None else ():
        if ways is not None and _is_open(analysis, ways, jump):
            found.append(jump)
        yield
    return found


def _is_open(analysis: Analysis, ways: Flow, jump: Jump) -> bool:
    assert jump.target is not None and jump.end is not None
    starts, last = labels(analysis, jump.target), labels(analysis, jump.end)
    return len(starts) == len(last) == 1 and ways.reaches(starts[0].line, last[0].line) is False


def ends(node: LineNode) -> bool:
    """Whether a line certainly ends the program it stands in: M2, M30 or G26 in a block that is no optional one."""
    return not node.kinds.isdisjoint(("M_END", "G26")) and node.kinds.isdisjoint(("DELETE", "advanced"))


def _unread(analysis: Analysis) -> Sequence[int]:
    """The lines with a fault in which there may be a jump."""
    return done(_reading(analysis))


def _reading(analysis: Analysis) -> Generator[None, None, Sequence[int]]:
    return kept(analysis.memo, "z32 unread", lambda: _all_unread(analysis))


def _all_unread(analysis: Analysis) -> Generator[None, None, Sequence[int]]:
    found: list[int] = []
    for piece in analysis.document.pieces():
        for index, _, _ in piece.where(lambda reading, shape: shape.facts(reading).problems):
            if piece.node(index).problems and "!" in piece.chunk.line(index):
                found.append(piece.line + index)
        yield
    return found


def _line(jump: Jump) -> int:
    return jump.line


def _targets(analysis: Analysis, jump: Jump) -> Iterable[int]:
    return (label.line for label in (labels(analysis, jump.target) if jump.target is not None else ()))


def _ends(analysis: Analysis, found: Iterable[Jump]) -> Mapping[int, set[int]]:
    """The last blocks of ranges with the lines behind the jumps that return from there."""
    behind: dict[int, set[int]] = {}
    for jump in found:
        for label in labels(analysis, jump.end) if jump.end is not None else ():
            behind.setdefault(label.line, set()).add(jump.line + 1)
    return behind
