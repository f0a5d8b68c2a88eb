"""The mentions of a document: kept with each chunk, found by place and by symbol. Never goes through lines that name nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Generator, Hashable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from heapq import nsmallest
from itertools import islice
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import done, kept
from deburr.symbols import SOUGHT, Act, Language, Mention, Sort, Symbol, language_of
from deburr_grammar.behind import rests
from deburr_grammar.dialect import Bracket, Reading, Role
from deburr_grammar.document import Gathering

if TYPE_CHECKING:
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Facts, LineNode, Shape

Region = tuple[str, str | None] | None
"""The region that a line is in: its kind and its label; None: in none."""


Placings = dict[Symbol, list[tuple[int, "Mention"]]]
"""Mentions by symbol, with their lines counted from the first of a piece."""
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


class Tally(NamedTuple):
    """How often local symbols are named in each region of a part of a program, twice at most, and the region that is open behind it."""

    named: Mapping[Region, Mapping[Symbol, int]]
    last: Region


class Opened(NamedTuple):
    """The regions that a part of a program opens, and the one that is open behind it."""

    regions: frozenset[Region]
    last: Region


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


def locals_of(document: Document, where: Region) -> Mapping[Symbol, int]:
    """The local symbols that are named in a region, and how often; more than once is twice."""
    index = _Index.of(document)
    if index is None:
        return {}
    if where is None:
        # Most of a program may be in no region; none is open before its first line.
        named = document.joined(index.locals).named
        return _counted(named.get(None, {}), named.get(_INHERITED, {}))
    found: Mapping[Symbol, int] = {}
    for piece, begun in index.entered(where):
        named = document.alone(piece, index.locals).named
        for at in (where, _INHERITED) if begun == where else (where,):
            found = _counted(found, named.get(at, {}))
    return found


def reading(document: Document) -> Iterator[None]:
    """Learn what all lines name, in steps; behind the last one no question has to read the program."""
    index = _Index.of(document)
    if index is None:
        return
    for piece in document.pieces():
        yield from index.reading(piece)
        yield
    yield from document.joining(index.locals)
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

    @property
    def locals(self) -> Gathering[Tally]:
        """How often local symbols are named in each region."""
        return Gathering(("locals", self._names), self.tally, _one_behind_the_other)

    @property
    def _regions(self) -> Gathering[Opened]:
        return Gathering(("regions", self._document.dialect.name), self._opens, _opened)

    def folds(self) -> Iterator[Callable[[], object]]:
        """What questions fold from all pieces."""
        document = self._document
        yield partial(document.gathered, self.key, self.symbols)
        for act in (Act.DEFINE, Act.SET, Act.CALL):
            yield partial(document.gathered, (self.key, act), self.doing(act))
        yield partial(document.state, _REGIONS, document.line_count - 1)

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

    def within(self, symbol: Symbol, where: Region) -> Iterable[Piece]:
        """The pieces that may name a local symbol in a region, in order; what is in no piece of the region is not read for it."""
        if where is not None:
            return (piece for piece, _ in self.entered(where) if symbol in self.placed(piece))

        # Most of a program may be in no region, so what names the symbol is looked through, not the region.
        def named(begun: Region, tally: Tally) -> bool:
            there = (None, _INHERITED) if begun is None else (None,)
            return any(symbol in tally.named.get(each, ()) for each in there)

        found = self._document.led(self.locals, None, named, lambda begun, tally: _open_behind(begun, tally.last))
        return (piece for piece, _ in found)

    def entered(self, where: Region) -> Iterator[tuple[Piece, Region]]:
        """The pieces that have lines of a region, in order, each with the region that is open before it."""

        def has(begun: Region, opened: Opened) -> bool:
            return begun == where or where in opened.regions

        return self._document.led(self._regions, None, has, lambda begun, opened: _open_behind(begun, opened.last))

    def _opens(self, piece: Piece) -> Opened:
        regions = _regions(self._document, piece)
        return Opened(frozenset(region for _, region in regions), regions[-1][1] if regions else _INHERITED)

    def tally(self, piece: Piece) -> Tally:
        """How often a piece names its local symbols in each region, as far as it says."""
        regions, tallied = _regions(self._document, piece), dict[Region, dict[Symbol, int]]()
        named = ((symbol, at) for symbol, placed in self.placed(piece).items() if symbol.local for at, _ in placed)
        for symbol, at in named:
            there = tallied.setdefault(_said(regions, at), {})
            there[symbol] = min(there.get(symbol, 0) + 1, _SEVERAL)
        return Tally(tallied, regions[-1][1] if regions else _INHERITED)

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


def _open_behind(begun: Region, last: Region) -> Region:
    """The region that is open behind a part, where one is open before it and its own lines leave the last one open."""
    return begun if last == _INHERITED else last


def _opened(parts: Sequence[Opened]) -> Opened:
    """The regions of parts that stand one behind the other."""
    last = _INHERITED
    for part in parts:
        last = _open_behind(last, part.last)
    return Opened(frozenset[Region]().union(*(part.regions for part in parts)), last)


def _one_behind_the_other(parts: Sequence[Tally]) -> Tally:
    """The tally of parts that stand one behind the other."""
    if len(parts) == 1:
        return parts[0]
    named, last = dict[Region, Mapping[Symbol, int]](), _INHERITED
    for part in parts:
        for region, tally in part.named.items():
            at = last if region == _INHERITED else region
            named[at] = _counted(named[at], tally) if at in named else tally
        last = _open_behind(last, part.last)
    return Tally(named, last)


def _counted(one: Mapping[Symbol, int], other: Mapping[Symbol, int]) -> Mapping[Symbol, int]:
    """How often symbols are named in two stretches."""
    more = {symbol: min(one.get(symbol, 0) + several, _SEVERAL) for symbol, several in other.items()}
    return {**one, **more}


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
