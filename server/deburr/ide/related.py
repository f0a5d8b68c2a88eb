"""Programs that name things of each other: what a program calls, and what calls it, as far as the session knows."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from deburr.ruleset import RuleSet
from deburr.symbols import Act, Sort, Symbol, language_of
from deburr.symbols.index import Placed, Region, all_symbols, mentions_of

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ide.view import View

_MOST = 500
_FILES = (Sort.SUB, Sort.FILE, Sort.SECTION)
"""What can lead to another file."""
_SHARED = (Sort.SUB, Sort.FILE, Sort.VARIABLE)


class _Glance:
    """A host that looks into each folder once: the thousands of names of a library may all lead into the same. It knows what it was asked."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._texts: dict[str, str | None] = {}
        self._names: dict[str, Sequence[str]] = {}

    def read(self, path: str) -> str | None:
        """The text of a file."""
        if path not in self._texts:
            self._texts[path] = self._host.read(path)
        return self._texts[path]

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        found = self._names.get(folder)
        if found is None:
            found = self._names[folder] = self._host.names(folder)
        return found

    def holds(self, host: Host) -> bool:
        """Whether a host would still answer all that was asked as it did."""
        return all(host.names(folder) == names for folder, names in self._names.items()) and all(
            host.read(path) == text for path, text in self._texts.items()
        )


class _Led(NamedTuple):
    """The files to which the names of a program lead, and what was looked at to know that."""

    symbols: frozenset[Symbol]
    glance: _Glance
    files: tuple[str, ...]


_KEPT = 1_024
_led: OrderedDict[tuple[str, RuleSet], _Led] = OrderedDict()
"""Of each program as it was last asked about: an edit seldom changes what it calls."""


def called(view: View) -> Iterator[View]:
    """The programs whose files a program's names lead to."""
    for path in _files(view):
        found = view.beside(path)
        if found is not None:
            yield found


def _files(view: View) -> tuple[str, ...]:
    """The files to which a program's names lead, itself not among them."""
    language = language_of(view.dialect.name)
    if language is None:
        return ()
    symbols, key = all_symbols(view.document, *_FILES), (view.file, view.ruleset)
    kept = _led.get(key)
    same = kept is not None and (kept.symbols is symbols or kept.symbols == symbols)
    if kept is None or not same or not kept.glance.holds(view.host):
        glance = _Glance(view.host)
        found = (language.file(symbol, view.file, view.ruleset, glance) for symbol in symbols)
        kept = _Led(symbols, glance, tuple(sorted({path for path in found if path is not None and path != view.file})))
    _led[key] = kept
    _led.move_to_end(key)
    if len(_led) > _KEPT:
        _led.popitem(last=False)
    return kept.files


def related(view: View) -> list[View]:
    """A program, all that it calls, and all that call it, directly or not."""
    calls = {each.file: [found.file for found in called(each)] for each in view.all()}
    seen = {view.file: view}
    waiting = [view]
    while waiting and len(seen) < _MOST:
        one = waiting.pop()
        near = [each.file for each in called(one)] + [file for file, files in calls.items() if one.file in files]
        for file in near:
            found = view.beside(file) if file not in seen else None
            if found is not None:
                seen[file] = found
                waiting.append(found)
    return list(seen.values())


def where(view: View, symbol: Symbol) -> list[View]:
    """The programs in which a symbol can be named."""
    return related(view) if symbol.sort in _SHARED and not symbol.local else [view]


def uses(view: View, symbol: Symbol, region: Region, act: Act | None = None) -> Iterator[tuple[View, Placed]]:
    """All places that name a symbol, or do one thing with it, in all programs that can."""
    for each in where(view, symbol):
        for placed in mentions_of(each.document, symbol, region, act):
            yield each, placed
