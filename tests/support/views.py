"""Programs for the tests of features: texts with a cursor `<|>`, and the files around them, all in memory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from deburr.ide.view import Spot, View
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Pos, split_lines

CURSOR = "<|>"
MAIN = "/job/main"


class Files:
    """A folder `/job` in memory, and the programs in it."""

    def __init__(self, dialect: str, files: Mapping[str, str], settings: Mapping[str, Any] | None = None) -> None:
        self.texts = dict(files)
        self._dialect = by_name(dialect)
        self._ruleset = RuleSet(self._dialect, settings)

    def read(self, path: str) -> str | None:
        """The text of a file."""
        return self.texts.get(path)

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        start = folder.rstrip("/") + "/"
        return sorted({path[len(start) :].partition("/")[0] for path in self.texts if path.startswith(start)})

    def view(self, file: str, like: View | None = None) -> View | None:
        """A file as a program."""
        text = self.read(file)
        if text is None:
            return None
        given = self._dialect.given(self._ruleset.settings, self.read)
        return View(file, Document.parse(text, self._dialect, 64, given), self._ruleset, self, self)

    def views(self, like: View) -> Iterator[View]:
        """All files as programs."""
        yield like
        for file in self.texts:
            found = self.view(file)
            if found is not None and file != like.file:
                yield found


def at_cursor(
    dialect: str,
    text: str,
    settings: Mapping[str, Any] | None = None,
    beside: Mapping[str, str] | None = None,
    **others: str,
) -> tuple[View, Pos]:
    """The program of a text with a cursor, among other files; `__` in the names of others is `/`, the first other `_` a point."""
    before = text.partition(CURSOR)[0]
    lines = split_lines(before)
    suffix = by_name(dialect).extensions[0]
    files = {f"/job/{name.replace('__', '/').replace('_', '.')}": said for name, said in others.items()}
    files |= {f"/job/{name}": said for name, said in (beside or {}).items()}
    found = Files(dialect, {MAIN + suffix: text.replace(CURSOR, ""), **files}, settings).view(MAIN + suffix)
    assert found is not None
    return found, Pos(len(lines) - 1, len(lines[-1]))


def marked(view: View, spots: Sequence[Spot]) -> list[str]:
    """Places as `file:line:text`, lines counted from 1."""
    found = []
    for spot in spots:
        other = view.beside(spot.file)
        assert other is not None
        said = other.document.line(spot.line)[spot.span.start : spot.span.end]
        found.append(f"{spot.file.rpartition('/')[2].partition('.')[0]}:{spot.line + 1}:{said}")
    return found
