"""What is wrong with the number and the blanks of a directive's items. Never judges an item itself."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from deburr.rule import Line
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, tokens, walk

_DIGITS = re.compile("[0-9]+")


class Misfit(NamedTuple):
    """What does not fit, and why."""

    span: Span
    why: str


def surplus(line: Line, end: Node) -> Misfit | None:
    """What stands behind the number of an `#ENDIF` or `#ENDLOOP`."""
    more = [part for part in end.children[1:] if part.kind != "LABEL"]
    if not more or _unlabelled(line, end):
        return None
    span = Span(more[0].start, more[-1].end)
    return Misfit(
        span,
        f"`{line.text[span.start : span.end]}` stands behind `{line.text[end.start : more[0].start].rstrip()}`, which takes nothing",
    )


def misfit(line: Line, node: Node, complete: str, items: Sequence[str]) -> Misfit | None:
    """What is wrong with an opener that has no ``complete`` form; ``items`` names what the form consists of."""
    if node.node(complete) is not None or _unlabelled(line, node):
        return None
    form = next((part for part in node.nodes()), None)
    glued = next((part for part in walk(node) if part.kind == "GLUED"), None)
    if glued is not None:
        said = line.said(glued)
        return Misfit(_span(glued), f"`{said}` must be set off by a blank from what stands before it")
    extra = [part for part in form.nodes() if part.kind == "extra"] if form is not None else []
    if extra:
        span = Span(extra[0].start, extra[-1].end)
        return Misfit(span, f"`{line.text[span.start : span.end]}` is too much; the items are {', '.join(items)}")
    given = sum(part.kind != "group" for part in form.nodes()) if form is not None else 0
    return Misfit(_span(node), f"`{line.said(node)}` lacks {items[given]}; the items are {', '.join(items)}")


def _unlabelled(line: Line, node: Node) -> bool:
    """Whether the first item was meant for the label, glued to the keyword or a number behind a blank: another rule's fault."""
    items = list(tokens(node))[1:2]
    return any(
        item.kind != "LABEL" and (item.start == node.children[0].end or _DIGITS.fullmatch(line.said(item)))
        for item in items
    )


def _span(part: Node | Token) -> Span:
    return Span(part.start, part.end)
