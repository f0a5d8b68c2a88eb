"""Openers and closers as a monoid: a stretch of lines is how many blocks it closes and opens beyond itself. Never reads a line.

Blocks pair by depth alone and are compared afterwards, so each fault costs at most one
finding a level. A region boundary (a subprogram, a section) cuts: no block reaches across.
"""

from collections import deque
from collections.abc import Callable, Hashable, Iterable, Sequence
from enum import Enum
from typing import Generic, NamedTuple, TypeVar

from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.text import Span

Made = TypeVar("Made")
CUTS = (Role.REGION, Role.END_REGION)


class Balance(NamedTuple):
    """The unmatched brackets of a stretch: closers before its first cut, openers behind its last."""

    closers: int = 0
    openers: int = 0
    cut: bool = False

    def then(self, after: "Balance") -> "Balance":
        """The balance of this stretch and the one behind it together. Associative; `Balance()` is neutral."""
        if after is EVEN or self is EVEN:
            return self if after is EVEN else after
        left = max(0, after.closers - self.openers)
        closers = self.closers if self.cut else self.closers + left
        openers = after.openers if after.cut else after.openers + max(0, self.openers - after.closers)
        return Balance(closers, openers, self.cut or after.cut)


EVEN = Balance()
_OPEN = Balance(0, 1)
_CLOSE = Balance(1, 0)
_CUT = Balance(0, 0, True)


def balance(brackets: Iterable[Bracket]) -> Balance:
    """The balance of brackets in reading order."""
    total = EVEN
    for bracket in brackets:
        total = total.then(single(bracket))
    return EVEN if total == EVEN else total


def single(bracket: Bracket) -> Balance:
    """The balance of one bracket."""
    if bracket.role is Role.OPEN:
        return _OPEN
    if bracket.role is Role.CLOSE:
        return _CLOSE
    return _CUT if bracket.role in CUTS else EVEN


def joined(balances: Iterable[Balance]) -> Balance:
    """The balance of stretches that follow each other."""
    total = EVEN
    for each in balances:
        total = total.then(each)
    return total


class Fault(Enum):
    """What can be wrong with the structure of a program."""

    UNOPENED = "closes what nothing opened"
    UNCLOSED = "is never closed"
    MISMATCH = "closes a block of another kind or label"
    ACROSS = "holds a region inside, which no block may"
    CROSSED = "closes a block across one that was opened inside it"
    REGION_UNOPENED = "ends a region that nothing started"
    REGION_UNCLOSED = "starts a region that is never ended"
    REGION_NESTED = "starts a region inside another"
    REGION_MISMATCH = "ends a region of another label"


class Placed(NamedTuple):
    """A bracket and its line, counted from wherever the whole is counted from."""

    line: int
    bracket: Bracket

    def moved(self, lines: int) -> "Placed":
        """The same bracket that many lines further down."""
        return Placed(self.line + lines, self.bracket)


class StructureFault(NamedTuple):
    """A fault, the bracket that is to be marked, and the other end that explains it."""

    fault: Fault
    at: Placed
    other: Placed | None = None

    def moved(self, lines: int) -> "StructureFault":
        """The same fault that many lines further down."""
        return StructureFault(self.fault, self.at.moved(lines), self.other and self.other.moved(lines))


class Reduction(NamedTuple):
    """A stretch of lines with all pairs inside it taken out. Associative; `NOTHING` is neutral.

    What is left: closers before the first region boundary, openers behind the last one, the
    faults of what was paired or cut off, and the first and last region boundary.
    """

    closers: tuple[Placed, ...] = ()
    openers: tuple[Placed, ...] = ()
    faults: tuple[StructureFault, ...] = ()
    first: Placed | None = None
    last: Placed | None = None

    @property
    def balance(self) -> Balance:
        """How much the stretch closes and opens too much."""
        found = Balance(len(self.closers), len(self.openers), self.first is not None)
        return EVEN if found == EVEN else found

    def then(self, after: "Reduction") -> "Reduction":
        """This stretch and the one behind it together; lines of both counted alike."""
        if after is NOTHING or self is NOTHING:
            return self if after is NOTHING else after
        pairs = min(len(self.openers), len(after.closers))
        faults = [found for pair in zip(reversed(self.openers), after.closers[:pairs]) if (found := _compared(*pair))]
        left_open, left_closing = self.openers[: len(self.openers) - pairs], after.closers[pairs:]
        if after.first is not None:
            faults += [StructureFault(Fault.UNCLOSED, opener) for opener in left_open]
            left_open = ()
            faults += _boundaries(self.last, after.first) if self.last is not None else []
        if self.last is not None:
            faults += [StructureFault(Fault.UNOPENED, closer) for closer in left_closing]
            left_closing = ()
        return Reduction(
            self.closers + left_closing,
            left_open + after.openers,
            self.faults + tuple(faults) + after.faults if faults or after.faults else self.faults,
            self.first or after.first,
            after.last or self.last,
        )

    def moved(self, lines: int) -> "Reduction":
        """The same stretch that many lines further down."""
        if not lines or self == NOTHING:
            return self
        return Reduction(
            tuple(closer.moved(lines) for closer in self.closers),
            tuple(opener.moved(lines) for opener in self.openers),
            tuple(fault.moved(lines) for fault in self.faults),
            self.first and self.first.moved(lines),
            self.last and self.last.moved(lines),
        )

    def all_faults(self) -> tuple[StructureFault, ...]:
        """The faults of a whole program: what is left over belongs to nothing."""
        found = [*self.faults]
        found += [StructureFault(Fault.UNOPENED, closer) for closer in self.closers]
        found += [StructureFault(Fault.UNCLOSED, opener) for opener in self.openers]
        found += _boundaries(None, self.first) + _boundaries(self.last, None)
        return tuple(sorted(explained(sorted(found, key=_order)), key=_order))


_LATELY = 32
"""So many answers are kept of what was asked last. A key changes those of one path through the program, mostly to the same."""


class _Lately(Generic[Made]):
    """What was made of some objects lately, to be found again as the same object when it is asked of the same ones."""

    def __init__(self, make: Callable[..., Made]) -> None:
        self._make = make
        self._known: dict[Hashable, tuple[tuple[object, ...], Made]] = {}
        """With what each was made of: as long as it is kept, no other object can be in the place of that."""

    def of(self, parts: Sequence[Reduction], *more: Hashable) -> Made:
        """What is made of reductions, and of what else it hangs on."""
        key = (*map(id, parts), more)
        found = self._known.pop(key, None)
        if found is None:
            found = ((*parts,), self._make(parts, *more))
            if len(self._known) >= _LATELY:
                del self._known[next(iter(self._known))]
        self._known[key] = found
        return found[1]


def _in_a_row(parts: Sequence[Reduction], lines: Sequence[int]) -> Reduction:
    left, before = NOTHING, 0
    for part, count in zip(parts, lines):
        left, before = left.then(part.moved(before)), before + count
    return left


def in_a_row(parts: Sequence[Reduction], lines: tuple[int, ...]) -> Reduction:
    """Stretches of so many lines, one behind the other, as one: the object that it was, if they are."""
    return _rows.of(parts, lines) if any(part is not NOTHING for part in parts) else NOTHING


def _faults(parts: Sequence[Reduction], file_ends_region: bool) -> tuple[StructureFault, ...]:
    found = parts[0].all_faults()
    return tuple(each for each in found if each.fault is not Fault.REGION_UNCLOSED) if file_ends_region else found


def faults_of(whole: Reduction, file_ends_region: bool) -> tuple[StructureFault, ...]:
    """The faults of a whole program: the object that they were, if its reduction is."""
    return _known_faults.of((whole,), file_ends_region)


_rows = _Lately(_in_a_row)
_known_faults = _Lately(_faults)


def _order(fault: StructureFault) -> tuple[int, Span]:
    return fault.at.line, fault.at.bracket.span


NOTHING = Reduction()


def reduction(brackets: Iterable[tuple[int, Bracket]]) -> Reduction:
    """The reduction of brackets in reading order."""
    closers: list[Placed] = []
    openers: list[Placed] = []
    faults: list[StructureFault] = []
    first: Placed | None = None
    last: Placed | None = None
    for line, bracket in brackets:
        placed = Placed(line, bracket)
        if bracket.role is Role.OPEN:
            openers.append(placed)
        elif bracket.role is Role.CLOSE:
            if openers:
                faults += [found] if (found := _compared(openers.pop(), placed)) else []
            elif last is not None:
                faults.append(StructureFault(Fault.UNOPENED, placed))
            else:
                closers.append(placed)
        elif bracket.role in CUTS:
            faults += [StructureFault(Fault.UNCLOSED, opener) for opener in openers]
            faults += _boundaries(last, placed) if last is not None else []
            openers.clear()
            first, last = first or placed, placed
    left = Reduction(tuple(closers), tuple(openers), tuple(faults), first, last)
    return NOTHING if left == NOTHING else left


def explained(faults: Iterable[StructureFault]) -> list[StructureFault]:
    """Each mistake once, in the words of labels.

    Two mismatches that swap their labels are blocks that cross; a mismatch whose own opener
    stays open is a closer left out; an opener and a closer that only a region boundary keeps
    apart are one block around a region; the end of a region inside which another was started has
    been spoken of already.
    """
    found: list[StructureFault | None] = list(faults)
    known = _Index(found)
    for at, fault in enumerate(found):
        if fault is None or found[at] is None:
            continue
        if fault.fault is Fault.UNCLOSED:
            closer = known.take(found, (Fault.UNOPENED, _key(fault.at.bracket), None), at)
            found[at] = StructureFault(Fault.ACROSS, fault.at, closer.at) if closer else fault
        if fault.other is None:
            continue
        end, start = _key(fault.at.bracket), _key(fault.other.bracket)
        if fault.fault is Fault.MISMATCH:
            if known.take(found, (Fault.MISMATCH, start, end), at):
                found[at] = StructureFault(Fault.CROSSED, fault.at, fault.other)
            elif known.take(found, (Fault.UNCLOSED, end, None), -1):
                found[at] = StructureFault(Fault.UNCLOSED, fault.other, fault.at)
        elif fault.fault is Fault.REGION_NESTED:
            outer = known.take(found, (Fault.REGION_UNOPENED, start, None), at)
            _ = outer or known.take(found, (Fault.REGION_MISMATCH, start, end), at)
    return [fault for fault in found if fault is not None]


_Key = tuple[str, str | None]


class _Index:
    """Faults by what they are of: sort, the key of the bracket that is marked, the key of the other end."""

    def __init__(self, faults: Iterable[StructureFault | None]) -> None:
        self._at: dict[tuple[Fault, _Key, _Key | None], deque[int]] = {}
        for at, fault in enumerate(faults):
            if fault is not None:
                other = _key(fault.other.bracket) if fault.other is not None else None
                self._at.setdefault((fault.fault, _key(fault.at.bracket), other), deque()).append(at)

    def take(
        self, found: list[StructureFault | None], key: tuple[Fault, _Key, _Key | None], behind: int
    ) -> StructureFault | None:
        """Strike out the first such fault behind a place, if there is one."""
        # What is passed over here is never asked for again: the places asked about only move down.
        waiting = self._at.get(key)
        while waiting:
            at = waiting.popleft()
            if at > behind and (taken := found[at]) is not None:
                found[at] = None
                return taken
        return None


def _key(bracket: Bracket) -> _Key:
    return bracket.kind, bracket.label


def _ties(opener: Bracket, closer: Bracket) -> bool:
    return opener.kind == closer.kind and (opener.label == closer.label or None in (opener.label, closer.label))


def _compared(opener: Placed, closer: Placed) -> StructureFault | None:
    return None if _ties(opener.bracket, closer.bracket) else StructureFault(Fault.MISMATCH, closer, opener)


def _boundaries(last: Placed | None, first: Placed | None) -> list[StructureFault]:
    """What is wrong with two region boundaries that follow each other; None is the program's start or end."""
    opened = last if last is not None and last.bracket.role is Role.REGION else None
    if first is None:
        return [StructureFault(Fault.REGION_UNCLOSED, opened)] if opened else []
    if first.bracket.role is Role.REGION:
        return [StructureFault(Fault.REGION_NESTED, first, opened)] if opened else []
    if opened is None:
        return [StructureFault(Fault.REGION_UNOPENED, first)]
    return [] if _ties(opened.bracket, first.bracket) else [StructureFault(Fault.REGION_MISMATCH, first, opened)]
