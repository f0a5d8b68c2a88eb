"""The blocks of a program and what stands in them: one sweep over brackets, linear however deep they nest. Never reads a line."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from deburr.steps import done, paced
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.structure import Placed

DEEPEST = 250
"""How far outward a rule looks. No reference knows blocks nested deeper; beyond it nothing is claimed."""


@dataclass(eq=False)
class Block:
    """An opener and its closer (None: it is never closed).

    ``around`` is the block in which it stands, and ``before`` counts that block's middles that
    come before it; ``middles`` are the brackets directly inside that open nothing: `else`, `break`.
    """

    opener: Placed
    around: Block | None
    before: int
    middles: list[Placed] = field(default_factory=list)
    closer: Placed | None = None

    def outward(self) -> Iterator[Block]:
        """This block and those around it, innermost first, down to a depth that programs have."""
        return islice(_outward(self), DEEPEST)


@dataclass(eq=False)
class Scope:
    """A region (a subprogram, a section; None: what is in none), its blocks and middles in order."""

    start: Placed | None
    end: Placed | None = None
    blocks: list[Block] = field(default_factory=list)
    middles: list[tuple[Placed, Block | None]] = field(default_factory=list)
    """The brackets that open nothing, each with the block directly around it."""


def scopes(brackets: Iterable[tuple[int, Bracket]]) -> tuple[Scope, ...]:
    """The scopes in order; what stands outside all regions is the first, in as many pieces as regions leave, joined."""
    return done(scoping(brackets))


def ready(analysis: Any) -> Iterator[None]:
    """Have an analysis find its scopes, in steps."""
    yield from analysis.scoping()


def scoping(brackets: Iterable[tuple[int, Bracket]]) -> Generator[None, None, tuple[Scope, ...]]:
    """The same, found in steps."""
    outside = Scope(None)
    found, scope = [outside], outside
    inner: Block | None = None
    for each in paced(brackets):
        if each is None:
            yield
            continue
        line, bracket = each
        placed = Placed(line, bracket)
        match bracket.role:
            case Role.OPEN:
                inner = Block(placed, inner, len(inner.middles) if inner else 0)
                scope.blocks.append(inner)
            case Role.CLOSE if inner is not None:
                inner.closer, inner = placed, inner.around
            case Role.REGION:
                inner, scope = None, Scope(placed)
                found.append(scope)
            case Role.END_REGION:
                scope.end, scope, inner = placed, outside, None
            case Role.MIDDLE:
                scope.middles.append((placed, inner))
                if inner is not None:
                    inner.middles.append(placed)
    return tuple(found)


def outward(block: Block | None) -> Iterator[Block]:
    """A block and those around it, innermost first; none outside all blocks."""
    return block.outward() if block is not None else iter(())


def _outward(block: Block | None) -> Iterator[Block]:
    while block is not None:
        yield block
        block = block.around
