"""How templates of CGT are rebuilt (spec/cgt.md §5.5): lines become a section that is called; words are shared by all sections."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering, balanced, fresh_name
from deburr.symbols import Mention, Sort, Symbol
from deburr.symbols.index import all_symbols, region

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.line import LineNode

LINES: Numbering | None = None
BLOCKS: Numbering | None = None
EXTRACTED = "section"
MISSING: tuple[str, ...] = ()
_LEAVES = re.compile(r"(?i)#(?:EXITC?|GOTO)\b")


def line_numbers(line: LineNode) -> Iterator[Mention]:
    """Blocks are numbered as they are output."""
    yield from ()


def starts_section(line: LineNode) -> bool:
    """It does not matter."""
    return False


def block_numbers(line: LineNode) -> Iterator[Mention]:
    """Brackets have none."""
    yield from ()


def constant(line: LineNode, mention: Mention) -> Constant | None:
    """A word is output in its format, which a number in its place would not be."""
    return None


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """Nothing is."""
    raise Cannot("a word is output in its format")


def extracted(view: View, first: int, last: int) -> Extraction:
    """A section at the end, called in the lines' place."""
    document = view.document
    inside = region(document, first)
    if inside is None or not balanced(document, first, last):
        raise Cannot("the lines are not whole lines of one section, or hold only a part of a bracket")
    if any(_LEAVES.search(document.line(at)) for at in range(first, last + 1)):
        raise Cannot("`#EXIT` and `#GOTO` would leave the new section, not this one")
    name = fresh_name({each.name for each in all_symbols(document) if each.sort is Sort.SECTION}, "part")
    lines = [document.line(at) for at in range(first, last + 1)]
    return Extraction(f"#CALL({name})", document.line_count, [f"@{name}", *lines, "@"])


def missing(view: View, symbol: Symbol) -> NewFile | None:
    """Sections are no files."""
    return None
