"""Values of RS274 that lines alone decide (spec/rs274.md §3, §4)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.arithmetic.rs274 import constant
from deburr.symbols.constants import Held, Length, Settings, count
from deburr.symbols.constants._unconfigured import counted, given, names, shown
from deburr_grammar.codes import code_number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.symbols import Mention
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

__all__ = ["assigned", "counted", "disturbed", "given", "lengths", "names", "results", "row", "shown"]

_FARTHEST = 2_000
"""So many lines between an assignment and a use are looked through."""
_ELSEWHERE = frozenset(("M2", "M30", "M98", "M99"))
"""Behind these stand programs that share all parameters, or they are run here."""
_COMPUTED = frozenset(("sum", "product", "quotient", "modulo", "power", "comparison", "logical", "function", "atan"))
_OPTIONAL = "/"
_M = re.compile("[Mm]")


def assigned(document: Document, line: int, mention: Mention, settings: Settings) -> str | None:
    """The constant behind `=`; none of a line that the operator can leave out."""
    node = document.node(line)
    if node.text.lstrip(" \t").startswith(_OPTIONAL):
        return None
    for setting in node.find("setting"):
        if setting.start == mention.span.start:
            value = constant(node.text, setting.children[-1], settings)
            return shown(value) if isinstance(value, float) else None
    return None


def disturbed(document: Document, first: int, last: int) -> bool:
    """Whether a program ends or is called there, with which all parameters are shared; what is too far away is not looked for."""
    if last - first > _FARTHEST:
        return True
    for at in range(first, last + 1):
        node = document.node(at) if _M.search(document.line(at)) else None
        if node is not None and not _ELSEWHERE.isdisjoint(_codes(node)):
            return True
    return False


def results(line: LineNode, settings: Settings) -> Iterator[tuple[Span, str]]:
    """Bracketed expressions with an operator or a function in them, and functions."""
    reached = 0
    for part in walk(line.tree) if not line.kinds.isdisjoint(_COMPUTED) else ():
        if part.start < reached or not isinstance(part, Node) or part.kind not in ("group", "function", "atan"):
            continue
        value = constant(line.text, part, settings)
        if isinstance(value, float) and any(each.kind in _COMPUTED for each in walk(part)):
            reached = part.end
            yield Span(part.start, part.end), shown(value)


def lengths(document: Document, line: int, held: Held, settings: Settings) -> Iterator[Length]:
    """Of `repeat` with a count that is more than a number."""
    node = document.node(line)
    for o_line in node.find("o_line"):
        group = o_line.node("group")
        if o_line.find("REPEAT") is None or group is None:
            continue
        inner = group.children[1]
        value = constant(node.text, inner, settings)
        if isinstance(inner, Node) and inner.kind == "param":
            known = held(line, node.text[inner.start : inner.end])
            value = float(known.first) if known is not None and known.plain is not None else None
        if isinstance(value, float) and not isinstance(inner, Token):
            # The count is rounded, and none below 1 runs the lines.
            yield Length(Span(group.start, group.end), count(max(0, int(value + 0.5))))


def row(document: Document, line: int, mention: Mention) -> None:
    """There are no tables."""


def _codes(line: LineNode) -> Iterator[str]:
    for word in line.find("word"):
        if line.text[word.start] in "mM":
            yield code_number(line.text[word.start : word.end])
