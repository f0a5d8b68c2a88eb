"""The mentions of a document: kept with each chunk, found by place and by symbol. Never goes through lines that name nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Generator, Hashable, Iterable, Iterator, Sequence
from functools import cached_property, partial
from heapq import merge, nsmallest
from itertools import islice
from operator import attrgetter, itemgetter
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import done, kept
from deburr.symbols import SOUGHT, Act, Language, Mention, Sort, Symbol, language_of
from deburr_grammar.behind import rests
from deburr_grammar.dialect import Bracket, Reading, Role

if TYPE_CHECKING:
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Facts, LineNode, Shape

Region = tuple[str, str | None] | None
"""The region that a line is in: its kind and its label; None: in none."""


Placings = dict[Symbol, list[tuple[int, "Mention"]]]
"""Mentions by symbol, with their lines counted from the first of a piece."""
_Local = tuple[Symbol, Region]
"""A local symbol and its region."""
_SEVERAL = 2
"""So often something is counted."""
_FEW = 16
"""So many mentions are read in one step."""
_HEADS = (1, 2, 4, 8, 16)
"""By so many letters at their beginnings names are looked for."""
_INHERITED: Region = ("", "")
"""The region that is open before a piece, whichever that is."""


class Placed(NamedTuple):
    """A mention, its line, and the region of a local symbol."""

    line: int
    mention: Mention
    region: Region


class _Regions:
    """A fold whose state is the region."""

    start: Region = None
    only_brackets = True

    def plain(self, state: Region, reading: Reading, shape: Shape) -> Region:
        """Only brackets change it."""
        return state

    def marked(self, state: Region, line: LineNode, brackets: Sequence[Bracket]) -> Region:
        """Behind the brackets of a line."""
        for bracket in brackets:
            state = _behind(state, bracket)
        return state


_REGIONS = _Regions()


def on_line(document: Document, line: int) -> list[Mention]:
    """What a line names, from left to right."""
    language = language_of(document.dialect.name)
    if language is None or not 0 <= line < document.line_count:
        return []
    return _of_line(document.node(line), language, language.names(document))


def at(document: Document, line: int, col: int) -> Placed | None:
    """What is named at a place, or right before it; of mentions in each other the inner one."""
    found = [each for each in on_line(document, line) if each.symbol.name and each.span.start <= col <= each.span.end]
    inside = [each for each in found if col < each.span.end] or found
    mention = min(inside, key=lambda each: each.span.end - each.span.start, default=None)
    return None if mention is None else Placed(line, mention, region(document, line) if mention.symbol.local else None)


def region(document: Document, line: int) -> Region:
    """The region that a line is in; its first and last line are in it."""
    piece = document.piece(line)
    return _in_force(_regions(document, piece), line - piece.line, document, piece)


def mentions_of(document: Document, symbol: Symbol, where: Region = None, act: Act | None = None) -> Iterator[Placed]:
    """All places that name a symbol, or do one thing with it, in order; of a local one those in its region, found without a look into others."""
    index = _Index.of(document)
    if index is None or symbol.sort not in SOUGHT:
        return
    for piece in index.within(symbol, where) if symbol.local else index.pieces(symbol, act):
        regions = _regions(document, piece) if symbol.local else ()
        for at, mention in index.placed(piece)[symbol]:
            if act is not None and mention.act is not act:
                continue
            if not symbol.local or _in_force(regions, at, document, piece) == where:
                yield Placed(piece.line + at, mention, where if symbol.local else None)


def between(document: Document, first: int, last: int) -> Iterator[tuple[int, Mention]]:
    """All that some lines name, both included; no other part of the program is looked at."""
    index, line, looked = _Index.of(document), first, -1
    while index is not None and line <= min(last, document.line_count - 1):
        piece = document.piece(line)
        if piece.line == looked:
            return
        for placed in index.placed(piece).values():
            yield from ((piece.line + at, each) for at, each in placed if first <= piece.line + at <= last)
        # The last piece may have a line behind its last line end.
        looked, line = piece.line, piece.line + piece.chunk.eols


def locals_of(document: Document, where: Region) -> dict[Symbol, int]:
    """The local symbols that are named in a region, and how often; more than once is twice."""
    index, found = _Index.of(document), dict[Symbol, int]()
    if index is None:
        return found
    for piece, inherits in index.entered(where):
        tallied = index.tallied(piece)
        for at in (where, _INHERITED) if inherits else (where,):
            for symbol, several in tallied.get(at, {}).items():
                found[symbol] = min(found.get(symbol, 0) + several, _SEVERAL)
    return found


def reading(document: Document) -> Iterator[None]:
    """Learn what all lines name, in steps; behind the last one no question has to read the program."""
    index = _Index.of(document)
    if index is None:
        return
    for piece in document.pieces():
        yield from index.reading(piece)
        index.tallied(piece)
        yield
    for fold in index.folds():
        fold()
        yield


def all_symbols(document: Document, *sorts: Sort) -> frozenset[Symbol]:
    """All symbols that are looked for, or those of some sorts: a program may have a label on each line, but calls few files."""
    index = _Index.of(document)
    if index is None:
        return frozenset()
    if not sorts:
        return document.gathered(index.key, index.symbols)
    chosen = frozenset(sorts)
    return document.gathered((index.key, chosen), lambda piece: _of_sorts(index.symbols(piece), chosen))


def led_to(document: Document, key: Hashable, where: Callable[[Symbol], str | None], *sorts: Sort) -> frozenset[str]:
    """All to which symbols of some sorts lead. ``where`` is asked once of the names of each part of a program, under the key."""
    index = _Index.of(document)
    if index is None:
        return frozenset()
    chosen = frozenset(sorts)

    def of(piece: Piece) -> frozenset[str]:
        found = map(where, _of_sorts(index.symbols(piece), chosen))
        return frozenset(each for each in found if each is not None)

    return document.gathered((index.key, chosen, key), of)


def first_symbols(document: Document, sort: Sort, begun: str, most: int, own: Iterable[Symbol] = ()) -> list[Symbol]:
    """The first names of a sort in order, numbers as numbers, local ones only if they are among ``own``; of more than ``most`` some that go on as what is written begins.

    How many there are does not matter: each part of a program knows its first ones, and where those stand that begin in some way.
    """
    index = _Index.of(document)
    if index is None:
        return []
    several = most + 1

    def cut(found: frozenset[Symbol]) -> frozenset[Symbol]:
        return found if len(found) <= several else frozenset(nsmallest(several, found, key=_in_order))

    def shared(piece: Piece) -> frozenset[Symbol]:
        return frozenset(each for each in index.symbols(piece) if each.sort is sort and not each.local)

    found = document.gathered((index.key, sort, several), shared, cut)
    if len(found) > most and begun:
        found = index.beginning(shared, sort, begun.lower(), several)
    every = found.union(own)
    if len(every) > most and begun:
        every = frozenset(each for each in every if any(said.startswith(begun.lower()) for said in index.said(each)))
    return nsmallest(most, every, key=_in_order)


def all_called(document: Document, sort: Sort) -> frozenset[Symbol]:
    """The symbols of a sort to which something goes."""
    index = _Index.of(document)
    found = frozenset[Symbol]() if index is None else document.gathered((index.key, Act.CALL), index.doing(Act.CALL))
    return _of_sorts(found, frozenset((sort,)))


class _Index:
    """The mentions of a document under the names that its language takes from all of it."""

    def __init__(self, document: Document, language: Language) -> None:
        self._document = document
        self._language = language
        self._names = language.names(document)
        self.key = ("symbols", self._names)
        self._local = ("locals", self._names)
        self._key_opened = ("opened", document.dialect.name)

    @classmethod
    def of(cls, document: Document) -> _Index | None:
        """The index of a document; None if nothing is known of its language."""
        language = language_of(document.dialect.name)
        return None if language is None else cls(document, language)

    def pieces(self, symbol: Symbol, act: Act | None = None) -> Iterator[Piece]:
        """The pieces that name a symbol, or do one thing with it."""
        if act is None:
            return self._document.holding(self.key, self.symbols, symbol)
        return self._document.holding((self.key, act), self.doing(act), symbol)

    def folds(self) -> Iterator[Callable[[], object]]:
        """What questions fold from all pieces."""
        document = self._document
        yield partial(document.gathered, self.key, self.symbols)
        for act in (Act.DEFINE, Act.SET, Act.CALL):
            yield partial(document.gathered, (self.key, act), self.doing(act))
        yield partial(document.state, _REGIONS, document.line_count - 1)
        yield partial(document.gathered, self._key_opened, self._opened)
        yield lambda: self._unentered

    def doing(self, act: Act) -> Callable[[Piece], frozenset[Symbol]]:
        """With what a piece does one thing."""

        return lambda piece: self._acts(piece).get(act, frozenset())

    def _acts(self, piece: Piece) -> dict[Act, frozenset[Symbol]]:
        """What a piece does with what; kept with the chunk."""
        key = ("acts", self._document.key(piece), self._names)
        found: dict[Act, frozenset[Symbol]] | None = piece.chunk.memo.get(key)
        if found is None:
            acted: dict[Act, set[Symbol]] = {}
            for symbol, places in self.placed(piece).items():
                for _, each in places:
                    acted.setdefault(each.act, set()).add(symbol)
            found = piece.chunk.memo[key] = {act: frozenset(symbols) for act, symbols in acted.items()}
        return found

    def within(self, symbol: Symbol, where: Region) -> Iterator[Piece]:
        """The pieces that may name a local symbol in a region, in order; what is in no piece of the region is not read for it."""
        # Most of a program may be in no region, so what names the symbol is looked through, not the region.
        found = self._unregioned(symbol) if where is None else self._regioned(symbol, where)
        last = -1
        for piece in found:
            if piece.line != last:
                yield piece
            last = piece.line

    def _unregioned(self, symbol: Symbol) -> Iterator[Piece]:
        """The pieces that name a symbol on lines that are in no region."""
        found = (piece for piece, inherits in self._unentered if inherits and symbol in self.placed(piece))
        return merge(self._holding((symbol, None)), found, key=attrgetter("line"))

    def _regioned(self, symbol: Symbol, where: Region) -> Iterator[Piece]:
        """The pieces that name a symbol and have lines of a region that one of them opens."""
        return (piece for piece, _ in self.entered(where) if symbol in self.placed(piece))

    def entered(self, where: Region) -> Iterable[tuple[Piece, bool]]:
        """The pieces that have lines of a region and may name local symbols there, in order; and whether they begin in it."""
        return self._unentered if where is None else self._from(where)

    def _from(self, where: Region) -> Iterator[tuple[Piece, bool]]:
        """Those of a region that one of them opens."""
        # A part that is opened once more inside itself is come to twice.
        inherits: dict[int, tuple[Piece, bool]] = {}
        for left in self._document.holding(self._key_opened, self._opened, where):
            inherits.setdefault(left.line, (left, False))
            if _regions(self._document, left)[-1][1] == where:
                inherits |= {piece.line: (piece, True) for piece in self._behind(left)}
        return (inherits[line] for line in sorted(inherits))

    @cached_property
    def _unentered(self) -> list[tuple[Piece, bool]]:
        """The pieces with local symbols on lines in no region, and those that begin in none."""
        key = ("left", self._document.dialect.name)
        first = self._document.piece(0)
        inheriting = [first, *self._on_from(first)]
        for left in self._document.holding(key, self._left, True):
            inheriting += self._behind(left)
        found = {piece.line: (piece, True) for piece in inheriting}
        for piece in self._document.holding((self.key, "unregioned"), self._unregions, True):
            found.setdefault(piece.line, (piece, False))
        return [found[line] for line in sorted(found)]

    def _left(self, piece: Piece) -> frozenset[bool]:
        """Whether a piece ends in no region because it leaves one."""
        regions = _regions(self._document, piece)
        return frozenset((True,) if regions and regions[-1][1] is None else ())

    def _unregions(self, piece: Piece) -> frozenset[bool]:
        """Whether local symbols are named in no region behind one that a piece leaves."""
        return frozenset((True,) if None in self.tallied(piece) else ())

    def _opened(self, piece: Piece) -> frozenset[Region]:
        return frozenset(region for _, region in _regions(self._document, piece))

    def _on_from(self, piece: Piece) -> Iterator[Piece]:
        """The pieces behind one that begin in the region in which that one begins."""
        return iter(()) if _regions(self._document, piece) else self._behind(piece)

    def _behind(self, left: Piece) -> Iterator[Piece]:
        """The pieces behind one that begin in the region in which that one ends."""
        # The last piece may have no line end, and so none behind it.
        while left.chunk.eols and (line := left.line + left.chunk.eols) < self._document.line_count:
            left = self._document.piece(line)
            if left.line != line:
                return
            yield left
            if _regions(self._document, left):
                return

    def _holding(self, item: _Local) -> Iterator[Piece]:
        return self._document.holding(self._local, self._locals, item)

    def _locals(self, piece: Piece) -> frozenset[_Local]:
        """The local symbols of a piece with their regions."""
        return frozenset((symbol, region) for region, found in self.tallied(piece).items() for symbol in found)

    def tallied(self, piece: Piece) -> dict[Region, dict[Symbol, int]]:
        """How often a piece names its local symbols in each region, as far as it says; kept with the chunk."""
        key = ("tallied", self._document.key(piece), self._names)
        found: dict[Region, dict[Symbol, int]] | None = piece.chunk.memo.get(key)
        if found is None:
            regions, found = _regions(self._document, piece), {}
            named = ((symbol, at) for symbol, placed in self.placed(piece).items() if symbol.local for at, _ in placed)
            for symbol, at in named:
                there = found.setdefault(_said(regions, at), {})
                there[symbol] = min(there.get(symbol, 0) + 1, _SEVERAL)
            piece.chunk.memo[key] = found
        return found

    def symbols(self, piece: Piece) -> frozenset[Symbol]:
        """What a piece names."""
        return frozenset(self.placed(piece))

    def placed(self, piece: Piece) -> Placings:
        """The mentions of a piece by symbol, with their lines counted from its first; kept with the chunk."""
        found: Placings | None = piece.chunk.memo.get(self._placing(piece))
        return done(self.reading(piece)) if found is None else found

    def reading(self, piece: Piece) -> Generator[None, None, Placings]:
        """The same in steps."""
        return kept(piece.chunk.memo, self._placing(piece), partial(self._read, piece))

    def _placing(self, piece: Piece) -> Hashable:
        return "mentions", self._document.key(piece), self._names

    def _read(self, piece: Piece) -> Generator[None, None, Placings]:
        found: Placings = {}
        for number, (index, mention) in enumerate(self._mentions(piece)):
            if mention.symbol.sort in SOUGHT and not mention.passing:
                found.setdefault(mention.symbol, []).append((index, mention))
            if not number % _FEW:
                yield
        return found

    def beginning(
        self, of: Callable[[Piece], frozenset[Symbol]], sort: Sort, begun: str, several: int
    ) -> frozenset[Symbol]:
        """Symbols of a sort among those of pieces whose names, bare or as they are written, begin in some way, in small letters; not many more than ``several``."""
        size = max(each for each in _HEADS if each <= len(begun))

        def heads(piece: Piece) -> frozenset[str]:
            return frozenset(said[:each] for said, _ in self._spelled(piece, of, sort) for each in _HEADS)

        found: set[Symbol] = set()
        for piece in self._document.holding((self.key, sort, "heads"), heads, begun[:size]):
            known = self._spelled(piece, of, sort)
            for said, symbol in islice(known, bisect_left(known, begun, key=itemgetter(0)), None):
                if not said.startswith(begun):
                    break
                found.add(symbol)
            if len(found) >= several:
                break
        return frozenset(found)

    def said(self, symbol: Symbol) -> tuple[str, str]:
        """A symbol's name, bare and as it is written, in small letters."""
        return symbol.name.lower(), self._language.written(symbol).lower()

    def _spelled(self, piece: Piece, of: Callable[[Piece], frozenset[Symbol]], sort: Sort) -> list[tuple[str, Symbol]]:
        """The symbols of a piece under their names and as they are written, in order; kept with the chunk."""
        key = ("written", sort, self.key, self._document.key(piece))
        known: list[tuple[str, Symbol]] | None = piece.chunk.memo.get(key)
        if known is None:
            both = ((said, each) for each in of(piece) for said in self.said(each))
            known = piece.chunk.memo[key] = sorted(both, key=itemgetter(0))
        return known

    def _mentions(self, piece: Piece) -> Iterator[tuple[int, Mention]]:
        naming = self._language.NAMING
        for index, _, _ in piece.where(lambda reading, shape: _names_any(shape.facts(reading), naming)):
            for mention in _of_line(piece.node(index), self._language, self._names):
                yield index, mention


def _regions(document: Document, piece: Piece) -> tuple[tuple[int, Region], ...]:
    """From which of its lines on a piece is in which region, as far as its own brackets say; kept with the chunk."""
    key = ("regions", document.key(piece))
    found: tuple[tuple[int, Region], ...] | None = piece.chunk.memo.get(key)
    if found is None:
        changes = [
            (index + (bracket.role is Role.END_REGION), _behind(None, bracket))
            for index, bracket in piece.outlined.brackets
            if bracket.role in (Role.REGION, Role.END_REGION)
        ]
        found = piece.chunk.memo[key] = tuple(changes)
    return found


def _said(regions: Sequence[tuple[int, Region]], index: int) -> Region:
    """The region of a line as far as its piece says."""
    number = bisect_right(regions, index, key=itemgetter(0))
    return regions[number - 1][1] if number else _INHERITED


def _in_force(regions: Sequence[tuple[int, Region]], index: int, document: Document, piece: Piece) -> Region:
    """The region of a line of a piece."""
    found = _said(regions, index)
    return document.state(_REGIONS, piece.line) if found == _INHERITED else found


def _in_order(symbol: Symbol) -> tuple[bool, int, str]:
    """Numbers as numbers, names behind them."""
    return not symbol.name.isdigit(), len(symbol.name) if symbol.name.isdigit() else 0, symbol.name


def _of_sorts(symbols: frozenset[Symbol], sorts: frozenset[Sort]) -> frozenset[Symbol]:
    return frozenset(symbol for symbol in symbols if symbol.sort in sorts)


def _behind(state: Region, bracket: Bracket) -> Region:
    if bracket.role is Role.REGION:
        return bracket.kind, bracket.label
    return None if bracket.role is Role.END_REGION else state


def _of_line(line: LineNode, language: Language, names: Hashable) -> list[Mention]:
    if line.reading.start is None:
        return []
    found = [*language.mentions(line, names)]
    for rest in rests(line):
        known = [each.span for each in found]
        more = language.mentions(rest, names)
        found += (
            each for each in more if not any(each.span.start < end and start < each.span.end for start, end in known)
        )
    return sorted(found, key=lambda each: each.span)


def _names_any(facts: Facts, naming: frozenset[str]) -> bool:
    """Whether a line may name something that is looked for; what stands behind a fault is not known yet."""
    return bool(facts.problems) or not facts.kinds.isdisjoint(naming)
