"""The blocks of a program as a tree: regions, blocks in them, what stands directly in each. Built in one sweep over brackets; never reads a line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.structure import Placed


@dataclass
class Block:
    """An opener, what stands directly between it and its closer, and the closer (None: it is never closed)."""

    opener: Placed
    inner: list[Block | Placed] = field(default_factory=list)
    closer: Placed | None = None

    def middles(self) -> Iterator[Placed]:
        """The brackets that stand directly in the block and open nothing: `else`, `break`."""
        return (part for part in self.inner if isinstance(part, Placed))


@dataclass
class Scope:
    """A region (a subprogram, a section; None: what is in none) and the blocks in it."""

    start: Placed | None
    inner: list[Block | Placed] = field(default_factory=list)
    end: Placed | None = None

    def blocks(self) -> Iterator[tuple[Block, tuple[Block, ...]]]:
        """Every block of the scope with the blocks around it, outermost first."""
        yield from _nested(self.inner, ())

    def brackets(self) -> Iterator[tuple[Placed, tuple[Block, ...]]]:
        """Every bracket of the scope but closers, in order, with the blocks around it."""
        yield from _brackets(self.inner, ())


def scopes(brackets: Iterable[tuple[int, Bracket]]) -> tuple[Scope, ...]:
    """The scopes in order; what stands outside all regions is the first, in as many pieces as regions leave, joined."""
    outside = Scope(None)
    found, scope, stack = [outside], outside, list[Block]()
    for line, bracket in brackets:
        placed = Placed(line, bracket)
        holder = stack[-1].inner if stack else scope.inner
        match bracket.role:
            case Role.OPEN:
                stack.append(Block(placed))
                holder.append(stack[-1])
            case Role.CLOSE if stack:
                stack.pop().closer = placed
            case Role.REGION:
                stack.clear()
                scope = Scope(placed)
                found.append(scope)
            case Role.END_REGION:
                stack.clear()
                scope.end, scope = placed, outside
            case _:
                holder.append(placed)
    return tuple(found)


def _nested(parts: Iterable[Block | Placed], around: tuple[Block, ...]) -> Iterator[tuple[Block, tuple[Block, ...]]]:
    for part in parts:
        if isinstance(part, Block):
            yield part, around
            yield from _nested(part.inner, (*around, part))


def _brackets(parts: Iterable[Block | Placed], around: tuple[Block, ...]) -> Iterator[tuple[Placed, tuple[Block, ...]]]:
    for part in parts:
        if isinstance(part, Block):
            yield part.opener, around
            yield from _brackets(part.inner, (*around, part))
        else:
            yield part, around
