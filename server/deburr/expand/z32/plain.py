"""Blocks of literal axis and system words: read once a shape, so that a line costs one match (spec/z32.md §6.1, §6.7). Calculates nothing."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from deburr_grammar.line import LineNode

_SYSTEM = ("LX", "AE")
_ENDS = (2.0, 30.0)
_BLANKS = re.compile(r"[ \t]*")
_FOLDED = re.compile(r"\(\)|0|[^0(]+|\(")
_KEY = "z32 plain"


class Plain:
    """What all lines of a shape have in common: the names that they set, and where their values and their flat text stand."""

    def __init__(self, names: tuple[str, ...], pattern: re.Pattern[str], cut: bool) -> None:
        self._names = names
        self._match = pattern.fullmatch
        self._cut = cut

    def read(self, text: str, keep_n: bool, stores: bool) -> tuple[str, Mapping[str, float]] | None:
        """The flat text of a line, and what it stores if that is wanted."""
        match = self._match(text)
        if match is None:
            return None
        indent, numbered, body, *values = match.groups()
        flat = indent + numbered + body if keep_n else indent + body
        stored = {name: number(value) for name, value in zip(self._names, values)} if stores else {}
        return flat.rstrip(" \t") if self._cut else flat, stored


def plain_of(node: LineNode) -> Plain | None:
    """What a line's shape says of it; None where more than literal words stands there."""
    memo = node.shape.memo
    if _KEY not in memo:
        memo[_KEY] = _made(node)
    found = memo[_KEY]
    assert found is None or isinstance(found, Plain)
    return found


def _made(node: LineNode) -> Plain | None:
    text, tree = node.shape.text, node.shape.tree(node.reading)
    names, values = list[str](), list[tuple[int, int]]()
    start = body = 0
    end, cut, written = len(text), False, False
    for part in tree.children:
        match part.kind:
            case "nword":
                behind = _BLANKS.match(text, part.end)
                start, body = part.start, behind.end() if behind is not None else part.end
            case "COMMENT":
                written = True
            case "g_word" if _is_literal(part, "G"):
                written = True
            case "word" if (name := _name(text, part)) is not None:
                assert isinstance(part, Node)
                names.append(name)
                values.append((part.children[1].start, part.children[1].end))
                written = True
            case "text":
                end, cut = part.start, True
            case _:
                return None
    parts = (_pattern(text[:start]), _pattern(text[start:body]), "".join(_body(text, body, end, values)))
    pattern = "({})({})({})".format(*parts) + (".*" if cut else "")
    return Plain(tuple(names), re.compile(pattern), cut) if written else None


def _is_literal(part: Node | Token, letter: str) -> bool:
    return isinstance(part, Node) and [child.kind for child in part.children] == [letter, "NUMBER"]


def _name(text: str, word: Node | Token) -> str | None:
    """The name that a word sets, if it is written with a literal value and ends nothing."""
    assert isinstance(word, Node)
    target, value = word.children
    name = text[target.start : target.end].upper()
    if isinstance(value, Node) and (value.kind != "signed" or value.children[1].kind != "NUMBER"):
        return None
    # The numbers of M codes are not folded, so a shape tells which of them end the program.
    ends = name == "M" and number(text[value.start : value.end].lstrip("+-")) in _ENDS
    return name if target.kind == "NAME" and (len(name) == 1 or name in _SYSTEM) and not ends else None


def _body(text: str, start: int, end: int, values: list[tuple[int, int]]) -> Iterator[str]:
    at = start
    for first, last in values:
        yield _pattern(text[at:first])
        yield f"({_pattern(text[first:last])})"
        at = last
    yield _pattern(text[at:end])


def _pattern(folded: str) -> str:
    """What matches the text that a stretch of a shape stands for: a `0` may be any digits, and `()` any comment."""
    return "".join(
        r"\([^()]*\)" if each == "()" else "[0-9]+" if each == "0" else re.escape(each)
        for each in _FOLDED.findall(folded)
    )
