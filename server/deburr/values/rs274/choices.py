"""RS274's conditions and loops as nodes: where they go on, what is learned there, and which ways nobody expects never to be taken (spec/rs274.md §6)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.finding import Severity
from deburr.values.graph import Calls, Dead, Env, Flows, Loop, Proof
from deburr.values.rs274.expressions import NEAR
from deburr.values.rs274.made import Block, Made
from deburr_grammar.dialects.rs274.outline import aborts
from deburr_grammar.tree import Node as Part
from deburr_grammar.tree import Token, walk

if TYPE_CHECKING:
    from deburr.values.rs274.lines import Taken

CONSTANT = "condition-constant"
IDLE = "loop-idle"


class Choices(Made):
    """A line that chooses where the routine goes on."""

    def _choose(self, number: int, block: Block) -> None:
        """A condition of an `if`. An `elseif` that only says what is left is no fault, nor a branch that stops the program or leaves a loop."""
        then, otherwise = self._builder.behind(self._at), self._otherwise(block, self._at)
        dead: tuple[Dead, ...] = ()
        is_last = otherwise == 2 * block.last + 1
        if not self._is_guard(block):
            dead = self._idle(then, "never holds here, so that what stands under it is never run", CONSTANT)
        if not is_last or number == 2 * self._at:
            always = "always holds here" + ("" if is_last else "; the branches behind it are never run")
            dead += self._idle(otherwise, always, CONSTANT, Severity.INFO)
        self._decide(number, then, otherwise, dead)

    def _decide(self, number: int, then: int, otherwise: int, dead: tuple[Dead, ...]) -> None:
        learned = self._compiled.ways
        condition = self._compiled.groups[0]

        def decided(env: Env, calls: Calls) -> Flows:
            held, failed = learned.of(env)
            ways = ((then, held), (otherwise, failed))
            return tuple([(to, changes.on(env)) for to, changes in ways if changes is not None])

        self._add(decided, condition=self._compiled.expressions.span(condition), number=number, dead=dead)

    def _repeat(self, block: Block) -> None:
        values, group = self._compiled.values, self._compiled.groups[0]
        body, behind = self._builder.behind(self._at), self._builder.behind(block.last)
        span, said = self._compiled.expressions.span(group), self._compiled.expressions.said(group)
        remarks: list[Proof] = []
        literal = all(part.kind != "param" for part in walk(group))

        def counted(env: Env, calls: Calls) -> Flows:
            remarks.clear()
            times = values.of(env)[0]
            if not literal and times.exact and abs(times.low - round(times.low)) > NEAR:
                message = (
                    f"`{said}` is {times.low:g} here, which is no integer; the control rounds it to {round(times.low)}"
                )
                remarks.append(Proof("repeat-fraction", span, message))
            ways = [(body, env)] if times.wild or times.high > 0.5 else []
            return (*ways, *([(behind, env)] if times.wild or times.low <= 0.5 else []))

        dead = self._idle(body, "is never more than 0 here, so that the loop makes no pass")
        self._builder.add(
            2 * self._at,
            self._at,
            counted,
            self._compiled.expressions,
            condition=span,
            dead=dead,
            remark=lambda: remarks[0] if remarks else None,
        )

    def _repeated(self, block: Block) -> None:
        ways = (2 * (block.first + 1), self._builder.behind(self._at))
        self._add(lambda env, calls: tuple((to, env) for to in ways))

    def _loop(self, block: Block, head: int, test: int) -> None:
        o_line = self._compiled.o_line
        assert o_line is not None, "a loop has an O-word"
        self._builder.loops.append(
            Loop(head, 2 * block.first, 2 * block.last, 2 * test, self._compiled.expressions.span(o_line), "limit")
        )

    def _idle(self, target: int, why: str, kind: str = IDLE, severity: Severity | None = None) -> tuple[Dead, ...]:
        """A way that this line's condition never goes. Of one without parameters, or with EXISTS, nobody expects that it hangs on anything."""
        group = self._compiled.groups[0]
        parts = {part.kind for part in walk(group)}
        if "param" not in parts or "exists" in parts or any(_is_chained(part) for part in walk(group)):
            return ()
        return (
            Dead(
                target,
                kind,
                self._compiled.expressions.span(group),
                f"`{self._compiled.expressions.said(group)}` {why}",
                severity,
            ),
        )

    def _is_guard(self, block: Block) -> bool:
        last = next((middle for middle in block.middles if middle > self._at), block.last)
        return any(_leaves(line) for line in self._builder.lines[self._at + 1 : last])

    def _otherwise(self, block: Block, at: int) -> int:
        """Where it goes on when the condition of a line does not hold."""
        other = next((middle for middle in block.middles if middle > at), None)
        if other is None:
            return 2 * block.last + 1
        bracket = self._builder.lines[other].bracket
        is_elseif = bracket is not None and bracket.word.upper() == "ELSEIF"
        return 2 * other + 1 if is_elseif else 2 * (other + 1)


def _leaves(line: Taken) -> bool:
    """Whether a line stops the program, or leaves a loop or subprogram: branches with one are there for what ought not to happen."""
    word = line.bracket.word.upper() if line.bracket is not None else ""
    return line.ends or word in ("BREAK", "RETURN") or aborts(line.node.text)


def _is_chained(part: Part | Token) -> bool:
    """Whether a comparison compares what another one says, which is a fault of its own."""
    return (
        isinstance(part, Part)
        and part.kind == "comparison"
        and any(side.kind == "comparison" for side in part.children)
    )
