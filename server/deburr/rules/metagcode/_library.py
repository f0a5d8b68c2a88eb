"""The snippet files of a program: where they lie, what is in them, how they name each other. Never judges a program.

Each file is asked for and read at most once in an analysis, and none that lies deeper than
snippets may (`spec/metagcode.md` §5.1).
"""

from collections.abc import Generator, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.includes import Folder, Found, leaves
from deburr.rule import Note
from deburr.steps import done
from deburr_grammar.dialect import Bracket, Dialect, Role
from deburr_grammar.dialects.metagcode.forms import counters, names
from deburr_grammar.dialects.metagcode.limits import DEEPEST, LARGEST
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document
from deburr_grammar.text import Span


class Link(NamedTuple):
    """A `#FILE` line: the file and line in which it stands, the columns of the directive, the name in it."""

    file: str
    line: int
    span: Span
    name: str


class Scan(NamedTuple):
    """What a file says by itself: the text as it is read, its lines, its brackets with their lines, what its loops count, and all names in it."""

    document: Document
    lines: int
    brackets: Sequence[tuple[int, Bracket]]
    counts: Mapping[int, tuple[str, ...]]
    names: frozenset[str]


def is_plain(name: str | None) -> bool:
    """Whether a name can be looked up at all; rules on lines report those that cannot."""
    return name is not None and "|" not in name and not leaves(name)


class Library:
    """The files around one analysis."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._folder = Folder(analysis.host, analysis.file, str(analysis.settings["snippets-dir"]))
        self._texts: dict[str, str] = {}
        self._longest: dict[tuple[str, int], tuple[Link, ...]] = {}
        self._ways: dict[str, Mapping[str, tuple[Link, ...]]] = {}
        self.file = analysis.file
        self.silent = self._folder.silent
        """Whether nothing is known of any file, so that nothing can be missed."""
        self.inside = self._folder.inside
        """Whether the program is itself a snippet."""
        self.root = self._folder.root

    def find(self, name: str) -> Found | None:
        """The file of a plain name; None if there is none, or several that differ from it in case only."""
        found = self._folder.find(name)
        if found is not None:
            self._texts[found.path] = found.text
        return found

    def near(self, name: str) -> Sequence[str]:
        """The names in the folder in which a name is looked for."""
        return self._folder.near(name)

    def target(self, bracket: Bracket) -> str | None:
        """The file that a `#FILE` line stands for; None if it is not to be had."""
        found = self.find(bracket.label) if bracket.label is not None and is_plain(bracket.label) else None
        return found.path if found is not None and not found.larger(LARGEST) else None

    def scan(self, path: str) -> Scan:
        """What is in a file that was found, or in the program itself."""
        return self.own if path == self.file else _scanned(self._texts[path], self._analysis.dialect)

    @cached_property
    def own(self) -> Scan:
        """What is in the program; names are not gathered, since nobody asks for those of a whole program."""
        return done(self._own())

    def reading(self) -> Iterator[None]:
        """Read the program, in steps."""
        if "own" not in self.__dict__:
            self.own = yield from self._own()

    def _own(self) -> Generator[None, None, Scan]:
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


@lru_cache(maxsize=64)
def _scanned(text: str, dialect: Dialect) -> Scan:
    return done(_scan(Document.parse(text, dialect), frozenset(said for _, said in names(text))))


def _scan(document: Document, said: frozenset[str]) -> Generator[None, None, Scan]:
    brackets: list[tuple[int, Bracket]] = []
    counts: dict[int, tuple[str, ...]] = {}
    for piece in document.pieces():
        for index, bracket in piece.outlined.brackets:
            brackets.append((piece.line + index, bracket))
            if bracket.kind == "loop" and bracket.role is Role.OPEN:
                counts[piece.line + index] = tuple(name for name, _ in counters(piece.node(index)))
        yield
    last = document.line_count - 1
    return Scan(document, last + (document.line(last) != ""), brackets, counts, said)
