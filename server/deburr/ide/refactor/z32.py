"""How programs of Z32 are rebuilt (spec/z32.md §3, §6): jumps go to block numbers of their own section, user parameters are shared by all."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.ide.refactor import Cannot, Constant, Extraction, NewFile, Numbering
from deburr.includes import z32 as stores
from deburr.symbols import Act, Mention, Sort, language_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols.index import Placed
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_LARGEST, _STEP = 999_999_999, 10
LINES: Numbering | None = Numbering(_STEP, _STEP, _LARGEST)
BLOCKS: Numbering | None = None
EXTRACTED = "range of blocks"
IN_ORDER = True
MISSING: tuple[str, ...] = ("file-missing", "program-missing")
_ENDS = re.compile(r"(?i)^[ \t]*(?:N[ \t]*[0-9.,]+[ \t]*)?(?:M[ \t]*(?:0*2|30)|G[ \t]*26)(?![0-9.])")
_LEAVES = re.compile(r"(?i)\bM[ \t]*(?:0*2|30)(?![0-9.])|G[ \t]*2[56](?![0-9.])|^[ \t]*[:%]")
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


def undeclared(line: LineNode, mention: Mention) -> Span:
    """Nothing is declared."""
    return mention.span


def inlined(value: str, line: LineNode, mention: Mention) -> str:
    """A signed number in parentheses; as the value of a word it stays in its brackets."""
    return f"({value})" if value.startswith("-") else value


def extracted(view: View, first: int, last: int) -> Extraction:
    """Blocks behind the end of their program, between two numbers of their own, to which `GON` goes and from which it comes back."""
    document = view.document
    start, stop = _program(document, first)
    if document.node(first).reading.start is None:
        raise Cannot("these lines are never read")
    if last >= stop or any(_LEAVES.search(document.line(at)) for at in range(first, last + 1)):
        raise Cannot("the lines end the program, change its axes or belong to more than one program")
    end = next((at for at in range(stop - 1, last, -1) if document.line(at).strip()), last)
    if not _ENDS.match(document.line(end)):
        raise Cannot("the program does not end in M2, M30 or G26, so it would run on into blocks behind it")
    numbers = [(at, each) for at in range(start, stop) for each in line_numbers(document.node(at))]
    _refuse(numbers, first, last)
    highest = max((int(float(each.symbol.name)) for _, each in numbers if each.symbol.name), default=0)
    begin = highest - highest % _STEP + _STEP
    if begin + _STEP > _LARGEST:
        raise Cannot("there is no higher number for a block")
    text = document.line(first)
    indent = text[: len(text) - len(text.lstrip())]
    lines = [document.line(at) for at in range(first, last + 1)]
    call = f"{indent}!GON{begin}-N{begin + _STEP}!"
    return Extraction(call, end + 1, [f"N{begin}", *lines, f"N{begin + _STEP}"])


def _program(document: Document, line: int) -> tuple[int, int]:
    """The first line of the section that holds a line, and the one behind its last."""
    starts = [at for at, node in enumerate(document.nodes()) if starts_section(node)]
    before = max((at for at in starts if at <= line), default=0)
    return before, min((at for at in starts if at > line), default=document.line_count)


def _refuse(numbers: list[tuple[int, Mention]], first: int, last: int) -> None:
    """Cannot, if a jump leads out of the lines or into them: whoever comes back does so to where the last `GON` stood."""
    called = {each.symbol.name for _, each in numbers if each.act is Act.CALL}
    if "" in called:
        raise Cannot("a jump goes to a number that is computed")
    for line, each in numbers:
        if first <= line <= last and (each.act is Act.CALL or each.symbol.name in called):
            raise Cannot("a jump leads out of the lines or into them")


def missing(view: View, placed: Placed) -> NewFile | None:
    """The file of an L254 call below the file root, or of a program in the memory, which returns at once."""
    symbol = placed.mention.symbol
    root, folder = str(view.ruleset.settings["file-root"]), str(view.ruleset.settings["cmos-dir"])
    if symbol.sort is Sort.FILE and root:
        name = symbol.name.replace("\\", "/").strip("/")
        return NewFile(f"{stores.beside(view.file, root)}/{name}", "G26\n")
    if symbol.sort is Sort.SECTION and symbol.name.isdigit() and folder:
        before = view.document.line(placed.line)[: placed.mention.span.start]
        store = f"{folder}-temp" if before.rstrip().upper().endswith("GOS") else folder
        return NewFile(f"{stores.beside(view.file, store)}/{symbol.name}.z32", "G26\n")
    return None
