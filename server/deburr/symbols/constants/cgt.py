"""Values of CGT words that lines alone decide, and the rows of their tables (spec/cgt.md §5, §11)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.arithmetic.cgt import constant
from deburr.symbols import Sort, Symbol
from deburr.symbols.cgt import names as declared_names
from deburr.symbols.cgt import table_rows
from deburr.symbols.constants import Held, Length, Settings, count
from deburr.symbols.constants._unconfigured import counted, given, names, shown
from deburr.symbols.index import all_symbols
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.symbols import Mention
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

__all__ = ["assigned", "counted", "disturbed", "given", "lengths", "names", "results", "row", "shown"]

_NUMBERS = ("decimal", "integer")
_COMPUTED = frozenset(("sum", "product", "quotient", "power", "function"))
_NUMBERED = re.compile("[UV][0-9]{1,2}")


def assigned(document: Document, line: int, mention: Mention, settings: Settings) -> str | None:
    """The constant that `#EVAL` stores in a word of the user; the generator's own words change with each element."""
    name, node = mention.symbol.name, document.node(line)
    declared = dict(declared_names(document)).get(name)
    if declared not in _NUMBERS if declared is not None else not _NUMBERED.fullmatch(name):
        return None
    if Symbol(Sort.SECTION, f"${name}", table="section") in all_symbols(document, Sort.SECTION):
        return None
    for part in node.find("eval"):
        target = next((each for each in part.children if each.kind == "WORD"), None)
        if target is not None and target.start == mention.span.start and part.children[-2].kind != "EQUAL":
            value = constant(node.text, part.children[-2])
            return shown(value) if isinstance(value, float) else None
    return None


def disturbed(document: Document, first: int, last: int) -> bool:
    """A section is run from its first line on, and calls are named."""
    return False


def results(line: LineNode, settings: Settings) -> Iterator[tuple[Span, str]]:
    """Expressions with an operator or a function in them."""
    reached = 0
    for part in walk(line.tree) if not line.kinds.isdisjoint(_COMPUTED) else ():
        if part.start >= reached and isinstance(part, Node) and part.kind in _COMPUTED:
            value = constant(line.text, part)
            if isinstance(value, float):
                reached = part.end
                yield Span(part.start, part.end), shown(value)


def lengths(document: Document, line: int, held: Held, settings: Settings) -> Iterator[Length]:
    """Of `#REPEAT` with a count that is more than a number."""
    node = document.node(line)
    for part in node.find("repeat"):
        inner = part.children[2]
        value = constant(node.text, inner)
        if inner.kind == "WORD":
            known = held(line, node.text[inner.start + 1 : inner.end])
            value = float(known.first) if known is not None and known.plain is not None else None
        if (
            isinstance(value, float)
            and value == int(value)
            and not (isinstance(inner, Token) and inner.kind == "NUMBER")
        ):
            yield Length(Span(part.start, part.end), count(max(0, int(value))))


def row(document: Document, line: int, mention: Mention) -> str | None:
    """What `#TABLE(section, 2)` prints, and what a table word prints behind `#EVAL(#MOV=2)` or in a test `#MOV=2`."""
    node = document.node(line)
    for part in node.find("lookup", "eval", "test"):
        word = next((each for each in part.children if each.start == mention.span.start), None)
        number = next((each for each in part.children if each.kind == "NUMBER"), None)
        said = node.text[number.start : number.end] if number is not None else ""
        if word is not None and said.isdigit():
            return _printed(document, mention.symbol.name, int(said))
    return None


def _printed(document: Document, table: str, index: int) -> str | None:
    """A row of the section of that name; without one, of the codes that the system's tables have."""
    found = [prints for _, prints in table_rows(document, table)]
    if not found:
        entry = document.dialect.codes.entry("word", table)
        found = list(entry.more.get("codes", ())) if entry is not None else []
    return found[index] if index < len(found) else None
