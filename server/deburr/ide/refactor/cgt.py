"""How templates of CGT are rebuilt (spec/cgt.md §5.5): lines become a section that is called; words are shared by all sections."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering, balanced, fresh_name
from deburr.symbols import Mention, Sort
from deburr.symbols.index import all_symbols, region
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, walk

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols.index import Placed
    from deburr_grammar.line import LineNode

LINES: Numbering | None = None
BLOCKS: Numbering | None = None
EXTRACTED = "section"
IN_ORDER = False
MISSING: tuple[str, ...] = ()
_COMPUTING = frozenset(
    (
        "eval",
        "test",
        "repeat",
        "sum",
        "product",
        "quotient",
        "power",
        "signed",
        "group",
        "function",
        "block",
        "returned",
        "lookup",
    )
)
_LITERAL = re.compile(r"[ \t]*=[ \t]*(-?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+))[ \t]*\)")
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
    """`#EVAL(#V1=5)` outside of brackets of its line."""
    for part in line.find("eval"):
        found = _LITERAL.match(line.text, mention.span.end)
        if part.start < mention.span.start < part.end and found is not None and found.end() == part.end:
            return Constant(found[1], Span(part.start, part.end), True)
    return None


def undeclared(line: LineNode, mention: Mention) -> Span:
    """The word with its comma."""
    found = next(each for each in line.find("declaration") if each.start < mention.span.start < each.end)
    words = [each for each in found.children if each.kind == "WORD"]
    at = next(number for number, each in enumerate(words) if each.start == mention.span.start)
    if len(words) == 1:
        return Span(found.start, found.end)
    return Span(words[at - 1].end, words[at].end) if at else Span(words[0].start, words[1].start)


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """A number where the word is computed with; where it is printed, it is printed in its format, and a command takes no number."""
    around = [part for part in walk(line.tree) if isinstance(part, Node) and _holds(part, mention)]
    if around[-1].kind not in _COMPUTING:
        raise Cannot("a word is printed in its format, and a command wants its name")
    return f"({value})" if value.startswith("-") else value


def _holds(part: Node, mention: Mention) -> bool:
    return any(each.kind == "WORD" and each.start == mention.span.start for each in part.children)


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


def missing(view: View, placed: Placed) -> NewFile | None:
    """Sections are no files."""
    return None
