"""Programs that name things of each other: what a program calls, and what calls it, as far as the session knows."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from deburr.ruleset import RuleSet
from deburr.symbols import Act, Language, Sort, Symbol, language_of
from deburr.symbols.index import Placed, Region, led_to, mentions_of

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
        self.name = object()
        """Under this is kept what was found by it, which so does not keep the texts."""

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


_KEPT = 1_024
_glances: OrderedDict[tuple[str, RuleSet], _Glance] = OrderedDict()
"""What was looked at for each program that was asked about."""


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
    key = view.file, view.ruleset
    glance = _glances.get(key)
    if glance is None or not glance.holds(view.host):
        glance = _Glance(view.host)
    _glances[key] = glance
    _glances.move_to_end(key)
    if len(_glances) > _KEPT:
        _glances.popitem(last=False)
    found = led_to(view.document, glance.name, partial(_file, language, view, glance), *_FILES)
    return tuple(sorted(found - {view.file}))


def _file(language: Language, view: View, glance: _Glance, symbol: Symbol) -> str | None:
    return language.file(symbol, view.file, view.ruleset, glance)


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
