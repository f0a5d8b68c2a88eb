"""What RS274's lines do, as nodes of a graph: settings and words, blocks, calls, returns (spec/rs274.md §4.3, §6). Knows no other line but through its block."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING

from deburr.values.graph import RETURN, STOP, Calls, Env, Flows, Proof
from deburr.values.rs274.choices import Choices
from deburr.values.rs274.entering import Entering
from deburr.values.rs274.keys import ANYTHING, put, set_by
from deburr_grammar.dialects.rs274.outline import aborts
from deburr_grammar.text import Span
from deburr_grammar.tree import Node as Part

if TYPE_CHECKING:
    from deburr.values.rs274.expressions import Get


class Commands(Choices, Entering):
    """What the lines do: one of them."""

    def unread(self) -> None:
        """A line that cannot be read: the control stops there, or whoever mends it may set anything."""
        expressions, behind = self._expressions, self._builder.behind(self._at)

        def passed(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            return ((behind, {}),)

        expressions.used.add(None)
        self._add(passed, (None, ANYTHING))

    def command(self, word: str) -> None:
        """A line that opens, closes, branches, leaves or goes on."""
        builder, at = self._builder, self._at
        block = builder.blocks.get(at)
        match word:
            case "SUB":
                self._sub()
            case "RETURN" | "ENDSUB":
                self._return()
            case "IF" if block is not None:
                self._choose(2 * at, block)
            case "ELSEIF" | "ELSE" if block is not None:
                self._jump(2 * block.last)
                if word == "ELSEIF":
                    self._choose(2 * at + 1, block)
            case "ENDIF" if block is not None:
                self._jump(builder.behind(at))
                self._jump(builder.behind(at), 2 * at + 1)
            case "WHILE" if block is not None and block.first == at:
                builder.heads[2 * at] = 2 * block.last
                never = "never holds when the program comes here, so that the loop makes no pass"
                self._decide(
                    2 * at, builder.behind(at), builder.behind(block.last), self._idle(builder.behind(at), never)
                )
                self._loop(block, 2 * at, at)
            case "WHILE" if block is not None:
                builder.heads[2 * (block.first + 1)] = 2 * block.last
                never = "never holds here, so that the loop makes one pass only"
                first = 2 * (block.first + 1)
                self._decide(2 * at, first, builder.behind(at), self._idle(first, never))
                self._loop(block, 2 * (block.first + 1), at)
            case "ENDWHILE" if block is not None:
                self._jump(2 * block.first)
            case "REPEAT" if block is not None:
                self._repeat(block)
            case "ENDREPEAT" if block is not None:
                builder.heads[2 * (block.first + 1)] = 2 * block.last
                self._repeated(block)
            case "BREAK" if block is not None:
                self._jump(builder.behind(block.last))
            case "CONTINUE" if block is not None:
                self._jump(2 * (block.last if block.kind == "do" else block.first))
            case _:
                self._jump(builder.behind(at))

    def start(self) -> None:
        """An O-word alone, with which a program starts that is called by its number."""
        self._jump(self._builder.behind(self._at))

    def block(self) -> None:
        """A line that sets parameters and moves the machine."""
        node, expressions = self._line.node, self._expressions
        settings: list[tuple[Callable[[Env], tuple[Hashable, ...] | None], Get]] = []
        words: list[Get] = []
        sets: list[Hashable] = []
        for part in (child.children[0] for child in node.tree.nodes() if child.kind == "item"):
            if isinstance(part, Part) and part.kind == "setting" and isinstance(param := part.children[0], Part):
                settings.append((expressions.target(param), expressions.value(part.children[2])))
                sets.append(set_by(expressions, param))
            elif isinstance(part, Part) and part.kind == "word":
                words.append(expressions.value(part.children[1]))
        behind = self._behind()
        deleted = self._builder.delete if "DELETE" in node.kinds else False
        percent, stopping = "PERCENT" in node.kinds, aborts(node.text)

        def executed(env: Env, calls: Calls) -> Flows:
            puts = [(target(env), get(env)) for target, get in settings]
            for get in words:
                get(env)
            found = put(env, puts)
            # Of several comments only the last one acts.
            return ((behind, found), (STOP, found)) if stopping else ((behind, found),)

        def maybe(env: Env, calls: Calls) -> Flows:
            passed = (self._builder.behind(self._at), env)
            try:
                return (*executed(env, calls), passed)
            except Proof:
                expressions.doubtful = True
                return (passed,)

        if percent:
            # The first one frames the program, the second ends it; what follows that one is not read.
            self._jump(self._builder.behind(self._at))
        elif deleted is True:
            self._jump(self._builder.behind(self._at))
        else:
            self._add(executed if deleted is False else maybe, sets)

    def _behind(self) -> int:
        if self._line.ends:
            return STOP
        return self._builder.end if self._line.returns else self._builder.behind(self._at)

    def _return(self) -> None:
        values = [self._expressions.value(group) for group in self._groups]

        def returned(env: Env, calls: Calls) -> Flows:
            for get in values:
                get(env)
            return ((RETURN, env),)

        self._add(returned)

    def _sub(self) -> None:
        o_line, behind = self._o_line, self._builder.behind(self._at)
        span = Span(o_line.start, o_line.end) if o_line is not None else None
        self._add(lambda env, calls: ((behind, env),), condition=span)
