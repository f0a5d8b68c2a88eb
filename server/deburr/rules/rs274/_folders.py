"""The folders in which the files of called subs are looked for. Never reads a file whose name a shell would change."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from posixpath import basename, dirname, join, normpath, splitext

from deburr.analysis import Analysis
from deburr.host import sees_folder
from deburr.rules.rs274._program import Program
from deburr.steps import done
from deburr_grammar.document import Document

EXTENSION = ".ngc"
_PROGRAMS = frozenset((EXTENSION, ".nc", ".tap", ".cnc", ".gcode", ".txt"))
BREAKS = frozenset("$`'\"\\{}()&|;")
"""Signs that make a shell of a name: what they hold is run or dropped, or nothing is found."""
MATCHES = frozenset("*?[")
"""Signs that stand for any others in a file's name."""
_MOST = 500
"""So many names of a folder are tried for folders."""


class Folders:
    """The program's folder and those of the setting `subroutine-path`, in the order in which the control goes through them."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._host = analysis.host
        self._names: dict[str, frozenset[str]] = {}
        self._programs: dict[str, Program | None] = {}
        paths = analysis.settings["subroutine-path"] or ()
        self._here = dirname(analysis.file)
        self._all = [self._here, *(normpath(join(self._here, path.replace("\\", "/"))) for path in paths)]
        self.configured = bool(paths)
        self.searchable = sees_folder(analysis.host, analysis.file)
        """Whether files can be looked for at all, so that one can be missed."""

    def find(self, path: str) -> str | None:
        """The file that a label stands for."""
        if "\0" in path or not BREAKS.isdisjoint(path):
            return None
        for folder in self._all:
            file = normpath(join(folder, path + EXTENSION))
            if basename(file) in self._in(dirname(file)):
                return file
        return None

    def near(self, path: str) -> list[str]:
        """The files that are named almost as a label's file should be."""
        return sorted(set(self._near(path)))

    def nearby(self, label: str) -> str | None:
        """A file for a label in a folder beside or below the program's: only of use where no path is configured."""
        name = label + EXTENSION
        folder = next((each for each in ([] if self.configured else self._around) if name in self._in(each)), None)
        return None if folder is None else join(folder, name)

    def labels(self) -> set[str]:
        """The labels that have files."""
        own = basename(self._analysis.file)
        return {
            splitext(name)[0]
            for folder in self._all
            for name in self._in(folder)
            if name.endswith(EXTENSION) and name != own
        }

    def program(self, path: str) -> Program | None:
        """The program in a file; None if it cannot be read."""
        if path not in self._programs:
            text = self._host.read(path)
            self._programs[path] = None
            if text is not None:
                document = Document.parse(text.removeprefix("\ufeff"), self._analysis.dialect)
                self._programs[path] = done(Program.making(document, self._analysis.settings))
        return self._programs[path]

    def _near(self, path: str) -> Iterator[str]:
        for folder in self._all:
            for name in self._in(dirname(normpath(join(folder, path + EXTENSION)))):
                written, extension = splitext("".join(name.split()).lower())
                if written == basename(path) and extension in _PROGRAMS:
                    yield name

    @cached_property
    def _around(self) -> list[str]:
        """The folders below the program's, the one above it, and those beside it."""
        above = normpath(join(self._here, ".."))
        names = {each: [name for name in sorted(self._in(each)) if "." not in name] for each in (self._here, above)}
        return [*(join(each, name) for each, found in names.items() for name in found[:_MOST]), above]

    def _in(self, folder: str) -> frozenset[str]:
        if folder not in self._names:
            self._names[folder] = frozenset(self._host.names(folder))
        return self._names[folder]
