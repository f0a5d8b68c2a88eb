"""The items of template lines and the bodies they stand in. Never looks at what a word means, never reports anything."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple
from weakref import ref

from deburr_grammar.dialect import Role
from deburr_grammar.dialects.cgt.outline import brackets, misspelt_tests
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, tokens

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from deburr_grammar.line import LineNode

COMMANDS = frozenset(
    {"declaration", "eval", "macro", "call", "mark", "lookup", "fmt", "block", "returned", "if", "repeat"}
)
DEEPEST = 32
"""How deep brackets may nest (spec/cgt.md §8)."""
_TOKENS = {
    "TEXT": "text",
    "WORD": "word",
    "LT": "open",
    "GT": "close",
    "OPERATOR": "operator",
    "ELSE": "else",
    "EXIT": "exit",
    "EXITC": "exit",
    "ONBLK": "onblk",
    "COMMENT": "comment",
}


LOST = Node("lost", 0, 0, ())
"""Marks a bracket behind a syntax fault: it counts, but what it is cannot be said."""


class Item(NamedTuple):
    """A part of a template line. ``kind``: text, word, open, close, operator, else, exit, onblk, comment, or the name of a command's node."""

    kind: str
    line: int
    start: int
    end: int
    text: str
    name: str = ""
    node: Node | None = None

    @property
    def span(self) -> Span:
        """Its columns."""
        return Span(self.start, self.end)

    @property
    def blank(self) -> bool:
        """Whether it is text of blanks only."""
        return self.kind == "text" and not self.text.strip(" \t")

    @property
    def printed(self) -> bool:
        """Whether it puts something other than blanks on the output line."""
        if self.kind == "block":
            return self.name == "GETBLK"
        return self.kind in ("word", "lookup") or (self.kind == "text" and not self.blank)


@dataclass(eq=False)
class Body:
    """What stands between two brackets, or in a section. ``kind``: section, bracket (tested), if, else, repeat, or unknown behind a syntax fault."""

    kind: str
    opener: Item | None = None
    head: Item | None = None
    """The `#IF`, `#ELSE` or `#REPEAT` in front."""
    parent: ref[Body] | None = None
    """What it stands in: whoever asks has that. Weak, so that a template goes with its last user, without a look for garbage."""
    depth: int = 0
    parts: list[Item | Body] = field(default_factory=list)
    closer: Item | None = None

    def items(self) -> Iterator[Item]:
        """What stands directly in it."""
        return (part for part in self.parts if isinstance(part, Item))

    def around(self) -> Iterator[Body]:
        """The bodies around it, innermost first."""
        body = self
        while body.parent is not None and (outer := body.parent()) is not None:
            yield outer
            body = outer

    def bodies(self) -> Iterator[Body]:
        """All bodies in it, itself first."""
        waiting = [self]
        while waiting:
            body = waiting.pop()
            yield body
            waiting += [part for part in reversed(body.parts) if isinstance(part, Body)]


class Row(NamedTuple):
    """A row of a table section."""

    line: int
    node: Node
    text: str


@dataclass
class Section:
    """A section: its name, the columns of its header, how it is read, and what it holds."""

    name: str
    line: int
    span: Span
    reading: str = "template"
    faulty: bool = False
    body: Body = field(default_factory=lambda: Body("section"))
    rows: list[Row] = field(default_factory=list)

    @property
    def is_table(self) -> bool:
        """Whether its lines are rows."""
        return self.reading == "table"


class Declaration(NamedTuple):
    """A name in a declaration, with the type's command."""

    line: int
    span: Span
    name: str
    command: str
    inside: bool


class Builder:
    """Puts the items of a section into bodies: depth decides what belongs together, as it does for the structure."""

    def __init__(
        self,
        body: Body,
        placed: Callable[[Item, Body], object] = lambda item, body: None,
        opened: Callable[[Body], object] = lambda body: None,
    ) -> None:
        """``placed`` is told of each item with the body that it stands directly in, ``opened`` of each body, in order."""
        self._stack = [body]
        self._placed, self._opened = placed, opened
        self._head: Item | None = None
        self._behind = ""
        """The text behind a command that nobody knows, which may be its arguments."""

    def add(self, items: Iterator[Item]) -> None:
        """Put the items of a line where they belong."""
        for item in items:
            if item.kind == "open":
                self._open(item)
            elif item.kind == "close":
                if len(self._stack) > 1:
                    self._stack.pop().closer = item
                self._head = None
            elif item.kind == "head":
                self._head, self._behind = item, ""
            else:
                self._stack[-1].parts.append(item)
                self._placed(item, self._stack[-1])
                if not self._waits(item):
                    self._head = item if item.kind in ("if", "else", "repeat") else None

    def _waits(self, item: Item) -> bool:
        """Whether a body may still follow what stands before the item."""
        if self._head is None or self._head.kind == "if":
            return False
        if self._head.kind == "head" and item.kind in ("text", "word"):
            self._behind += item.text
            return re.fullmatch(r"[ \t]*|\([^()]*\)?", self._behind) is not None
        return item.blank or item.kind == "comment"

    def _open(self, item: Item) -> None:
        parts = self._stack[-1].parts
        head, self._head = self._head, None
        doubtful = item.name == "?" or (head is not None and head.kind == "head")
        if head is not None and head.kind == "head":
            # A word that nobody knows may be a command; one with a body has it on its own line.
            doubtful, head = doubtful and (head.name == "?" or head.line == item.line), None
        kind = "unknown" if doubtful else head.kind if head else "bracket"
        body = Body(kind, item, head, ref(self._stack[-1]), len(self._stack))
        parts.append(body)
        self._opened(body)
        self._stack.append(body)


@lru_cache(maxsize=4_096)
def raw_items(node: LineNode) -> tuple[tuple[str, int, int, Node | None], ...]:
    """The items of a line without its number: kind, columns, the command's node."""
    found: list[tuple[str, int, int, Node | None]] = []
    tests = misspelt_tests(node.text)
    for part in node.tree.children:
        if isinstance(part, Token):
            if part.kind in ("LT", "GT") and any(test.start < part.start < test.end for test in tests):
                continue
            if part.kind in _TOKENS:
                found.append((_TOKENS[part.kind], part.start, part.end, None))
            elif part.kind != "SEPARATOR":
                break  # A command that a fault cut short: its words are not output.
        elif part.kind == "if":
            found += [("if", part.start, part.end - 1, part), ("open", part.end - 1, part.end, None)]
        elif part.kind in COMMANDS:
            found.append((part.kind, part.start, part.end, part))
    if node.problems:
        found += [
            ("head", problem.start, problem.end, LOST) for problem in node.problems if problem.kind == "if-syntax"
        ]
        known = {start for _, start, _, _ in found}
        lost = [bracket for bracket in brackets(node) if bracket.span.start not in known]
        found += [("open" if bracket.role is Role.OPEN else "close", *bracket.span, LOST) for bracket in lost]
    return tuple(found)


def name_of(kind: str, text: str) -> str:
    """A command's name in capitals; of other items nothing."""
    return text.partition("(")[0].lstrip("#").upper() if text.startswith("#") and kind != "text" else ""


def words_in(part: Node) -> Iterator[tuple[Token, str]]:
    """The `#words` in a command with their roles."""
    first = {"eval": "target", "macro": "macro", "fmt": "format"}.get(part.kind)
    for child in part.children:
        if isinstance(child, Node):
            yield from words_in(child)
        elif child.kind == "WORD":
            yield child, "declared" if part.kind == "declaration" else first or "argument"
        if isinstance(child, Node) or child.kind in ("WORD", "NUMBER", "NAME", "EQUAL"):
            first = None


def rows_of(line: int, node: LineNode) -> Iterator[Row]:
    """The row on a line of a table; one with a fault is counted too, so that the rows behind it keep their numbers."""
    if node.problems:
        yield Row(line, node.tree, node.text)
    yield from (Row(line, row, node.text) for row in node.tree.nodes() if row.kind == "row")


def declarations_of(line: int, node: LineNode) -> Iterator[Declaration]:
    """The names that a line declares, as far as it can be read."""
    command = ""
    for token in tokens(node.tree) if "DECLARE" in node.kinds else ():
        said = node.text[token.start + 1 : token.end]
        if token.kind == "DECLARE":
            command = said.upper()
        elif command and token.kind == "WORD":
            yield Declaration(line, Span(token.start, token.end), said, command, node.reading.name == "declare")
        elif token.kind != "DECLARE_COMMA":
            command = ""
