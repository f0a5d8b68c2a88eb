"""What a selection grows to, step by step: token, the parts of the line around it, line, blocks, program."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import scopes
from deburr.finding import Place
from deburr.symbols.index import region
from deburr_grammar.dialect import Role
from deburr_grammar.tree import Node

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.document import Document
    from deburr_grammar.text import Pos
    from deburr_grammar.tree import Token

_DEEPEST = 100


def selections(view: View, pos: Pos) -> list[Place]:
    """The stretches around a place, innermost first, each larger than the one before."""
    found: list[Place] = []
    for place in _around(view.document, pos):
        wider = not found or (place[1:3] <= found[-1][1:3] and place[3:] >= found[-1][3:] and place != found[-1])
        if wider:
            found.append(place)
    return found


def _around(document: Document, pos: Pos) -> Iterator[Place]:
    node = document.node(pos.line)
    for part in reversed(list(_path(node.tree, pos.col))):
        yield Place("", pos.line, part.start, pos.line, part.end)
    text = node.text
    start = len(text) - len(text.lstrip())
    yield Place("", pos.line, min(start, pos.col), pos.line, max(len(text.rstrip()), pos.col))
    yield Place("", pos.line, 0, pos.line, len(text))
    for first, last in _blocks(document, pos.line):
        yield Place("", first, 0, last, len(document.line(last)))
    for first, last in _region(document, pos.line):
        yield Place("", first, 0, last, len(document.line(last)))
    end = document.line_count - 1
    yield Place("", 0, 0, end, len(document.line(end)))


def _region(document: Document, line: int) -> Iterator[tuple[int, int]]:
    """The subprogram or section around a line, if it has an end."""
    for scope in scopes(document.brackets()) if region(document, line) is not None else ():
        if scope.start is not None and scope.end is not None and scope.start.line <= line <= scope.end.line:
            yield scope.start.line, scope.end.line


def _path(tree: Node, col: int) -> Iterator[Node | Token]:
    part: Node | Token | None = tree
    while part is not None and part.start <= col <= part.end and part.start < part.end:
        yield part
        inner = part.children if isinstance(part, Node) else ()
        part = next((each for each in inner if each.start <= col < each.end), None)


def _blocks(document: Document, line: int) -> Iterator[tuple[int, int]]:
    """The blocks around a line, innermost first: found by the partner of each opener above."""
    depth = found = 0
    piece = document.piece(line)
    openers = [(piece.line + index, each) for index, each in piece.outlined.brackets if piece.line + index <= line]
    for at, bracket in reversed(openers):
        depth += (bracket.role is Role.CLOSE and at < line) - (bracket.role is Role.OPEN)
        if depth < 0 and bracket.role is Role.OPEN:
            depth = 0
            other = document.partner(at, bracket)
            if other is not None and other[0] >= line:
                found += 1
                yield at, other[0]
        if found >= _DEEPEST:
            return
