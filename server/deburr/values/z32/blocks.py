"""What an ISO block of Z32 does, as a node of a graph: its words store from left to right, M2, M30 and G26 end (spec/z32.md §6.1, §6.5). Knows no other line but through its builder."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import constant
from deburr.values.graph import RETURN, STOP, Calls, Env, Flows
from deburr.values.z32.expressions import ALIAS, Expressions, Get, Unread, named, put
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.values.z32.flow import Builder
    from deburr.values.z32.lines import Taken

_ENDS = (2.0, 30.0)
"""M2 and M30."""
_KNOWN = frozenset(("word", "g_word", "axis_alias", "nword", "COMMENT", "DELETE", "SEMI", "REST", "TAIL", "text", "section", "config", "PERCENT"))  # fmt: skip


class Block:
    """A block: one of them."""

    def __init__(self, builder: Builder, at: int, line: Taken) -> None:
        self._builder = builder
        self._at = at
        self._text = line.node.text
        self._tree = line.node.tree
        self._expressions = Expressions(self._text, builder.world)
        self._steps: list[Callable[[Env], Env]] = []
        self._ends = self._returns = False
        self._codes: list[Get] = []
        """M codes that are calculated: they may be M2 or M30."""

    def add(self) -> None:
        """Take the block in as a node."""
        for part in self._tree.children:
            self._take(part)
        builder, at, expressions = self._builder, self._at, self._expressions
        left, behind = builder.leaving(at), builder.behind(at)
        steps, codes, ends, returns = self._steps, self._codes, self._ends, self._returns

        def executed(env: Env, calls: Calls) -> Flows:
            values = [get(env) for get in codes]
            for step in steps:
                env = step(env)
            stops = ((STOP, env),) if ends or any(value.has(end) for value in values for end in _ENDS) else ()
            if ends or any(value.exact and value.low in _ENDS for value in values):
                return stops
            return (*stops, *(((RETURN, env),) if returns else left(behind, env)))

        ways = () if ends else (RETURN,) if returns else builder.exits(at, [behind])
        title = next((part for part in self._tree.children if part.kind == "section"), None)
        named = title is not None and at == 0 and builder.only_called
        condition = Span(title.start, title.end) if named and title is not None else None
        builder.add(builder.first(at), at, executed, expressions, ways, condition=condition)

    def _take(self, part: Node | Token) -> None:
        if part.kind not in _KNOWN:
            raise Unread
        if not isinstance(part, Node):
            return
        if part.kind == "axis_alias":
            self._alias(self._text[part.start : part.end].upper()[-3:])
        elif part.kind == "g_word":
            self._returns = self._returns or part.children[0].kind == "G26"
        elif part.kind == "word":
            self._word(*part.children)

    def _alias(self, axes: str) -> None:
        if not axes.isalpha() or not axes.isascii():
            raise Unread
        value = named(axes)
        self._expressions.sets.add(ALIAS)
        self._steps.append(lambda env: put(env, ALIAS, value))

    def _word(self, target: Node | Token, value: Node | Token) -> None:
        expressions = self._expressions
        if self._text[target.start : target.end].upper() == "M":
            literal = constant(self._text, value) if value.kind != "angle" else None
            self._ends = self._ends or literal in _ENDS
            if literal is None:
                self._codes.append(expressions.value(value))
        self._steps.append(expressions.assigned(target, value))
