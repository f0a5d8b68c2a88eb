"""How programs of Z32 are rebuilt (spec/z32.md §3, §6): jumps go to block numbers of their own section, user parameters are shared by all."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering
from deburr.includes import z32 as stores
from deburr.symbols import Mention, Sort, Symbol, language_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.line import LineNode

LINES: Numbering | None = Numbering(10, 10, 999_999_999)
BLOCKS: Numbering | None = None
EXTRACTED = ""
MISSING: tuple[str, ...] = ("file-missing",)
_LITERAL = re.compile(r"[ \t]*(=?)[ \t]*([-+]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+))[ \t]*")


def line_numbers(line: LineNode) -> Iterator[Mention]:
    """Block numbers, the targets of GON and the ends of its ranges."""
    language = language_of(line.dialect.name)
    assert language is not None
    return (each for each in language.mentions(line, None) if each.symbol.sort is Sort.LABEL)


def starts_section(line: LineNode) -> bool:
    """`:5` starts a program of its own."""
    return next(line.find("section"), None) is not None


def block_numbers(line: LineNode) -> Iterator[Mention]:
    """Nothing has one."""
    yield from ()


def constant(line: LineNode, mention: Mention) -> Constant | None:
    """`!HA=5!` or `HA5`, alone in its block, of a user parameter."""
    found = _LITERAL.match(line.text, mention.span.end)
    if found is None or not re.fullmatch("H[A-Z]", mention.symbol.name) or line.text.lstrip().startswith("/"):
        return None
    before, after = (
        re.sub(r"^[ \t]*(?:N[ \t]*[0-9.]+)?[ \t]*", "", line.text[: mention.span.start], flags=re.I),
        line.text[found.end() :],
    )
    value = found[2].replace(",", ".").removeprefix("+")
    if found[1] and before.strip() == "!" and after.strip() == "!":
        return Constant(value, Span(line.text.index("!"), len(line.text.rstrip())), True)
    alone = not found[1] and not before.strip() and not after.strip()
    return Constant(value, Span(mention.span.start, found.end()), True) if alone else None


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """A signed number in parentheses; as the value of a word it stays in its brackets."""
    return f"({value})" if value.startswith("-") else value


def extracted(view: View, first: int, last: int) -> Extraction:
    """Sections are numbers that files share, so no new one is made."""
    raise Cannot("the numbers of programs are not this file's alone")


def missing(view: View, symbol: Symbol) -> NewFile | None:
    """The file of an L254 call below the file root, which returns at once."""
    root = str(view.ruleset.settings["file-root"])
    if symbol.sort is not Sort.FILE or not root:
        return None
    name = symbol.name.replace("\\", "/").strip("/")
    return NewFile(f"{stores.beside(view.file, root)}/{name}", "G26\n")
