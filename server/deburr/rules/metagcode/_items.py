"""What is wrong with the number and the blanks of a directive's items. Never judges an item itself."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from deburr.rule import Line
from deburr.rules.metagcode._words import OPERATORS
from deburr_grammar.dialects.metagcode.forms import Group, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, tokens, walk

_DIGITS = re.compile("[0-9]+")
_MODE = re.compile("[cCrR][A-Za-z]*")
_TYPE = re.compile("[aAnN][A-Za-z]*")
_AND = "for an and write a second `#IF` in this block"
_OR = "for an or write a second `#IF` with the same lines behind this block"
_JOINED = {**dict.fromkeys(("and", "&", "&&"), _AND), "or": _OR}


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
    parts = list(form.nodes()) if form is not None else []
    extra = [part for part in parts if part.kind == "extra"]
    if extra:
        return _split_operator(line, parts) or _surplus_items(line, parts, extra, items)
    given = sum(part.kind != "group" for part in parts)
    if parts and parts[-1].kind == "step" and _MODE.fullmatch(line.said(parts[-1])):
        given = 1
    return Misfit(_span(node), f"`{line.said(node)}` lacks {items[given]}; the items are {_listed(items)}")


def changed_places(line: Line, group: Group) -> bool:
    """Whether a loop's step type stands where its maxStep belongs, and the other way round."""
    step, mode = line.said(group.step), line.said(group.mode)
    return _MODE.fullmatch(step) is not None and (number(mode) is not None or group.mode.kind == "VARIABLE")


def _split_operator(line: Line, parts: Sequence[Node]) -> Misfit | None:
    """An operator in several words, such as `greater than`."""
    for count in (3, 2):
        words = parts[1 : 1 + count]
        joined = "".join(line.said(part) for part in words).lower()
        if joined in OPERATORS:
            span = Span(words[0].start, words[-1].end)
            return Misfit(span, f"`{line.text[span.start : span.end]}` must be one word; write `{joined}`")
    return None


def _surplus_items(line: Line, parts: Sequence[Node], extra: Sequence[Node], items: Sequence[str]) -> Misfit:
    span = Span(extra[0].start, extra[-1].end)
    said = line.text[span.start : span.end]
    hint = _JOINED.get(line.said(extra[0]).lower(), f"the items are {_listed(items)}")
    operator, type_ = parts[1].children[0].kind, parts[3].children[0].kind
    if len(extra) == 1 and _TYPE.fullmatch(said) and (operator, type_) == ("OPERATOR", "ODD"):
        hint = "there are no quotes, so a value with a blank in it must come out of a variable"
    return Misfit(span, f"`{said}` is too much; {hint}")


def _listed(items: Sequence[str]) -> str:
    return ", ".join(item.partition(" (")[0] for item in items)


def _unlabelled(line: Line, node: Node) -> bool:
    """Whether the first item was meant for the label, glued to the keyword or a number behind a blank: another rule's fault."""
    items = list(tokens(node))[1:2]
    return any(
        item.kind != "LABEL" and (item.start == node.children[0].end or _DIGITS.fullmatch(line.said(item)))
        for item in items
    )


def _span(part: Node | Token) -> Span:
    return Span(part.start, part.end)
