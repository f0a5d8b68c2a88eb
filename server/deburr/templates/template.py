"""A template: sections, bodies in them, items in those, and every use of a word. Never reports anything, never opens a file."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.templates.items import (
    LOST,
    Body,
    Builder,
    Item,
    Section,
    declarations_of,
    name_of,
    raw_items,
    rows_of,
    words_in,
)
from deburr.templates.symbols import DECLARED_TYPES, Spelled, Symbols, Word
from deburr.templates.types import is_number
from deburr_grammar.dialects.cgt.outline import section_name
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from deburr.formats.machine import Machine
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode
    from deburr_grammar.tree import Node


class Placed(NamedTuple):
    """An item with its section and the body that it stands directly in."""

    item: Item
    section: Section
    body: Body


class Use(NamedTuple):
    """A `#word` in the text. ``role``: output, argument, target, format, macro or declared."""

    line: int
    span: Span
    said: str
    role: str
    spelled: Spelled
    section: Section


class Template:
    """All of it, read once for each version of a program.

    ``machine`` is what its machine file says; ``given`` are values for this run by their names, which makes words of names
    that nothing declares.
    """

    def __init__(self, document: Document, machine: Machine, given: Mapping[str, str] | None = None) -> None:
        self.lines = tuple(_read_lines(document))
        self.declarations = [found for line, node in self.lines for found in declarations_of(line, node)]
        words = [
            Word(d.name, DECLARED_TYPES[d.command], not d.command.startswith("CALC"))
            for d in reversed(self.declarations)
        ]
        self.machine = machine
        self.given = {name.strip().removeprefix("#"): said for name, said in (given or {}).items()}
        known = {
            name: Word(name, "decimal" if is_number(said) else "string", True) for name, said in self.given.items()
        }
        self.symbols = Symbols(known | {word.name: word for word in words}, machine.words)
        self.uses: list[Use] = []
        self.sections = self._sections()
        self.by_name = {section.name: section for section in reversed(self.sections) if not section.faulty}
        self.faulty_lines = frozenset(line for line, node in self.lines if node.problems)

    @cached_property
    def items(self) -> tuple[Placed, ...]:
        """Every item of every section that is no table."""
        bodies = ((section, body) for section in self.sections for body in section.body.bodies())
        found = (Placed(item, section, body) for section, body in bodies for item in body.items())
        return tuple(sorted(found, key=lambda placed: (placed.item.line, placed.item.start)))

    @cached_property
    def named_in_faults(self) -> frozenset[str]:
        """Names on lines that cannot be read to their end: what such a line does with them is not known."""
        faulty = (node.text for _, node in self.lines if node.problems)
        return frozenset(name for text in faulty for name in _NAME.findall(text))

    @cached_property
    def presumed(self) -> frozenset[str]:
        """Names that `@DECLARE` holds without declaring them, because a comma, a sign or the type before them is wrong."""
        lines = {use.line: use for use in reversed(self.uses) if use.section.reading == "declare"}
        loose = {use.said for use in self.uses if use.role == "output" and _declares(lines.get(use.line))}
        faulty = (node.text for _, node in self.lines if node.problems and node.reading.name == "declare")
        return frozenset(loose | {name for text in faulty for name in _NAME.findall(text)})

    @cached_property
    def bodies(self) -> tuple[Body, ...]:
        """Every body of every section, the sections' own included."""
        return tuple(body for section in self.sections for body in section.body.bodies())

    def of(self, *kinds: str) -> Iterator[Placed]:
        """The items of these kinds."""
        return (placed for kind in kinds for placed in self._by_kind.get(kind, ()))

    def calls(self) -> Iterator[tuple[Item, Section]]:
        """Every `#CALL` and `#GOTO` with the section it stands in; its target is `target(item)`."""
        return ((placed.item, placed.section) for placed in self.of("call"))

    def text(self, line: int) -> str:
        """A line's text."""
        return self._texts[line]

    @cached_property
    def _texts(self) -> dict[int, str]:
        return {line: node.text for line, node in self.lines}

    @cached_property
    def _by_kind(self) -> dict[str, list[Placed]]:
        found: dict[str, list[Placed]] = {}
        for placed in self.items:
            found.setdefault(placed.item.kind, []).append(placed)
        return found

    def _sections(self) -> list[Section]:
        found: list[Section] = []
        builder: Builder | None = None
        for line, node in self.lines:
            if node.reading.name == "header":
                name, span = section_name(node)
                if node.text.rstrip(" \t").partition("//")[0].rstrip(" \t") != "@":
                    found.append(Section(name, line, span, faulty=bool(node.problems)))
                    builder = Builder(found[-1].body)
            elif found and builder is not None:
                found[-1].reading = node.reading.name
                if node.reading.name == "table":
                    found[-1].rows += rows_of(line, node)
                else:
                    builder.add(self._items(line, node, found[-1]))
        return found

    def _items(self, line: int, node: LineNode, section: Section) -> Iterator[Item]:
        self.uses += self._uses_on(line, node, section)
        return items_of(line, node, self.symbols)

    def _uses_on(self, line: int, node: LineNode, section: Section) -> Iterator[Use]:
        for kind, start, end, part in raw_items(node):
            if part is not None and part is not LOST:
                yield from self._uses_in(line, node, part, section)
            elif kind == "word":
                said = node.text[start + 1 : end]
                yield Use(line, Span(start, end), said, "output", self.symbols.spell(said, True), section)

    def _uses_in(self, line: int, node: LineNode, part: Node, section: Section) -> Iterator[Use]:
        for token, role in words_in(part):
            said = node.text[token.start + 1 : token.end]
            yield Use(line, Span(token.start, token.end), said, role, self.symbols.spell(said, False), section)


def items_of(line: int, node: LineNode, symbols: Symbols) -> Iterator[Item]:
    """The items of a template line, words parted from the text that abuts them."""
    for kind, start, end, part in raw_items(node):
        text = node.text[start:end]
        if part is LOST:
            yield Item(kind, line, start, end, text, "?")
        elif kind == "word":
            yield from _spelled(Item(kind, line, start, end, text), symbols)
        else:
            yield Item(kind, line, start, end, text, name_of(kind, text), part)


def _spelled(item: Item, symbols: Symbols) -> Iterator[Item]:
    spelled = symbols.spell(item.text[1:], True)
    end = item.end - len(spelled.rest)
    found = _CONTROLS.get(spelled.name, "word") if spelled.kind == "command" else "word"
    yield Item(found, item.line, item.start, end, item.text[: end - item.start], spelled.name)
    if spelled.kind in ("unknown", "undeclared"):
        yield Item("head", item.line, item.start, end, item.text)
    if spelled.rest:
        yield Item("text", item.line, end, item.end, spelled.rest)


def _declares(first: Use | None) -> bool:
    """Whether a line of `@DECLARE` begins with a declaration, or with a word that may be a misspelt one."""
    return first is not None and (first.role == "declared" or first.spelled.kind == "unknown")


_CONTROLS = {
    **dict.fromkeys(("AND", "OR", "EXC"), "operator"),
    "ELSE": "else",
    "EXIT": "exit",
    "EXITC": "exit",
    "ONBLK": "onblk",
}
"""What a command without parentheses is where text abuts it."""
_NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")


def target(item: Item) -> tuple[str, Span]:
    """The section that a `#CALL`, `#GOTO` or `#TABLE` names."""
    assert item.node is not None
    token = next(part for part in item.node.children if part.kind == "SECTION")
    return item.text[token.start - item.start : token.end - item.start], Span(token.start, token.end)


def _read_lines(document: Document) -> Iterator[tuple[int, LineNode]]:
    for piece in document.pieces():
        for index in range(piece.lines):
            node = piece.node(index)
            if node.reading.start is not None:
                yield piece.line + index, node
