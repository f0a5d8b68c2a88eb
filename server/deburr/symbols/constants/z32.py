"""Values of Z32 that lines alone decide, and those that the configuration gives (spec/z32.md §4, §5)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import constant, nearest, shown
from deburr.symbols import Act, Sort, Symbol
from deburr.symbols.constants import Held, Length, Settings, Value
from deburr.symbols.index import all_called
from deburr.symbols.z32 import mentions
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, walk

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.symbols import Mention
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_FARTHEST = 300
"""So many lines between an assignment and a use are looked through for places to which a jump leads."""
_TRACKED = re.compile(r"PA[LR]\[[0-9]+\]|H(?![RTXY])[A-Z]")
"""What only its own name sets: no axis, and not what CP and PC compute."""
_COMPUTED = frozenset(("sum", "product", "function", "unary"))


def assigned(document: Document, line: int, mention: Mention, settings: Settings) -> str | None:
    """The constant behind a parameter; none where a condition or the operator's switch stands before it."""
    name, node = mention.symbol.name, document.node(line)
    if not _TRACKED.fullmatch(name) or node.text.lstrip(" \t").startswith("/") or "if" in node.kinds:
        return None
    for part in node.find("assign", "word"):
        if part.start == mention.span.start:
            value = constant(node.text, part.children[-1])
            if isinstance(value, float):
                return shown(nearest(value) if name.startswith("PAL") else value)
    return None


def given(symbol: Symbol, file: str, settings: Settings, host: Host) -> Value | None:
    """The machine's values that are configured."""
    match = re.fullmatch(r"PAL\[([0-9]+)\]", symbol.name)
    found = settings["pal"].get(match[1]) if match else None
    return None if found is None else Value(str(found), "the setting `pal`")


def names(file: str, settings: Settings, host: Host) -> Iterator[str]:
    """The machine's values that are configured."""
    yield from (f"PAL[{index}]" for index in settings["pal"])


def counted(document: Document, line: int, symbol: Symbol, total: Value | None, held: Held) -> Value | None:
    """No loop has a counter of its own."""
    return total


def disturbed(document: Document, first: int, last: int) -> bool:
    """Whether a jump can lead to one of these lines, or to others and back; what is too far away is not looked for."""
    targets = all_called(document, Sort.LABEL)
    if last - first > _FARTHEST or Symbol(Sort.LABEL, "") in targets:
        return True
    lines = (document.node(at) for at in range(first, last + 1))
    return any("range_end" in line.kinds or not targets.isdisjoint(_labels(line)) for line in lines)


def results(line: LineNode, settings: Settings) -> Iterator[tuple[Span, str]]:
    """Bracketed expressions with an operator or a function in them."""
    reached = 0
    for part in walk(line.tree) if not line.kinds.isdisjoint(_COMPUTED) else ():
        if part.start < reached or not isinstance(part, Node) or part.kind != "angle":
            continue
        value = constant(line.text, part)
        if isinstance(value, float) and any(each.kind in _COMPUTED for each in walk(part)):
            reached = part.end
            yield Span(part.start, part.end), shown(value)


def lengths(document: Document, line: int, held: Held, settings: Settings) -> Iterator[Length]:
    """Loops are jumps: no line says how long they are."""
    yield from ()


def row(document: Document, line: int, mention: Mention) -> None:
    """There are no tables."""


def _labels(line: LineNode) -> Iterator[Symbol]:
    """The numbers by which a line can be jumped to."""
    if "nword" in line.kinds:
        found = mentions(line, None)
        yield from (each.symbol for each in found if each.symbol.sort is Sort.LABEL and each.act is Act.DEFINE)
