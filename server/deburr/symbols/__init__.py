"""What lines mention: variables, subprograms, labels, sections, files, codes. Languages are modules named after their dialects; none knows another."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterator
from enum import Enum
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.codes import CodeTable, Entry
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode
    from deburr_grammar.text import Span


class Act(Enum):
    """What a mention does with what it names."""

    DEFINE = "defines it"
    SET = "gives it a value"
    READ = "uses its value"
    CALL = "goes there"
    SAY = "says it"


class Sort(Enum):
    """What can be named. The value is the word for it."""

    VARIABLE = "variable"
    SUB = "subprogram"
    LABEL = "label"
    SECTION = "section"
    FILE = "file"
    CODE = "code"
    WORD = "word"
    FUNCTION = "function"
    KEYWORD = "keyword"


class Offer(Enum):
    """Names of a program that can be offered where something is to be written."""

    VARIABLES = "variables"
    SUBS = "subprograms"
    LABELS = "labels"
    SECTIONS = "sections"
    FILES = "files"
    ENDS = "ends of open blocks"


class Symbol(NamedTuple):
    """A thing that has a name. ``name`` is spelled in the one way in which names are compared; ``local``: each region has its own."""

    sort: Sort
    name: str
    local: bool = False
    table: str = ""
    """The table of the dialect that may say more of it."""


SOUGHT = frozenset((Sort.VARIABLE, Sort.WORD, Sort.SUB, Sort.LABEL, Sort.SECTION, Sort.FILE))
"""What is looked for in a whole program; the rest is the language's own and stands everywhere."""


class Mention(NamedTuple):
    """A place of a line where a symbol is named: all of it, and the bare name in it."""

    symbol: Symbol
    act: Act
    span: Span
    inner: Span
    passing: bool = False
    """Whether it is one of so many alike that nobody looks for it: the axis of a move."""


class Meant(NamedTuple):
    """What a word stands for where it stands, and what sort of meaning that is."""

    text: str
    kind: str


class Called(NamedTuple):
    """A call that is being written: the subprogram, its column, how many arguments stand before the place."""

    symbol: Symbol
    col: int
    given: int


class Takes(NamedTuple):
    """How a subprogram is called: its signature, the columns of its arguments there, what is said of it."""

    label: str
    items: tuple[tuple[int, int], ...]
    text: str


class Language(Protocol):
    """What a dialect's module knows.

    ``NAMING``: the kinds of nodes and tokens without which a line names nothing that is looked for.
    ``SHARED``: who shares a variable that is nobody's own. ``SET`` and ``UNSET``: why the value of
    one is not known that some line sets, or none.
    """

    NAMING: frozenset[str]
    SHARED: str
    SET: str
    UNSET: str

    def names(self, document: Document) -> Hashable:
        """What the mentions of a line depend on besides the line; None: nothing."""

    def mentions(self, line: LineNode, names: Hashable) -> Iterator[Mention]:
        """What a line names."""

    def file(self, symbol: Symbol, file: str, ruleset: RuleSet, host: Host) -> str | None:
        """The file that a symbol leads to from a program, if it does and there is one."""

    def partial(self, before: str) -> int:
        """Where the word starts that is being written at the end of a text."""

    def offers(self, expected: frozenset[str], before: str, partial: str) -> Iterator[Offer | str]:
        """What can be written where the grammar expects these terminals: names of the program, tables, or one line of one (`command/AND`)."""

    def resumed(self, before: str) -> str:
        """A start of a line after which the same can follow as after this one, where only the end of the line tells how it is read."""

    def end(self, opener: Bracket) -> str:
        """What closes a block, as it is written; nothing where that is written within a line."""

    def files(self, file: str, ruleset: RuleSet, host: Host, before: str) -> Iterator[str]:
        """The names by which a program can call files behind the start of a line, as they are written."""

    def called(self, before: str) -> Called | None:
        """The call of a subprogram with arguments in which the start of a line ends."""

    def takes(self, document: Document, symbol: Symbol) -> Takes:
        """What a subprogram that a document defines is called with."""

    def spelled(self, entry: Entry) -> str:
        """A name of a table as it is written in a program; "" for a family of which no name is to be offered."""

    def valid(self, symbol: Symbol, name: str) -> str:
        """What is wrong with a name for such a symbol; nothing: ""."""

    def notes(self, document: Document, line: int, mention: Mention) -> Iterator[str]:
        """What more is known of a mention where it stands, in Markdown."""

    def meant(self, document: Document, line: int, mention: Mention) -> Meant | None:
        """What a mention stands for where that can be seen in the text."""

    def written(self, symbol: Symbol) -> str:
        """A symbol as it is written in a program."""


@cache
def language_of(dialect: str) -> Language | None:
    """The module of a dialect; None if it has none."""
    name = f"{__name__}.{dialect}"
    found: Language | None = import_module(name) if find_spec(name) is not None else None
    return found


_INDEXED = re.compile(r"([A-Za-z_]*)\[?([0-9]+)\]?")


def entry_of(symbol: Symbol, codes: CodeTable) -> Entry | None:
    """What the tables say of a symbol: under its name, or as one of a numbered family."""
    if not symbol.table:
        return None
    found = codes.entry(symbol.table, symbol.name)
    match = _INDEXED.fullmatch(symbol.name)
    if found is not None or match is None:
        return found
    number = int(match[2])
    families = [each for each in codes.table(symbol.table) if each.covers(number)]
    mine = [each for each in families if each.more.get("prefix", "") == match[1].upper()]
    return min(mine, key=lambda entry: (entry.last or 0) - (entry.first or 0), default=None)
