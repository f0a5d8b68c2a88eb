"""What a dialect is: a frozen value of choices. Nothing outside a dialect's own folders asks for its name.

A dialect folder holds `line.lark` (the whole-line grammar), `codes.toml` and
`variables.toml` (the tables), and an `__init__.py` whose `DIALECT` is the value.
"""

import re
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from deburr_grammar.codes import CodeTable
from deburr_grammar.grammar import Grammar
from deburr_grammar.problem import Problem, SyntaxFault
from deburr_grammar.shape import Folding
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr_grammar.layout import Layout
    from deburr_grammar.line import LineNode


class Reading(NamedTuple):
    """One way to read a line. ``start`` is a start rule of the grammar; None: the text is not read at all (never executed, or free text)."""

    name: str
    start: str | None


class Role(Enum):
    """What a bracket does to the structure of a program."""

    OPEN = "opens a block"
    CLOSE = "closes a block"
    MIDDLE = "stands directly in a block"
    REGION = "starts a region: blocks do not reach into or out of it"
    END_REGION = "ends a region"


@dataclass(frozen=True, slots=True)
class Bracket:
    """An opener, a closer or a boundary on a line.

    ``kind`` is the kind of block or region ("if", "sub"), the same for all its brackets;
    ``word`` is the canonical spelling of this one ("endif"); ``label`` ties it to its other
    end (None: only the run knows it, it matches any).
    """

    role: Role
    kind: str
    word: str
    label: str | None
    span: Span


class Step(NamedTuple):
    """What a line does: how it is read, which brackets it holds, and the state behind it."""

    reading: Reading
    brackets: Sequence[Bracket]
    state: Hashable


class Outline(Protocol):
    """How the lines of a dialect's programs hang together.

    Only lines whose shape matches ``marks`` are shown to ``step``; all others are read as
    the state says and change nothing. ``facts`` gathers, from a stretch of text, what the
    fold must know of the whole document (names of tables, say); facts of stretches are united.
    """

    marks: str
    needs_depth: str

    def facts(self, text: str) -> frozenset[str]:
        """What a stretch of whole lines says about the document as a whole."""

    def start(self, facts: frozenset[str]) -> Hashable:
        """The state before the first line."""

    def reading(self, state: Any) -> Reading:
        """How an unmarked line is read."""

    def step(self, state: Any, depth: int, facts: frozenset[str], read: "Callable[[Reading], LineNode]") -> Step:
        """What a marked line does. ``depth`` counts the blocks open in its region; it is only to be relied on by lines that match ``needs_depth``."""


class Effect(NamedTuple):
    """What a line does to modal state; it must hang on the line's shape alone.

    ``codes``: its codes in their canonical spelling, and the letters of other words that stay in
    force. ``arrives``: a jump can end here, so nothing is known before it. ``leaves``: text
    elsewhere runs before the next line, or codes that only the run knows. ``maybe``: whether the
    line runs at all is the operator's choice. ``unsets``: groups that hold nothing behind it,
    unless a code of the line sets them.
    """

    codes: tuple[str, ...] = ()
    arrives: bool = False
    leaves: bool = False
    maybe: bool = False
    unsets: tuple[str, ...] = ()


class Modality(NamedTuple):
    """How a dialect's lines change modal state. Blocks of the kinds in ``once`` run at most once each time they are reached; all others may be loops."""

    effect: "Callable[[LineNode], Effect]"
    once: frozenset[str] = frozenset()


class Kind(Enum):
    """The types a setting can have in the configuration file."""

    TEXT = "text"
    CHOICE = "one of several words"
    LIST = "a list of texts"
    TABLE = "a table"
    PATH = "a file or folder"
    PATHS = "a list of files or folders"
    FLAG = "true or false"
    WIDTH = "a number of blanks"
    NUMBER = "a number"


class Setting(NamedTuple):
    """A key of the dialect's table in `deburr.toml`."""

    name: str
    kind: Kind
    default: Any
    text: str
    choices: tuple[str, ...] = ()
    each: Callable[[str, Any], str] | None = None
    """What is wrong (nothing: "") with a key of a table and its value, with an item of a list (and None), or with the setting's name and its text."""
    found: tuple[str, ...] = ()
    """How the files that it may name are called, as patterns; of folders with a slash behind. `deburr init` looks for them."""


def letters(known: str) -> Callable[[str, Any], str]:
    """What is wrong with a setting that names some of these letters, each once, in either case."""

    def wrong(name: str, value: str) -> str:
        said = value.upper()
        strange = next((letter for letter in said if letter not in known), None)
        if strange is not None:
            return f"`{name}` names `{strange}`, which is no axis; these can be: {known}"
        twice = next((letter for letter in said if said.count(letter) > 1), None)
        return "" if twice is None else f"`{name}` names `{twice}` twice"

    return wrong


class Evidence(NamedTuple):
    """A pattern that only this dialect's programs show; ``text`` says in words what it is."""

    pattern: str
    text: str


@dataclass(frozen=True, eq=False)
class Dialect:
    """One language in which G-code is programmed."""

    name: str
    title: str
    package: str
    extensions: tuple[str, ...]
    readings: tuple[Reading, ...]
    folding: Folding
    outline: Outline
    diagnose: Callable[[SyntaxFault], Problem]
    """Turns the parser's fault into the Problem that the reference names."""
    words: Mapping[str, str]
    """Terminal names in the user's words: `NUMBER` is "a number"."""
    comments: tuple[tuple[str, str], ...]
    """Pairs of signs that start and end a comment; an empty end means the end of the line."""
    frame: str
    """The smallest clean program; `{}` is where a rule's example goes."""
    evidence: tuple[Evidence, ...] = ()
    line_number: str = ""
    """A pattern, in small letters, of what a program writes to read the number of its own line; "": it cannot."""
    settings: tuple[Setting, ...] = ()
    file_ends_region: bool = False
    """Whether the end of the file ends a region as well as its own end does."""
    blanks: str = " \t"
    """Characters that may stand between words; all else of a line is in its tree."""
    modality: Modality | None = None
    """None: modal state is not followed."""
    given: Callable[[Mapping[str, Any], Callable[[str], str | None]], frozenset[str]] = lambda settings, read: (
        frozenset()
    )
    """Facts for the outline from files that the settings name, each read by its path (None: there is no such file)."""

    @property
    def starts(self) -> tuple[str, ...]:
        """The start rules of the line grammar."""
        return tuple(dict.fromkeys(reading.start for reading in self.readings if reading.start))

    @cached_property
    def grammar(self) -> Grammar:
        """The line grammar."""
        return Grammar(self.package, self.starts)

    @cached_property
    def codes(self) -> CodeTable:
        """The tables."""
        return CodeTable(self.package)

    @cached_property
    def layout(self) -> "Layout":
        """What a formatter may do with its lines: `layout.py` of its folder; without one no line is touched. Only formatting loads it."""
        from deburr_grammar.layout import UNTOUCHED

        if find_spec(f"{self.package}.layout") is None:
            return UNTOUCHED
        found: Layout = import_module(f"{self.package}.layout").LAYOUT
        return found

    def expected(self, terminals: Iterable[str]) -> tuple[str, ...]:
        """An expected set in the user's words, each once, in the order of ``words``."""
        names = set(terminals)
        return tuple(dict.fromkeys(said for name, said in self.words.items() if name in names))

    @cached_property
    def marks(self) -> re.Pattern[str]:
        """Which shapes the outline must see."""
        return re.compile(self.outline.marks)

    @cached_property
    def needs_depth(self) -> re.Pattern[str]:
        """Which shapes ask how deep they stand."""
        return re.compile(self.outline.needs_depth or "(?!)")
