"""How programs of RS274 are rebuilt (spec/rs274.md §1.3, §4, §6): line numbers mean nothing, parameters up to 30 and names without `_` are a subprogram's own."""

from __future__ import annotations

import re
from collections.abc import Iterator
from posixpath import dirname
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering, balanced, fresh_name
from deburr.symbols import Act, Mention, Sort, Symbol
from deburr.symbols.index import all_symbols, mentions_of, on_line, region
from deburr_grammar.dialect import Role
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols.index import Placed
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

LINES = Numbering(10, 10, 99_999)
BLOCKS = Numbering(100, 10, 99_999)
EXTRACTED = "subprogram"
IN_ORDER = True
MISSING: tuple[str, ...] = ("sub-unknown",)
_ARGUMENTS = 30
_LITERAL = re.compile(r"[ \t]*=[ \t]*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?=[ \t]*(?:$|[(;#]))")
_ENDS = re.compile(r"(?i)^[ \t]*%|\bM[ \t]*0*(?:2|30|7[0-3]|98|99)(?![0-9])|\breturn\b")
_BY_NUMBER = re.compile(r"(?i)M[ \t]*98(?![0-9])|G[ \t]*7[0-2](?:\.[12])?(?![0-9])")


def line_numbers(line: LineNode) -> Iterator[Mention]:
    """The N word: nothing jumps to it."""
    for node in line.find("line_number"):
        inner = Span(node.children[-1].start, node.end)
        said = line.text[inner.start : inner.end]
        yield Mention(Symbol(Sort.LABEL, said), Act.DEFINE, Span(node.start, node.end), inner)


def starts_section(line: LineNode) -> bool:
    """There are none."""
    return False


def block_numbers(line: LineNode) -> Iterator[Mention]:
    """O-words with a number or an expression; calls by M98 and cycles name a number that is not followed."""
    from deburr.symbols import language_of

    language = language_of(line.dialect.name)
    for mention in language.mentions(line, None) if language is not None else ():
        is_label = mention.symbol.sort in (Sort.SUB, Sort.LABEL)
        if is_label and (mention.symbol.name.isdigit() or not mention.symbol.name):
            yield mention
    if line.kinds and (found := _BY_NUMBER.search(line.text)):
        yield Mention(Symbol(Sort.SUB, ""), Act.CALL, Span(*found.span()), Span(*found.span()))


def constant(line: LineNode, mention: Mention) -> Constant | None:
    """`#<a>=5`; arguments of a call and lines that may be skipped are none. Numbers above 30 may be kept in a file."""
    found = _LITERAL.match(line.text, mention.span.end)
    if found is None or line.text.lstrip().startswith("/"):
        return None
    name = mention.symbol.name
    return Constant(found[1], Span(mention.span.start, found.end()), not name.isdigit() or int(name) <= _ARGUMENTS)


def undeclared(line: LineNode, mention: Mention) -> Span:
    """Nothing is declared."""
    return mention.span


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """A signed number in brackets, unless it is all of a word's value or stands alone in brackets."""
    before, after = line.text[: mention.span.start].rstrip(), line.text[mention.span.end :].lstrip()
    if _in_comment(line, mention):
        raise Cannot("a comment shows its value")
    if value[0].isdigit() or value[0] == "." or re.search(r"[A-Za-z=]$", before):
        return value
    return value if before.endswith("[") and after.startswith("]") else f"[{value}]"


def _in_comment(line: LineNode, mention: Mention) -> bool:
    before = line.text[: mention.span.start]
    return before.rfind("(") > before.rfind(")") or ";" in before


def extracted(view: View, first: int, last: int) -> Extraction:
    """A subprogram before the outermost block, called with the values that the lines use."""
    document = view.document
    lines = [document.line(at) for at in range(first, last + 1)]
    if not balanced(document, first, last):
        raise Cannot("the lines hold only a part of a block, or a subprogram's start or end")
    if any(document.node(at).reading.start is None for at in range(first, last + 1)):
        raise Cannot("the lines are never read")
    if wrong := next((line for line in lines if _ENDS.search(line)), None):
        raise Cannot(f"`{wrong.strip()}` ends more than these lines, or saves for a subprogram of its own")
    name = fresh_name({each.name for each in all_symbols(document) if each.sort is Sort.SUB}, "part")
    arguments, opening = _passed(document, first, last)
    indent = lines[0][: len(lines[0]) - len(lines[0].lstrip())]
    call = f"{indent}o<{name}> call" + "".join(f" [{each}]" for each in arguments)
    body = [f"o<{name}> sub", *opening, *lines, f"o<{name}> endsub"]
    return Extraction(call, _before(document, first), body)


def _passed(document: Document, first: int, last: int) -> tuple[list[str], list[str]]:
    """The arguments of the call, and the lines that give names their values."""
    inside = [each for at in range(first, last + 1) for each in on_line(document, at)]
    locals_ = [
        each for each in inside if each.symbol.sort is Sort.VARIABLE and (each.symbol.local or not each.symbol.name)
    ]
    if any(not each.symbol.name for each in locals_):
        raise Cannot("a parameter is computed, so whose it is cannot be seen")
    if any(each.symbol.sort is Sort.FUNCTION and each.symbol.name == "EXISTS" for each in inside):
        raise Cannot("EXISTS asks for a name that would be another's")
    where = region(document, first)
    for symbol in dict.fromkeys(each.symbol for each in locals_ if each.act is Act.SET):
        outside = [one for one in mentions_of(document, symbol, where) if not first <= one.line <= last]
        if any(one.mention.act is Act.READ for one in outside):
            raise Cannot(f"the lines set a value of their own program that is used elsewhere: `{symbol.name}`")
    used = sorted({each.symbol.name for each in locals_})
    highest = max((int(name) for name in used if name.isdigit()), default=0)
    names = [name for name in used if not name.isdigit() and _is_read_first(document, name, first, last)]
    if highest + len(names) > _ARGUMENTS:
        raise Cannot(f"a call takes {_ARGUMENTS} arguments")
    numbers = [f"#{number}" for number in range(1, highest + 1)]
    opening = [f"#<{name}>=#{highest + at}" for at, name in enumerate(names, 1)]
    return [*numbers, *(f"#<{name}>" for name in names)], opening


def _is_read_first(document: Document, name: str, first: int, last: int) -> bool:
    """Whether a name must have a value before the lines: unless they set it, unconditionally, before they read it."""
    depth = 0
    for at in range(first, last + 1):
        mentions = [each for each in on_line(document, at) if each.symbol.name == name]
        if any(each.act is Act.READ for each in mentions):
            return True
        if mentions and depth == 0:
            return False
        depth += sum((each.role is Role.OPEN) - (each.role is Role.CLOSE) for each in _brackets(document, at))
    return False


def _brackets(document: Document, line: int) -> list[Bracket]:
    piece = document.piece(line)
    return [bracket for at, bracket in piece.outlined.brackets if piece.line + at == line]


def _before(document: Document, first: int) -> int:
    """Where a subprogram can stand: before the subprogram or the outermost block that holds a line."""
    depth, start = 0, first
    for line, bracket in document.brackets():
        if line >= first:
            break
        if bracket.role is Role.REGION:
            depth, start = depth + 1, line
        elif bracket.role is Role.OPEN:
            depth, start = depth + 1, line if depth == 0 else start
        elif bracket.role in (Role.CLOSE, Role.END_REGION):
            depth -= 1
    return start if depth > 0 else first


def missing(view: View, placed: Placed) -> NewFile | None:
    """`name.ngc` beside the program, with an empty subprogram."""
    symbol = placed.mention.symbol
    if symbol.sort is not Sort.SUB or not symbol.name:
        return None
    label = f"o{symbol.name}" if symbol.name.isdigit() else f"o<{symbol.name}>"
    return NewFile(f"{dirname(view.file)}/{symbol.name}.ngc", f"{label} sub\n\n{label} endsub\nM2\n")
