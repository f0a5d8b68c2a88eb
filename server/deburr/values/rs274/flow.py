"""The flow of an RS274 main program or subprogram as a graph: lines, blocks, loops, calls and returns (spec/rs274.md §6). Solves nothing.

Lines have even numbers. A condition of `elseif` has the odd one behind its line, because who comes to the line itself comes from a branch that ran;
to that of `endif` come those for whom no condition held.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Hashable, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from deburr.steps import FEW, paced
from deburr.values.graph import Calls, Dead, Env, Flows, Graph, Head, Loop, Node, Proof, silent
from deburr.values.rs274.commands import Commands
from deburr.values.rs274.keys import ANYTHING, is_shared, shared
from deburr.values.rs274.made import Block, Torn
from deburr_grammar.dialect import Role
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.values.rs274.expressions import Expressions
    from deburr.values.rs274.lines import Taken

STEP = 2
"""From the number of a line's node to that of the next one."""
_SHARED = 1_024
"""So many ways that lead on are kept, whatever line they are behind."""


class Builder:
    """Builds one routine's graph."""

    def __init__(
        self,
        lines: Sequence[Taken],
        end: int,
        settings: Mapping[str, Any],
        block_delete: bool | None,
        numbered: frozenset[str],
    ) -> None:
        """``end``: where the routine goes on behind its last line; ``numbered``: the programs that M98 finds in the same file and nowhere else."""
        self.lines = lines
        self.settings = settings
        self.delete = block_delete
        self.end = end
        self.numbered = numbered
        self._nodes: dict[int, Node] = {}
        self.blocks: dict[int, Block] = {}
        self.loops: list[Loop] = []
        self.heads: dict[int, int] = {}
        self.callees: set[str] = set()
        self._used: set[Hashable] = set()
        self._sets: Counter[Hashable] = Counter()
        """What is set, with the number of lines that do so."""

    def graph(self) -> Generator[None, None, Graph]:
        """The routine's flow, built in steps."""
        self._pair()
        for each in paced(enumerate(self.lines), FEW):
            if each is None:
                yield
            else:
                self._take(*each)
        everything = self._used | self._sets.keys()
        own = frozenset(key for key in everything if isinstance(key, str) and not is_shared(key) and key != ANYTHING)
        return Graph(
            self._nodes,
            {head: self._head(head, last) for head, last in self.heads.items() if head in self._nodes},
            tuple(loop for loop in self.loops if loop.head in self._nodes),
            own,
            None if None in everything else frozenset(everything),
            shared(self._used),
            shared(set(self._sets)),
            frozenset(self.callees),
            frozenset(key for key, times in self._sets.items() if times == 1),
            step=STEP,
            hidden=frozenset(),
        )

    def _head(self, first: int, last: int) -> Head:
        inside = [self._nodes[at] for at in range(first, last + 1) if at in self._nodes]
        sets = frozenset(key for node in inside for key in node.sets)
        numbers, calls = None in sets, any(node.calls for node in inside)
        anything = ANYTHING in sets

        def may_set(key: Hashable) -> bool:
            return anything or key in sets or (numbers and isinstance(key, int)) or (calls and is_shared(key))

        return Head(last, may_set)

    def _pair(self) -> None:
        around: list[Block] = []
        for at, line in enumerate(self.lines):
            bracket = line.bracket
            if bracket is None or bracket.role in (Role.REGION, Role.END_REGION):
                continue
            if bracket.label is None or "DELETE" in line.node.kinds or line.node.problems:
                raise Torn
            if bracket.role is Role.OPEN:
                around.append(Block(bracket.kind, bracket.label, at))
                self.blocks[at] = around[-1]
            elif bracket.role is Role.CLOSE and around:
                self.blocks[at] = around.pop()
                self.blocks[at].last = at
            elif bracket.kind != "sub":
                self.blocks[at] = self._middle(around, bracket.kind, bracket.label, at)
        if around:
            raise Torn

    def _middle(self, around: list[Block], kind: str, label: str, at: int) -> Block:
        if kind == "if" and around and around[-1].kind == "if" and around[-1].label == label:
            around[-1].middles.append(at)
            return around[-1]
        for block in reversed(around):
            if block.kind in ("while", "do") and block.label == label:
                return block
        raise Torn

    def _take(self, at: int, line: Taken) -> None:
        commands = Commands(self, at, line)
        command = line.bracket.word.upper() if line.bracket is not None else ""
        if line.node.problems:
            commands.unread()
        elif line.bracket is not None:
            commands.command(command)
        elif line.is_start:
            commands.start()
        elif "o_line" in line.node.kinds:
            commands.call()
        elif line.enters:
            commands.enter()
        else:
            commands.block()

    def behind(self, at: int) -> int:
        """The node of the next line, or where the routine ends."""
        return 2 * (at + 1) if at + 1 < len(self.lines) else self.end

    def add(
        self,
        number: int,
        at: int,
        flow: Callable[[Env, Calls], Flows],
        expressions: Expressions,
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        callee: str | None = None,
        calls: bool = False,
        dead: tuple[Dead, ...] = (),
        remark: Callable[[], Proof | None] = silent,
        change: Callable[[Env], Env] | None = None,
    ) -> None:
        """Take a node in, whose flow says whether it is doubtful. ``sets``: what it may set; None among them: who knows which number."""
        used, to_set = frozenset(expressions.used), frozenset(sets)
        self._used |= used
        if to_set:
            self._sets.update(to_set)
        self._nodes[number] = Node(
            at, flow, used, to_set, condition, expressions.is_doubtful, callee, calls, remark, dead, change=change
        )

    def jump(self, number: int, at: int, to: int, condition: Span | None = None) -> None:
        """Take a node in that only goes on elsewhere."""
        change = _same if to == number + STEP else None
        self._nodes[number] = Node(at, _to(to), condition=condition, change=change)


def _same(env: Env) -> Env:
    return env


@lru_cache(maxsize=_SHARED)
def _to(to: int) -> Callable[[Env, Calls], Flows]:
    return lambda env, calls: ((to, env),)
