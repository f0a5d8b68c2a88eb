"""What an ISO block of Z32 does, as a node of a graph: its words store from left to right, M2, M30 and G26 end (spec/z32.md §6.1, §6.5). Knows no other line but through its builder."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.values.graph import RETURN, STOP, Calls, Env, Flows
from deburr.values.z32.expressions import ALIAS, Expressions, Get, Unread, named
from deburr.values.z32.storing import put
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.values.z32.flow import Builder
    from deburr.values.z32.lines import Taken
    from deburr.values.z32.text import Text

_ENDS = (2.0, 30.0)
"""M2 and M30."""
_KNOWN = frozenset(("word", "g_word", "axis_alias", "nword", "COMMENT", "DELETE", "SEMI", "REST", "TAIL", "text", "section", "config", "PERCENT"))  # fmt: skip


def add_block(builder: Builder, at: int, line: Taken) -> None:
    """Take a block in as a node."""
    node, said = line.node, builder.made(at).text
    expressions, (block, change) = builder.made(at).part(
        0, lambda found: _Block(node.shape.tree(node.reading), found).bound
    )
    left, behind = builder.leaving(at), builder.behind(at)
    ends, returns = block.ends, block.returns
    number, codes, steps = builder.first(at), block.codes, block.steps
    condition = said.span(block.title) if block.title is not None and at == 0 and builder.only_called else None
    ways = () if ends else (RETURN,) if returns else builder.exits(at, [behind])
    if change is not None and not builder.is_end(at):
        to = RETURN if returns else behind
        builder.add_change(number, at, to, change, expressions, ways, condition=condition, sure=not steps)
        return

    def executed(env: Env, calls: Calls) -> Flows:
        expressions.text = said
        values = [get(env) for get in codes]
        for step in steps:
            env = step(env)
        stops = ((STOP, env),) if ends or any(value.has(end) for value in values for end in _ENDS) else ()
        if ends or any(value.exact and value.low in _ENDS for value in values):
            return stops
        return (*stops, *(((RETURN, env),) if returns else left(behind, env)))

    builder.add(number, at, executed, expressions, ways, condition=condition)


class _Block:
    """What the words of the blocks of a shape calculate and store."""

    def __init__(self, tree: Node, expressions: Expressions) -> None:
        self._expressions = expressions
        self.steps: list[Callable[[Env], Env]] = []
        self.ends = self.returns = False
        self.codes: list[Get] = []
        """M codes that are calculated: they may be M2 or M30."""
        self.title: Node | Token | None = None
        """The name of the section that it starts."""
        for part in tree.children:
            self._take(part)
        self._bind = expressions.in_turn(self.steps) if not (self.ends or self.codes) else None

    def bound(self, text: Text) -> tuple[_Block, Callable[[Env], Env] | None]:
        """It, and what a line makes of the values; None where it may end the program."""
        return self, self._bind(text) if self._bind is not None else None

    def _take(self, part: Node | Token) -> None:
        if part.kind not in _KNOWN:
            raise Unread
        if part.kind == "section" and self.title is None:
            self.title = part
        if not isinstance(part, Node):
            return
        if part.kind == "axis_alias":
            self._alias(self._expressions.said(part).upper()[-3:])
        elif part.kind == "g_word":
            self.returns = self.returns or part.children[0].kind == "G26"
        elif part.kind == "word":
            self._word(*part.children)

    def _alias(self, axes: str) -> None:
        if not axes.isalpha() or not axes.isascii():
            raise Unread
        value = named(axes)
        self._expressions.sets.add(ALIAS)
        self.steps.append(lambda env: put(env, ALIAS, value))

    def _word(self, target: Node | Token, value: Node | Token) -> None:
        expressions = self._expressions
        if expressions.said(target).upper() == "M":
            literal = expressions.text.constant(value) if value.kind != "angle" else None
            self.ends = self.ends or literal in _ENDS
            if literal is None:
                self.codes.append(expressions.value(value))
        step = expressions.assigned(target, value)
        if expressions.follows(target) or isinstance(value, Node):
            self.steps.append(step)
