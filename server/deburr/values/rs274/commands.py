"""What RS274's lines do, as nodes of a graph: settings and words, blocks, calls, returns (spec/rs274.md §4.3, §6). Knows no other line but through its block."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from deburr.values.graph import RETURN, STOP, Calls, Env, Flows, Proof
from deburr.values.rs274.choices import Choices
from deburr.values.rs274.compiled import Acts
from deburr.values.rs274.entering import Entering
from deburr.values.rs274.keys import ANYTHING, put
from deburr_grammar.dialects.rs274.outline import aborts


class Executed:
    """The flow of a line that is always run: that of most nodes, so it is one object and no function with its own room."""

    __slots__ = ("_acts", "_behind")

    def __init__(self, acts: Acts, behind: int) -> None:
        self._acts = acts
        self._behind = behind

    def __call__(self, env: Env, calls: Calls) -> Flows:
        """What comes next."""
        return ((self._behind, self.change(env)),)

    def change(self, env: Env) -> Env:
        """What it makes of the values."""
        return put(env, self._acts.of(env))


class Commands(Choices, Entering):
    """What the lines do: one of them."""

    def unread(self) -> None:
        """A line that cannot be read: the control stops there, or whoever mends it may set anything."""
        expressions, behind = self._compiled.expressions, self._builder.behind(self._at)

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
        node = self._line.node
        deleted = self._builder.delete if "DELETE" in node.kinds else False
        if "PERCENT" in node.kinds or deleted is True:
            # The first percent sign frames the program, the second ends it; what follows that one is not read.
            self._jump(self._builder.behind(self._at))
            return
        acts, sets = self._compiled.acts
        behind, stopping = self._behind(), aborts(node.text)
        if deleted is None or stopping:
            self._perhaps(acts, sets, (behind, STOP) if stopping else (behind,), deleted is None)
        elif acts is None:
            self._jump(behind)
        else:
            executed = Executed(acts, behind)
            change = executed.change if behind == 2 * (self._at + 1) else None
            self._add(executed, sets, change=change)

    def _perhaps(self, acts: Acts | None, sets: Sequence[Hashable], ways: tuple[int, ...], deleted: bool) -> None:
        """A line that may be passed over, or stop the program: of several comments only the last one acts."""
        expressions, passed = self._compiled.expressions, self._builder.behind(self._at)

        def executed(env: Env, calls: Calls) -> Flows:
            found = put(env, acts.of(env)) if acts is not None else env
            return tuple((to, found) for to in ways)

        def maybe(env: Env, calls: Calls) -> Flows:
            try:
                return (*executed(env, calls), (passed, env))
            except Proof:
                expressions.doubtful = True
                return ((passed, env),)

        self._add(maybe if deleted else executed, sets)

    def _behind(self) -> int:
        if self._line.ends:
            return STOP
        return self._builder.end if self._line.returns else self._builder.behind(self._at)

    def _return(self) -> None:
        values = self._compiled.values

        def returned(env: Env, calls: Calls) -> Flows:
            values.of(env)
            return ((RETURN, env),)

        self._add(returned)

    def _sub(self) -> None:
        o_line = self._compiled.o_line
        span = self._compiled.expressions.span(o_line) if o_line is not None else None
        self._jump(self._builder.behind(self._at), condition=span)
