"""What all nodes of RS274's lines are made with: the line, its parts and the builder that takes nodes in. Knows no command."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING

from deburr.values.graph import Calls, Dead, Env, Flows
from deburr.values.rs274.compiled import Compiled, compiled
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.values.rs274.flow import Builder
    from deburr.values.rs274.lines import Taken


class Torn(Exception):
    """Inside this package: nothing can be said of the program, because its flow hangs on what nobody can see."""


class Block:
    """A block: what opens it, and the positions of its lines in the routine."""

    def __init__(self, kind: str, label: str | None, first: int) -> None:
        self.kind = kind
        self.label = label
        self.first = first
        self.middles: list[int] = []
        self.last = first


class Made:
    """One line of which nodes are made."""

    def __init__(self, builder: Builder, at: int, line: Taken) -> None:
        self._builder = builder
        self._at = at
        self._line = line

    @property
    def _compiled(self) -> Compiled:
        """What the line asks of values; of one that only leads on nobody wants to know."""
        return compiled(self._line, self._builder.settings)

    def _add(
        self,
        flow: Callable[[Env, Calls], Flows],
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        number: int | None = None,
        dead: tuple[Dead, ...] = (),
        change: Callable[[Env], Env] | None = None,
    ) -> None:
        number = 2 * self._at if number is None else number
        expressions = self._compiled.expressions
        self._builder.add(number, self._at, flow, expressions, sets, condition, dead=dead, change=change)

    def _jump(self, to: int, number: int | None = None, condition: Span | None = None) -> None:
        """Go on elsewhere, whatever the values are."""
        self._builder.jump(2 * self._at if number is None else number, self._at, to, condition)
