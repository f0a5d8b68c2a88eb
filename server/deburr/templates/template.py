"""A template: sections, bodies in them, items in those, and every use of a word. Never reports anything, never opens a file."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import FEW, paced
from deburr.templates.items import (
    LOST,
    Body,
    Builder,
    Declaration,
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
    from collections.abc import Generator, Iterator, Mapping, Sequence

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


def template_in(
    document: Document, machine: Machine, given: Mapping[str, str] | None = None
) -> Generator[None, None, Template]:
    """A template, read in steps. ``machine`` is what its machine file says; ``given`` are values for this run by their names, which makes words of names that nothing declares."""
    lines: list[tuple[int, LineNode]] = []
    declarations: list[Declaration] = []
    for piece in document.pieces():
        for index in range(piece.lines):
            node = piece.node(index)
            if node.reading.start is not None:
                line = piece.line + index
                lines.append((line, node))
                declarations += declarations_of(line, node)
        yield
    template = Template(lines, declarations, machine, given or {})
    yield from template.gathering()
    return template


class Template:
    """All of it, read once for each version of a program."""

    def __init__(
        self,
        lines: Sequence[tuple[int, LineNode]],
        declarations: Sequence[Declaration],
        machine: Machine,
        given: Mapping[str, str],
    ) -> None:
        self.lines = lines
        self.declarations = declarations
        words = [
            Word(d.name, DECLARED_TYPES[d.command], not d.command.startswith("CALC")) for d in reversed(declarations)
        ]
        self.machine = machine
        self.given = {name.strip().removeprefix("#"): said for name, said in given.items()}
        known = {
            name: Word(name, "decimal" if is_number(said) else "string", True) for name, said in self.given.items()
        }
        self.symbols = Symbols(known | {word.name: word for word in words}, machine.words)
        self.uses: list[Use] = []
        self.items: list[Placed] = []
        """Every item of every section that is no table."""
        self.bodies: list[Body] = []
        """Every body of every section, the sections' own included."""
        self.faulty: list[LineNode] = []
        """The lines that cannot be read to their end."""
        self.sections: list[Section] = []
        self.by_name: dict[str, Section] = {}
        self.faulty_lines: frozenset[int] = frozenset()
        self._texts: dict[int, str] = {}
        self._by_kind: dict[str, list[Placed]] = {}

    def gathering(self) -> Iterator[None]:
        """Find what its sections hold, in steps."""
        faulty: list[int] = []
        builder: Builder | None = None
        for each in paced(self.lines, FEW):
            if each is None:
                yield
                continue
            line, node = each
            self._texts[line] = node.text
            if node.problems:
                faulty.append(line)
                self.faulty.append(node)
            builder = self._add(line, node, builder)
        self.faulty_lines = frozenset(faulty)
        self.by_name = {section.name: section for section in reversed(self.sections) if not section.faulty}

    @cached_property
    def named_in_faults(self) -> frozenset[str]:
        """Names on lines that cannot be read to their end: what such a line does with them is not known."""
        return frozenset(name for node in self.faulty for name in _NAME.findall(node.text))

    @cached_property
    def presumed(self) -> frozenset[str]:
        """Names that `@DECLARE` holds without declaring them, because a comma, a sign or the type before them is wrong."""
        lines = {use.line: use for use in reversed(self.uses) if use.section.reading == "declare"}
        loose = {use.said for use in self.uses if use.role == "output" and _declares(lines.get(use.line))}
        faulty = (node.text for node in self.faulty if node.reading.name == "declare")
        return frozenset(loose | {name for text in faulty for name in _NAME.findall(text)})

    def of(self, *kinds: str) -> Iterator[Placed]:
        """The items of these kinds."""
        return (placed for kind in kinds for placed in self._by_kind.get(kind, ()))

    def calls(self) -> Iterator[tuple[Item, Section]]:
        """Every `#CALL` and `#GOTO` with the section it stands in; its target is `target(item)`."""
        return ((placed.item, placed.section) for placed in self.of("call"))

    def text(self, line: int) -> str:
        """A line's text."""
        return self._texts[line]

    def _add(self, line: int, node: LineNode, builder: Builder | None) -> Builder | None:
        """Take a line in; what takes in the next one."""
        if node.reading.name == "header":
            name, span = section_name(node)
            if node.text.rstrip(" \t").partition("//")[0].rstrip(" \t") != "@":
                return self._begin(Section(name, line, span, faulty=bool(node.problems)))
        elif self.sections and builder is not None:
            section = self.sections[-1]
            section.reading = node.reading.name
            if node.reading.name == "table":
                section.rows += rows_of(line, node)
            else:
                builder.add(self._items(line, node, section))
        return builder

    def _begin(self, section: Section) -> Builder:
        self.sections.append(section)
        self.bodies.append(section.body)

        def place(item: Item, body: Body) -> None:
            placed = Placed(item, section, body)
            self.items.append(placed)
            self._by_kind.setdefault(item.kind, []).append(placed)

        return Builder(section.body, place, self.bodies.append)

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
