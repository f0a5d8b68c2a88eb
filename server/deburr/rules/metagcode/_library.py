"""The snippet files of a program: where they lie, what is in them, how they name each other. Never judges a program.

Each file is asked for and read at most once in an analysis, and none that lies deeper than
snippets may (`spec/metagcode.md` §5.1).
"""

import posixpath
import re
from collections.abc import Mapping, Sequence
from functools import cached_property, lru_cache
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.host import NoFiles
from deburr.rule import Note
from deburr_grammar.dialect import Bracket, Dialect, Role
from deburr_grammar.dialects.metagcode.forms import counters, names
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document
from deburr_grammar.text import Span

DEEPEST = 20
"""The last legal depth of a snippet; the program itself is at 0."""
LARGEST = 1 << 20
"""Bytes that a snippet may have."""

_DRIVE = re.compile(r"[A-Za-z]:")


class Link(NamedTuple):
    """A `#FILE` line: the file and line in which it stands, the columns of the directive, the name in it."""

    file: str
    line: int
    span: Span
    name: str


class Found(NamedTuple):
    """The file of a snippet's name. ``exact``: it is spelled like that in its folder."""

    path: str
    text: str
    exact: bool

    @property
    def too_large(self) -> bool:
        """Whether the file is larger than a snippet may be."""
        return len(self.text) > LARGEST // 4 and len(self.text.encode("utf-8", "surrogatepass")) > LARGEST


class Scan(NamedTuple):
    """What a file says by itself: the text as it is read, its lines, its brackets with their lines, what its loops count, and all names in it."""

    document: Document
    lines: int
    brackets: Sequence[tuple[int, Bracket]]
    counts: Mapping[int, tuple[str, ...]]
    names: frozenset[str]


def leaves(name: str) -> bool:
    """Whether a snippet's name points out of the folder of snippets: `..`, an absolute path, a drive letter."""
    return name[:1] in ("/", "\\") or _DRIVE.match(name) is not None or ".." in map(str.strip, _split(name))


def is_plain(name: str | None) -> bool:
    """Whether a name can be looked up at all; rules on lines report those that cannot."""
    return name is not None and "|" not in name and not leaves(name)


class Library:
    """The files around one analysis."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._host = analysis.host
        self._found: dict[tuple[str, ...], Found | None] = {}
        self._texts: dict[str, str] = {}
        self._folders: dict[str, Sequence[str]] = {}
        self._longest: dict[tuple[str, int], tuple[Link, ...]] = {}
        self._ways: dict[str, Mapping[str, tuple[Link, ...]]] = {}
        self.file = analysis.file
        self.silent = isinstance(analysis.host, NoFiles)
        """Whether nothing is known of any file, so that nothing can be missed."""
        self.inside = False
        """Whether the program is itself a snippet."""
        self.root = self._find_root(str(analysis.settings["snippets-dir"]).replace("\\", "/"))

    def find(self, name: str) -> Found | None:
        """The file of a plain name; None if there is none, or several that differ from it in case only."""
        key = tuple(part for part in _split(name) if part not in ("", "."))
        if key not in self._found:
            self._found[key] = self._look_up(key)
        return self._found[key]

    def near(self, name: str) -> Sequence[str]:
        """The names in the folder in which a name is looked for."""
        *folders, _ = _split(name)
        return self._names(_joined(self.root, *folders))

    def target(self, bracket: Bracket) -> str | None:
        """The file that a `#FILE` line stands for; None if it is not to be had."""
        found = self.find(bracket.label) if bracket.label is not None and is_plain(bracket.label) else None
        return found.path if found is not None and not found.too_large else None

    def scan(self, path: str) -> Scan:
        """What is in a file that was found, or in the program itself."""
        return self.own if path == self.file else _scanned(self._texts[path], self._analysis.dialect)

    @cached_property
    def own(self) -> Scan:
        """What is in the program; names are not gathered, since nobody asks for those of a whole program."""
        return _scan(self._analysis.document, frozenset())

    def longest(self, path: str, left: int = DEEPEST) -> tuple[Link, ...]:
        """The longest chain of snippets below a file, up to a length."""
        if not left:
            return ()
        if (path, left) not in self._longest:
            chains = (((link, *self.longest(target, left - 1))) for target, link in self._links(path).items())
            self._longest[path, left] = max(chains, key=len, default=())
        return self._longest[path, left]

    def cycle(self, path: str) -> tuple[Link, ...]:
        """The chain from a file into the first circle of snippets and once around it; empty if there is none."""
        if len(self.longest(path)) < DEEPEST:
            return ()
        for each, way in {path: (), **self._reached(path)}.items():
            around = self._reached(each).get(each)
            if around:
                return (*(() if each == path else way), *around)
        return ()

    def notes(self, chain: Sequence[Link]) -> tuple[Note, ...]:
        """A chain of `#FILE` lines as related places."""
        return tuple(
            Note(link.line, link.span, f"`#FILE {link.name}`", None if link.file == self.file else link.file)
            for link in chain
        )

    def _links(self, path: str) -> Mapping[str, Link]:
        """The files that a file names, each with the first line that does."""
        links: dict[str, Link] = {}
        for line, bracket in self.scan(path).brackets:
            target = self.target(bracket) if bracket.kind == SNIPPET else None
            if target is not None:
                links.setdefault(target, Link(path, line, bracket.span, bracket.label or ""))
        return links

    def _reached(self, start: str) -> Mapping[str, tuple[Link, ...]]:
        """The files that a file leads to, itself too if it does, each with a shortest way."""
        if start not in self._ways:
            ways: dict[str, tuple[Link, ...]] = {}
            level = [start]
            for _ in range(DEEPEST):
                steps = [(path, target, link) for path in level for target, link in self._links(path).items()]
                level = []
                for path, target, link in steps:
                    if target not in ways:
                        ways[target] = (*ways.get(path, ()), link)
                        level.append(target)
            self._ways[start] = ways
        return self._ways[start]

    def _look_up(self, parts: tuple[str, ...]) -> Found | None:
        folder, exact = self.root, True
        if self.silent or not parts or "\0" in "".join(parts):
            return None
        for part in parts:
            spelled = _spelled(part, self._names(folder))
            if spelled is None:
                return None
            folder, exact = _joined(folder, spelled), exact and spelled == part
        text = self._host.read(folder)
        if text is None:
            return None
        self._texts[folder] = text.removeprefix("\ufeff")
        return Found(folder, self._texts[folder], exact)

    def _names(self, folder: str) -> Sequence[str]:
        if folder not in self._folders:
            self._folders[folder] = self._host.names(folder)
        return self._folders[folder]

    def _find_root(self, setting: str) -> str:
        """The folder of snippets: that in which the program lies, if it is a snippet itself, or one beside the program."""
        if setting.startswith("/") or _DRIVE.match(setting):
            root = setting.rstrip("/")
            self.inside = self.file.startswith(f"{root}/")
            return root
        folder = posixpath.dirname(self.file)
        beside = _joined(folder, setting)
        parts, tail = folder.split("/"), [part for part in setting.split("/") if part not in ("", ".", "..")]
        for stop in range(len(parts), len(tail) - 1, -1) if tail else ():
            if parts[stop - len(tail) : stop] == tail and not self._names(beside):
                self.inside = True
                return "/".join(parts[:stop])
        return beside


def _split(name: str) -> list[str]:
    return name.replace("\\", "/").split("/")


def _joined(folder: str, *more: str) -> str:
    """A path below a folder, without `.`, and without `..` where it can be undone; the folder is left as it is written."""
    parts = [] if folder in ("", ".") else folder.rstrip("/").split("/")
    for part in "/".join(more).split("/"):
        if part == ".." and parts and parts[-1] not in ("", ".."):
            parts.pop()
        elif part not in ("", "."):
            parts.append(part)
    return "/".join(parts) or "."


def _spelled(name: str, present: Sequence[str]) -> str | None:
    """A name as it is spelled in a folder, its case disregarded only if that leaves no choice."""
    if name in present:
        return name
    alike = [each for each in present if each.casefold() == name.casefold()]
    return alike[0] if len(alike) == 1 else None


@lru_cache(maxsize=64)
def _scanned(text: str, dialect: Dialect) -> Scan:
    return _scan(Document.parse(text, dialect), frozenset(said for _, said in names(text)))


def _scan(document: Document, said: frozenset[str]) -> Scan:
    brackets = tuple(document.brackets())
    counts = {
        line: tuple(name for name, _ in counters(document.node(line)))
        for line, bracket in brackets
        if bracket.kind == "loop" and bracket.role is Role.OPEN
    }
    last = document.line_count - 1
    return Scan(document, last + (document.line(last) != ""), brackets, counts, said)
