"""What all nodes of RS274's lines are made with: the line, its parts and the builder that takes nodes in. Knows no command."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING

from deburr.values.graph import Calls, Dead, Env, Flows
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.values.rs274.expressions import Expressions
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

    def __init__(self, builder: Builder, at: int, line: Taken, expressions: Expressions) -> None:
        self._builder = builder
        self._at = at
        self._line = line
        self._expressions = expressions
        self._o_line = next(line.node.find("o_line"), None)
        self._groups = (
            [part for part in self._o_line.nodes() if part.kind == "group"] if self._o_line is not None else []
        )

    def _add(
        self,
        flow: Callable[[Env, Calls], Flows],
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        number: int | None = None,
        dead: tuple[Dead, ...] = (),
    ) -> None:
        number = 2 * self._at if number is None else number
        self._builder.add(number, self._at, flow, self._expressions, sets, condition, dead=dead)

    def _jump(self, to: int, number: int | None = None) -> None:
        self._add(lambda env, calls: ((to, env),), number=number)
