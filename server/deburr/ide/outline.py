"""The parts of a program as a tree: regions, blocks, and what is defined in them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from deburr.blocks import scopes
from deburr.symbols import Act, Sort, language_of
from deburr.symbols.index import all_symbols, mentions_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.blocks import Scope
    from deburr.ide.view import View
    from deburr_grammar.document import Document

_MOST = 5_000


@dataclass(eq=False)
class Part:
    """A part of a program: its name, what it is, its lines (both included), the place of its name."""

    name: str
    sort: Sort
    first: int
    last: int
    span: Span
    parts: list[Part] = field(default_factory=list)


def outline(view: View) -> list[Part]:
    """The parts of a program, outermost first."""
    document = view.document
    found = [*_regions(document), *_defined(view)]
    return nested(sorted(found, key=lambda part: (part.first, -part.last, part.span))[:_MOST])


def nested(parts: Iterable[Part]) -> list[Part]:
    """Parts in the order of their lines as a tree: each in the smallest one that holds it."""
    top: list[Part] = []
    around: list[Part] = []
    for part in parts:
        while around and around[-1].last < part.first:
            around.pop()
        if around and part.last <= around[-1].last:
            around[-1].parts.append(part)
        else:
            top.append(part)
        if part.last > part.first:
            around.append(part)
    return top


def _regions(document: Document) -> Iterator[Part]:
    for scope in scopes(document.brackets()):
        if scope.start is not None:
            yield _region(scope, document)
        for block in scope.blocks:
            opener, closer = block.opener, block.closer
            if opener.bracket.label is not None and closer is not None and closer.line > opener.line:
                bracket = opener.bracket
                yield Part(f"{bracket.word} {bracket.label}", Sort.LABEL, opener.line, closer.line, bracket.span)


def _region(scope: Scope, document: Document) -> Part:
    assert scope.start is not None
    line, bracket = scope.start
    last = scope.end.line if scope.end is not None else document.line_count - 1
    sort = Sort.SECTION if bracket.word.startswith("@") else Sort.SUB
    return Part(bracket.label or document.line(line).strip() or bracket.word, sort, line, max(line, last), bracket.span)


def _defined(view: View) -> Iterator[Part]:
    """What is defined on a line of its own: declared words, sections without an end, labels that something jumps to."""
    document, language = view.document, language_of(view.dialect.name)
    regions = {line for line, bracket in document.brackets()}
    sections = []
    for symbol in all_symbols(document) if language is not None else ():
        if symbol.local or symbol.sort not in (Sort.VARIABLE, Sort.SECTION, Sort.LABEL):
            continue
        mentions = list(mentions_of(document, symbol))
        if symbol.sort is Sort.LABEL and not any(each.mention.act is Act.CALL for each in mentions):
            continue
        for each in mentions:
            if each.mention.act is Act.DEFINE and each.line not in regions and language is not None:
                part = Part(language.written(symbol), symbol.sort, each.line, each.line, each.mention.span)
                sections += [part] if symbol.sort is Sort.SECTION else []
                yield part
    _stretch(sections, document.line_count)


def _stretch(sections: list[Part], lines: int) -> None:
    """A section without an end goes on to the next one."""
    sections.sort(key=lambda part: part.first)
    for part, following in zip(sections, [each.first for each in sections[1:]] + [lines]):
        part.last = max(part.first, following - 1)
