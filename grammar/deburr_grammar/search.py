"""The other end of a bracket, found in the tree of balances in O(log n). Never compares kinds or labels."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

from deburr_grammar.chunk import Branch, Chunk
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.outline import Before, Outliner
from deburr_grammar.structure import CUTS

Found = tuple[int, Bracket] | None


class Step(NamedTuple):
    """A child on the way from the root to a chunk: its branch and number, their first lines, what holds before each."""

    branch: Branch
    number: int
    first: int
    line: int
    top: Before
    before: Before


class Partners:
    """Looks for partners in one version of a document, from a chunk to which ``path`` leads."""

    def __init__(self, outliner: Outliner, path: list[Step]) -> None:
        self._outliner = outliner
        self._path = path

    def find(self, line: int, bracket: Bracket) -> Found:
        """The other end of an opener or closer that stands on a line of the chunk; None where its region has none."""
        forward = bracket.role is Role.OPEN
        brackets = self._here()
        at = brackets.index((line, bracket))
        return self._beyond(brackets[at + 1 :] if forward else reversed(brackets[:at]), forward)

    def around(self, line: int, col: int) -> Found:
        """The opener of the innermost block that is open at a place of the chunk; None outside all blocks."""
        before = [(at, each) for at, each in self._here() if (at, each.span.start) < (line, col)]
        return self._beyond(reversed(before), False)

    def _here(self) -> list[tuple[int, Bracket]]:
        here = self._path[-1]
        chunk = here.branch.children[here.number]
        assert isinstance(chunk, Chunk)
        return self._brackets(_At(chunk, here.line, here.before))

    def _beyond(self, rest: Iterable[tuple[int, Bracket]], forward: bool) -> Found:
        """The other end of one block, in the rest of the chunk's brackets or in the chunks behind or before it."""
        done, found, depth = _scan(rest, 1, forward)
        for step in () if done else reversed(self._path):
            for node in self._siblings(step, forward):
                done, found, depth = self._visit(node, depth, forward)
                if done:
                    return found
        return found

    def _siblings(self, step: Step, forward: bool) -> Iterable[_At]:
        placed = self._placed(step.branch, step.first, step.top)
        return islice(placed, step.number + 1, None) if forward else reversed(list(islice(placed, step.number)))

    def _placed(self, branch: Branch, line: int, before: Before) -> Iterator[_At]:
        for node, inner in self._outliner.inner(branch, before):
            yield _At(node, line, inner)
            line += node.eols

    def _visit(self, at: _At, depth: int, forward: bool) -> tuple[bool, Found, int]:
        """Go through a node: whether the search is over, what it found, how many blocks are left to close."""
        balance = self._outliner.balance(at.node, at.before)
        near, far = (balance.closers, balance.openers) if forward else (balance.openers, balance.closers)
        if near < depth:
            return balance.cut, None, depth - near + far
        if isinstance(at.node, Chunk):
            brackets = self._brackets(at)
            return _scan(brackets if forward else reversed(brackets), depth, forward)
        inner = self._placed(at.node, at.line, at.before)
        for child in inner if forward else reversed(list(inner)):
            done, found, depth = self._visit(child, depth, forward)
            if done:
                return True, found, depth
        return False, None, depth

    def _brackets(self, at: _At) -> list[tuple[int, Bracket]]:
        assert isinstance(at.node, Chunk)
        outlined = self._outliner.outlined(at.node, at.before)
        return [(at.line + index, bracket) for index, bracket in outlined.brackets]


class _At(NamedTuple):
    node: Branch | Chunk
    line: int
    before: Before


def _scan(brackets: Iterable[tuple[int, Bracket]], depth: int, forward: bool) -> tuple[bool, Found, int]:
    more, less = (Role.OPEN, Role.CLOSE) if forward else (Role.CLOSE, Role.OPEN)
    for line, bracket in brackets:
        if bracket.role in CUTS:
            return True, None, depth
        depth += (bracket.role is more) - (bracket.role is less)
        if not depth:
            return True, (line, bracket), 0
    return False, None, depth
