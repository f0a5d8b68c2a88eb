"""A template as its rules see it: sections, bodies in them, items in those, and every use of a word. Never reports anything."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

from deburr.rules.cgt._symbols import DECLARED_TYPES, Spelled, Symbols, Word
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.cgt.outline import brackets, section_name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, tokens

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.analysis import Analysis
    from deburr_grammar.line import LineNode

COMMANDS = frozenset(
    {"declaration", "eval", "macro", "call", "mark", "lookup", "fmt", "block", "returned", "if", "repeat"}
)
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


_LOST = Node("lost", 0, 0, ())
"""Marks a bracket behind a syntax fault: it counts, but what it is cannot be said."""


@dataclass(frozen=True, slots=True)
class Item:
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
    before: Item | Body | None = None
    """What stands before the bracket, or before its head."""
    parts: list[Item | Body] = field(default_factory=list)
    closer: Item | None = None

    def items(self) -> Iterator[Item]:
        """What stands directly in it."""
        return (part for part in self.parts if isinstance(part, Item))

    def walk(self, around: tuple[Body, ...] = ()) -> Iterator[tuple[Item, tuple[Body, ...]]]:
        """Every item with the bodies around it, outermost first."""
        waiting: list[tuple[Item | Body, tuple[Body, ...]]] = [(self, around)]
        while waiting:
            part, bodies = waiting.pop()
            if isinstance(part, Item):
                yield part, bodies
            else:
                waiting += [(inner, (*bodies, part)) for inner in reversed(part.parts)]

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


class Use(NamedTuple):
    """A `#word` in the text. ``role``: output, argument, target, format, macro or declared."""

    line: int
    span: Span
    said: str
    role: str
    spelled: Spelled
    section: Section


class Declaration(NamedTuple):
    """A name in a declaration, with the type's command."""

    line: int
    span: Span
    name: str
    command: str
    inside: bool


class Template:
    """All of it, read once for each version of a program."""

    def __init__(self, analysis: Analysis) -> None:
        self.lines = tuple(_read_lines(analysis))
        self.declarations = [found for line, node in self.lines for found in _declarations(line, node)]
        words = [
            Word(d.name, DECLARED_TYPES[d.command], not d.command.startswith("CALC"))
            for d in reversed(self.declarations)
        ]
        machine = _machine(analysis)
        self.machine_tables = frozenset(machine["tables"])
        self.symbols = Symbols({word.name: word for word in words}, machine["words"])
        self.uses: list[Use] = []
        self.sections = self._sections()
        self.by_name = {section.name: section for section in reversed(self.sections) if not section.faulty}
        self.faulty_lines = frozenset(line for line, node in self.lines if node.problems)

    def items(self) -> Iterator[tuple[Item, Section, tuple[Body, ...]]]:
        """Every item of every section that is no table, with the bodies around it."""
        for section in self.sections:
            for item, around in section.body.walk():
                yield item, section, around

    def calls(self) -> Iterator[tuple[Item, Section]]:
        """Every `#CALL` and `#GOTO` with the section it stands in; its target is `target(item)`."""
        return ((item, section) for item, section, _ in self.items() if item.kind == "call")

    def _sections(self) -> list[Section]:
        found: list[Section] = []
        builder: _Builder | None = None
        for line, node in self.lines:
            if node.reading.name == "header":
                name, span = section_name(node)
                if node.text.rstrip(" \t").partition("//")[0].rstrip(" \t") != "@":
                    found.append(Section(name, line, span, faulty=bool(node.problems)))
                    builder = _Builder(found[-1].body)
            elif found and builder is not None:
                found[-1].reading = node.reading.name
                if node.reading.name == "table":
                    found[-1].rows += _rows(line, node)
                else:
                    builder.add(self._items(line, node, found[-1]))
        return found

    def _items(self, line: int, node: LineNode, section: Section) -> Iterator[Item]:
        for kind, start, end, part in _raw(node):
            text = node.text[start:end]
            if part is _LOST:
                yield Item(kind, line, start, end, text, "?")
                continue
            if part is not None:
                self.uses += self._uses_in(line, node, part, section)
            if kind == "word":
                yield from self._spelled(Item(kind, line, start, end, text), section)
            else:
                yield Item(kind, line, start, end, text, _name(kind, text), part)

    def _spelled(self, item: Item, section: Section) -> Iterator[Item]:
        spelled = self.symbols.spell(item.text[1:], True)
        self.uses.append(Use(item.line, item.span, item.text[1:], "output", spelled, section))
        end = item.end - len(spelled.rest)
        kind = {
            "AND": "operator",
            "OR": "operator",
            "EXC": "operator",
            "ELSE": "else",
            "EXIT": "exit",
            "EXITC": "exit",
            "ONBLK": "onblk",
        }
        found = kind.get(spelled.name, "word") if spelled.kind == "command" else "word"
        yield Item(found, item.line, item.start, end, item.text[: end - item.start], spelled.name)
        if spelled.rest:
            yield Item("text", item.line, end, item.end, spelled.rest)

    def _uses_in(self, line: int, node: LineNode, part: Node, section: Section) -> Iterator[Use]:
        for token, role in _words(part):
            said = node.text[token.start + 1 : token.end]
            yield Use(line, Span(token.start, token.end), said, role, self.symbols.spell(said, False), section)


_templates: WeakKeyDictionary[Analysis, Template] = WeakKeyDictionary()


def template_of(analysis: Analysis) -> Template:
    """The template of an analysis, built when it is first asked for."""
    found = _templates.get(analysis)
    if found is None:
        found = _templates[analysis] = Template(analysis)
    return found


def target(item: Item) -> tuple[str, Span]:
    """The section that a `#CALL`, `#GOTO` or `#TABLE` names."""
    assert item.node is not None
    token = next(part for part in item.node.children if part.kind == "SECTION")
    return item.text[token.start - item.start : token.end - item.start], Span(token.start, token.end)


class _Builder:
    """Puts the items of a section into bodies: depth decides what belongs together, as it does for the structure."""

    def __init__(self, body: Body) -> None:
        self._stack = [body]
        self._head: Item | None = None

    def add(self, items: Iterator[Item]) -> None:
        for item in items:
            if item.kind == "open":
                self._open(item)
            elif item.kind == "close":
                if len(self._stack) > 1:
                    self._stack.pop().closer = item
                self._head = None
            else:
                self._stack[-1].parts.append(item)
                waits = self._head is not None and self._head.kind != "if" and (item.blank or item.kind == "comment")
                if not waits:
                    self._head = item if item.kind in ("if", "else", "repeat") else None

    def _open(self, item: Item) -> None:
        parts = self._stack[-1].parts
        head, self._head = self._head, None
        kind = "unknown" if item.name == "?" else head.kind if head else "bracket"
        at = len(parts) if head is None else parts.index(head)
        body = Body(kind, item, head, parts[at - 1] if at else None)
        parts.append(body)
        self._stack.append(body)


def _read_lines(analysis: Analysis) -> Iterator[tuple[int, LineNode]]:
    for piece in analysis.document.pieces():
        for index in range(piece.lines):
            node = piece.node(index)
            if node.reading.start is not None:
                yield piece.line + index, node


@lru_cache(maxsize=16_384)
def _raw(node: LineNode) -> tuple[tuple[str, int, int, Node | None], ...]:
    """The items of a line without its number: kind, columns, the command's node."""
    found: list[tuple[str, int, int, Node | None]] = []
    for part in node.tree.children:
        if isinstance(part, Token):
            if part.kind in _TOKENS:
                found.append((_TOKENS[part.kind], part.start, part.end, None))
            elif part.kind != "SEPARATOR":
                break  # A command that a fault cut short: its words are not output.
        elif part.kind == "if":
            found += [("if", part.start, part.end - 1, part), ("open", part.end - 1, part.end, None)]
        elif part.kind in COMMANDS:
            found.append((part.kind, part.start, part.end, part))
    if node.problems:
        known = {start for _, start, _, _ in found}
        lost = [bracket for bracket in brackets(node) if bracket.span.start not in known]
        found += [("open" if bracket.role is Role.OPEN else "close", *bracket.span, _LOST) for bracket in lost]
    return tuple(found)


def _name(kind: str, text: str) -> str:
    return text.partition("(")[0].lstrip("#").upper() if text.startswith("#") and kind != "text" else ""


def _words(part: Node) -> Iterator[tuple[Token, str]]:
    """The `#words` in a command with their roles."""
    first = {"eval": "target", "macro": "macro", "fmt": "format"}.get(part.kind)
    for child in part.children:
        if isinstance(child, Node):
            yield from _words(child)
        elif child.kind == "WORD":
            yield child, "declared" if part.kind == "declaration" else first or "argument"
        if isinstance(child, Node) or child.kind in ("WORD", "NUMBER", "NAME", "EQUAL"):
            first = None


def _rows(line: int, node: LineNode) -> Iterator[Row]:
    """The row on a line of a table; one with a fault is counted too, so that the rows behind it keep their numbers."""
    if node.problems:
        yield Row(line, node.tree, node.text)
    yield from (Row(line, row, node.text) for row in node.tree.nodes() if row.kind == "row")


def _declarations(line: int, node: LineNode) -> Iterator[Declaration]:
    command = ""
    for token in tokens(node.tree) if "DECLARE" in node.kinds else ():
        said = node.text[token.start + 1 : token.end]
        if token.kind == "DECLARE":
            command = said.upper()
        elif command and token.kind == "WORD":
            yield Declaration(line, Span(token.start, token.end), said, command, node.reading.name == "declare")
        elif token.kind != "DECLARE_COMMA":
            command = ""


def _machine(analysis: Analysis) -> dict[str, dict[str, Any]]:
    """The words and tables of the machine file; one that cannot be read has none."""
    path = analysis.settings.get("machine") or ""
    text = analysis.host.read(path) if path else None
    try:
        read = tomllib.loads(text or "")
    except tomllib.TOMLDecodeError:
        read = {}
    tables = {key: value if isinstance(value := read.get(key), dict) else {} for key in ("words", "tables")}
    return {**tables, "words": {name: kind for name, kind in tables["words"].items() if isinstance(kind, str)}}
