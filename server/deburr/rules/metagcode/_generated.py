"""Which lines are surely generated with the configured values, and which names without a value they refer to. Never reports.

A condition or a loop that cannot be decided without a run - over the variable of a loop, over a
name without a value - leaves its block open: of such lines nothing is claimed
(`spec/metagcode.md` §5, §10).
"""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.arithmetic.metagcode import COMPARISONS
from deburr.rule import Note
from deburr.rules.metagcode._gathered import gathered
from deburr.rules.metagcode._variables import names_of
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.metagcode.forms import condition, counters, groups, is_numeric, name, number
from deburr_grammar.dialects.metagcode.limits import DEEPEST
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Token, tokens

_LINES = 200_000
"""So many lines with directives or variables are looked at, snippets as often as they are included."""
_ENDS = ("ENDIF", "ENDLOOP")
_PROPER = re.compile(r"[^|\r\n]*")


class Use(NamedTuple):
    """A reference to a name without a value: where it is to be marked in the program, and where it stands in a snippet."""

    line: int
    span: Span
    name: str
    related: tuple[Note, ...] = ()


def undefined(analysis: Analysis, known: Mapping[str, str]) -> Iterator[Use]:
    """The references on lines that are surely generated; those of a snippet once for each name and `#FILE` line."""
    blocks = gathered(analysis)
    own = {each for piece in analysis.document.pieces() for each in names_of(piece.chunk)}
    brought = (effect.names for effect in blocks.effects.values() if effect is not None)
    if own.union(*brought) <= known.keys() | {""}:
        return
    seen: set[tuple[int, str]] = set()
    for use in _Walk(analysis, known).uses():
        if not use.related or (use.line, use.name) not in seen:
            seen.add((use.line, use.name))
            yield use


class _Inside(NamedTuple):
    """A block: whether its lines are generated (None: not known), and the names that loops count there."""

    generated: bool | None
    counted: frozenset[str]


class _Walk:
    """One way through the program and its snippets."""

    def __init__(self, analysis: Analysis, known: Mapping[str, str]) -> None:
        self._document = analysis.document
        self._library = gathered(analysis).library
        self._known = known
        self._around = [_Inside(True, frozenset())]
        self._left = _LINES

    def uses(self) -> Iterator[Use]:
        """The references in order."""
        for line, bracket, node in self._lines(self._document):
            yield from (Use(line, span, said) for said, span in self._undefined(node))
            if bracket is not None:
                yield from (Use(line, bracket.span, *found) for found in self._step(bracket, node, 0))

    def _snippet(self, path: str, depth: int) -> Iterator[tuple[str, tuple[Note, ...]]]:
        """The references in a snippet, each with where it stands."""
        for line, bracket, node in self._lines(self._library.scan(path).document):
            for said, span in self._undefined(node):
                yield said, (Note(line, span, f"`|{said}|` stands here", path),)
            if bracket is not None:
                yield from self._step(bracket, node, depth)

    def _lines(self, document: Document) -> Iterator[tuple[int, Bracket | None, LineNode]]:
        """The lines with directives or variables."""
        brackets = dict(document.brackets())
        lines = ((piece.line, names_of(piece.chunk)) for piece in document.pieces())
        named = {first + at for first, rows in lines for row in rows.values() for at in row}
        for line in sorted(named.union(brackets)):
            self._left -= 1
            if self._left < 0:
                return
            yield line, brackets.get(line), document.node(line)

    def _undefined(self, node: LineNode) -> list[tuple[str, Span]]:
        """The names without a value on a line that is generated."""
        said = list(tokens(node.tree)) if self._around[-1].generated and not node.problems else []
        if said and said[0].kind in _ENDS:
            return []
        found = ((name(_said(node, token)), token) for token in said if token.kind == "VARIABLE")
        return [(each, Span(token.start, token.end)) for each, token in found if each and each not in self._known]

    def _step(self, bracket: Bracket, node: LineNode, depth: int) -> Iterator[tuple[str, tuple[Note, ...]]]:
        """Enter or leave a block, or go through a snippet."""
        if bracket.role is Role.OPEN:
            self._around.append(self._entered(bracket, node))
        elif bracket.role is Role.CLOSE and len(self._around) > 1:
            self._around.pop()
        elif bracket.kind == SNIPPET and depth < DEEPEST:
            path = self._library.target(bracket)
            if path is not None and path != self._library.file:
                yield from self._snippet(path, depth + 1)

    def _entered(self, bracket: Bracket, node: LineNode) -> _Inside:
        outer = self._around[-1]
        if not outer.generated:
            return outer
        if bracket.kind == "if":
            return outer._replace(generated=self._holds(node))
        counted = outer.counted.union(each for each, _ in counters(node))
        return _Inside(self._passes(node), counted)

    def _holds(self, node: LineNode) -> bool | None:
        """Whether a condition holds; None where that is not known."""
        form = next(node.find("condition"), None)
        items = condition(form) if form is not None else None
        if items is None or (items.operator.kind, items.type.kind) != ("OPERATOR", "TYPE"):
            return None
        left, right = self._value(node, items.left), self._value(node, items.right)
        if left is None or right is None:
            return None
        holds = COMPARISONS[_said(node, items.operator).lower()]
        if not is_numeric(_said(node, items.type)):
            return holds(left, right)
        one, two = number(left), number(right)
        return None if one is None or two is None else holds(one, two)

    def _passes(self, node: LineNode) -> bool | None:
        """Whether a loop has a pass; None where that is not known."""
        header = next(node.find("header"), None)
        found = [
            (number(self._value(node, group.counter) or ""), number(self._value(node, group.step) or ""))
            for group in (groups(header) if header is not None else ())
            if group.mode.kind == "MODE"
        ]
        if not found or any(total is None or not step for total, step in found):
            return None
        return any(total for total, _ in found)

    def _value(self, node: LineNode, item: Token) -> str | None:
        """What an item says, without outer blanks; None where only the run knows, or nobody."""
        said = _said(node, item)
        if item.kind != "VARIABLE":
            return said
        value = self._known.get(name(said))
        if value is None or name(said) in self._around[-1].counted or not _PROPER.fullmatch(value):
            return None
        return value.strip(" \t")


def _said(node: LineNode, token: Token) -> str:
    return node.text[token.start : token.end]
