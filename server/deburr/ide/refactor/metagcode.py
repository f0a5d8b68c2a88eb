"""How programs of MetaGCODE are rebuilt (spec/metagcode.md §2, §3): numbers of blocks tie their ends, snippets are put in as text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering, balanced, fresh_name
from deburr.includes import Folder, leaves
from deburr.symbols import Act, Mention, Sort, Symbol
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols.index import Placed
    from deburr_grammar.line import LineNode

LINES: Numbering | None = None
BLOCKS: Numbering | None = Numbering(1, 1, 999_999_999)
EXTRACTED = "snippet"
IN_ORDER = True
MISSING: tuple[str, ...] = ("file-missing",)


def line_numbers(line: LineNode) -> Iterator[Mention]:
    """The G-code is text."""
    yield from ()


def starts_section(line: LineNode) -> bool:
    """There are none."""
    return False


def block_numbers(line: LineNode) -> Iterator[Mention]:
    """The number behind a directive."""
    for token in tokens(line.tree):
        if token.kind == "LABEL":
            span = Span(token.start, token.end)
            yield Mention(Symbol(Sort.LABEL, line.text[span.start : span.end]), Act.SAY, span, span)


def constant(line: LineNode, mention: Mention) -> Constant | None:
    """Variables get their values elsewhere."""
    return None


def undeclared(line: LineNode, mention: Mention) -> Span:
    """Nothing is declared."""
    return mention.span


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """The text itself; one that is an operand must be one word."""
    if next(line.find("if", "loop"), None) is not None and not re.fullmatch(r"[^ \t|]+", value):
        raise Cannot("its value is no single word, as an operand must be")
    return value


def extracted(view: View, first: int, last: int) -> Extraction:
    """A file in the folder of snippets."""
    document = view.document
    if not balanced(document, first, last):
        raise Cannot("the lines hold only a part of a block")
    folder = Folder(view.host, view.file, str(view.ruleset.settings["snippets-dir"]))
    if folder.silent:
        raise Cannot("the program is in no folder")
    taken = {name.lower().removesuffix(".txt") for name in folder.near("part.txt")}
    name = f"{fresh_name(taken, 'part')}.txt"
    text = "".join(f"{document.line(at)}\n" for at in range(first, last + 1))
    return Extraction(f"#FILE {name}", file=NewFile(f"{folder.root}/{name}", text))


def missing(view: View, placed: Placed) -> NewFile | None:
    """An empty snippet."""
    symbol = placed.mention.symbol
    folder = Folder(view.host, view.file, str(view.ruleset.settings["snippets-dir"]))
    if symbol.sort is not Sort.FILE or folder.silent or not symbol.name or leaves(symbol.name):
        return None
    return NewFile(f"{folder.root}/{symbol.name}", "")
