"""Programs that name things of each other: what a program calls, and what calls it, as far as the session knows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

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
    """A host that looks into each folder once: the thousands of names of a library may all lead into the same."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._names: dict[str, Sequence[str]] = {}

    def read(self, path: str) -> str | None:
        """The text of a file."""
        return self._host.read(path)

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        found = self._names.get(folder)
        if found is None:
            found = self._names[folder] = self._host.names(folder)
        return found


def called(view: View) -> Iterator[View]:
    """The programs whose files a program's names lead to."""
    language, host = language_of(view.dialect.name), _Glance(view.host)
    for symbol in all_symbols(view.document, *_FILES) if language is not None else ():
        path = language.file(symbol, view.file, view.ruleset, host) if language is not None else None
        found = None if path is None or path == view.file else view.beside(path)
        if found is not None:
            yield found


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
