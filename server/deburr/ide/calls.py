"""Who calls what: subprograms, sections, snippets and whole programs, across files. Never follows a call that only a run knows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.definition import definitions, file_of
from deburr.ide.outline import Part, outline
from deburr.ide.related import uses
from deburr.ide.view import Spot
from deburr.symbols import Act, Sort, Symbol
from deburr.symbols.index import Placed, all_symbols, at, mentions_of
from deburr_grammar.text import Pos, Span

if TYPE_CHECKING:
    from deburr.ide.view import View

_CALLABLE = (Sort.SUB, Sort.SECTION, Sort.FILE)


class Routine(NamedTuple):
    """What can be called: its file, its name, its lines (both included), the place of its name. ``whole``: it is all of its file."""

    file: str
    name: str
    sort: Sort
    first: int
    last: int
    line: int
    span: Span
    whole: bool


class Calls(NamedTuple):
    """A routine at the other end of calls, and the places of these calls."""

    routine: Routine
    places: tuple[Spot, ...]


def prepared(view: View, pos: Pos) -> list[Routine]:
    """What is called or defined at a place; without that, the routine that the place stands in."""
    placed = at(view.document, pos.line, pos.col)
    if placed is not None and placed.mention.symbol.sort in _CALLABLE:
        return list(_targets(view, placed))
    return [around(view, pos.line)]


def around(view: View, line: int) -> Routine:
    """The innermost routine that a line stands in; the whole program if it stands in no other."""
    found = [part for part in _flat(outline(view)) if part.sort in _CALLABLE and part.first <= line <= part.last]
    return _routine(view, max(found, key=lambda part: part.first)) if found else whole(view)


def whole(view: View) -> Routine:
    """A program as one routine."""
    last = view.document.line_count - 1
    return Routine(view.file, view.file.rpartition("/")[2], Sort.FILE, 0, last, 0, Span(0, 0), True)


def incoming(view: View, routine: Routine) -> list[Calls]:
    """The routines that call one."""
    found: dict[Routine, list[Spot]] = {}
    for other, placed in _callers(view, routine):
        spot = Spot(other.file, placed.line, placed.mention.inner)
        found.setdefault(around(other, placed.line), []).append(spot)
    return [Calls(each, tuple(spots)) for each, spots in found.items()]


def outgoing(view: View, routine: Routine) -> list[Calls]:
    """The routines that one calls."""
    found: dict[Routine, list[Spot]] = {}
    for placed in _calls(view, routine):
        for target in _targets(view, placed):
            found.setdefault(target, []).append(Spot(view.file, placed.line, placed.mention.inner))
    return [Calls(each, tuple(spots)) for each, spots in found.items()]


def _callers(view: View, routine: Routine) -> Iterator[tuple[View, Placed]]:
    symbol = None if routine.whole else _symbol(view, routine)
    if symbol is not None:
        yield from ((other, one) for other, one in uses(view, symbol, None) if one.mention.act is Act.CALL)
        return
    for other in view.all():
        for each in all_symbols(other.document, *_CALLABLE):
            if each.name and file_of(other, each) == view.file and not _defines(other, each):
                yield from ((other, one) for one in mentions_of(other.document, each) if one.mention.act is Act.CALL)


def _calls(view: View, routine: Routine) -> Iterator[Placed]:
    """The calls in a routine, in order, without those in routines within it."""
    found = []
    for symbol in all_symbols(view.document, *_CALLABLE):
        for one in mentions_of(view.document, symbol):
            inside = one.mention.act is Act.CALL and routine.first <= one.line <= routine.last
            if inside and symbol.name and around(view, one.line) == routine:
                found.append(one)
    yield from sorted(found, key=lambda one: (one.line, one.mention.span))


def _targets(view: View, placed: Placed) -> Iterator[Routine]:
    for spot in definitions(view, placed):
        other = view.beside(spot.file)
        if other is not None:
            is_named = spot.span != Span(0, 0)
            yield around(other, spot.line) if is_named else whole(other)


def _symbol(view: View, routine: Routine) -> Symbol | None:
    placed = at(view.document, routine.line, routine.span.start)
    return placed.mention.symbol if placed is not None and placed.mention.symbol.sort in _CALLABLE else None


def _defines(view: View, symbol: Symbol) -> bool:
    return any(one.mention.act is Act.DEFINE for one in mentions_of(view.document, symbol))


def _routine(view: View, part: Part) -> Routine:
    """A part as a routine; its name is where it is defined on its first line."""
    names = (at(view.document, part.first, col) for col in range(part.span.start, part.span.end + 1))
    name = next((one for one in names if one is not None and one.mention.symbol.sort in _CALLABLE), None)
    span = name.mention.inner if name is not None else part.span
    return Routine(view.file, part.name, part.sort, part.first, part.last, part.first, span, False)


def _flat(parts: list[Part]) -> Iterator[Part]:
    for part in parts:
        yield part
        yield from _flat(part.parts)
