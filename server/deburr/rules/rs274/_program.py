"""What rules on the whole program share: its subs and blocks, and where calls and parameters stand in them. Never opens a file."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from heapq import merge
from math import inf
from operator import attrgetter, itemgetter
from typing import Any

from deburr.analysis import Analysis
from deburr.arithmetic.rs274 import constant
from deburr.rules.rs274._held import Call, Held, Use, holding
from deburr.steps import FEW, done, kept, paced
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from deburr_grammar.structure import Fault
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

__all__ = ["Block", "Call", "Program", "Sub", "Use", "program_of"]

_MEMO, _WRITTEN = "rs274 program", "rs274 written condition"
_LOOPS = frozenset(("while", "do", "repeat"))
_TORN = frozenset((Fault.REGION_UNOPENED, Fault.REGION_UNCLOSED, Fault.REGION_NESTED, Fault.REGION_MISMATCH))


@dataclass(eq=False)
class Block:
    """A block from its first to its last line, the branches in it and the block around it; subs in between do not matter."""

    kind: str
    start: int
    around: Block | None
    end: float = inf
    branches: list[int] = field(default_factory=list)
    certain: bool = field(init=False)
    """Whether it is run at least once whenever it is reached: a `do` in nothing but such."""
    outermost: bool = field(init=False)
    """Whether it is a loop in no other."""
    in_loop: bool = field(init=False)

    def __post_init__(self) -> None:
        self.certain = self.kind == "do" and (self.around is None or self.around.certain)
        self.in_loop = self.around is not None and (self.around.in_loop or self.around.kind in _LOOPS)
        self.outermost = self.kind in _LOOPS and not self.in_loop


@dataclass(eq=False)
class Sub:
    """A subprogram: its label, its lines, the block of the main program that it stands in.

    ``flow``: the main program comes by its first line, so that it is known from there on.
    ``returns``: the lines of returns, and of program ends, that are in no block; ``exits``: all of them.
    """

    label: str | None
    start: int
    span: Span
    inside: Block | None
    flow: bool
    end: float = inf
    closed: bool = False
    returns: list[int] = field(default_factory=list)
    exits: list[int] = field(default_factory=list)


class Program:
    """A program by itself."""

    def __init__(self, document: Document, settings: Mapping[str, Any], held: Held) -> None:
        self.document = document
        self._settings = settings
        self._held: Held = held
        self.subs: list[Sub] = []
        self.ended: float = inf
        """The line at which the main program ends for certain."""
        self._exits: list[int] = []
        """The lines at which the main program may end."""
        self._blocks: list[Block] = []
        self._around: dict[int, Block | None] = {}
        self._starts: list[int] = []
        self._dead: list[tuple[int, float]] = []
        """What is never run, from its first line up to but without its last: branches and loops whose condition is written out as false."""

    @classmethod
    def making(cls, document: Document, settings: Mapping[str, Any]) -> Generator[None, None, Program]:
        """A program, made in steps."""
        held = yield from holding(document, settings)
        program = cls(document, settings, held)
        yield from program._sweep()
        program._starts = [sub.start for sub in program.subs]
        program._dead = yield from program._all_dead()
        return program

    @property
    def calls(self) -> list[Call]:
        """All calls in order."""
        return self._held.calls

    @property
    def uses(self) -> list[Use]:
        """All parameters in order of lines."""
        return self._held.uses

    @property
    def percents(self) -> list[int]:
        """The lines of `%`."""
        return self._held.percents

    @property
    def bare(self) -> list[tuple[int, str | None]]:
        """The lines of O-words without a command, with their labels: where M98 goes to."""
        return self._held.bare

    @cached_property
    def sound(self) -> bool:
        """Whether it is certain where subs begin and end."""
        return not any(fault.fault in _TORN for fault in self.document.faults)

    @cached_property
    def by_label(self) -> dict[str, list[Sub]]:
        """The subs under their labels."""
        found: dict[str, list[Sub]] = {}
        for sub in self.subs:
            if sub.label is not None:
                found.setdefault(sub.label, []).append(sub)
        return found

    @cached_property
    def computed(self) -> bool:
        """Whether there is a sub whose label only the run knows."""
        return any(sub.label is None for sub in self.subs)

    @cached_property
    def calls_by_sub(self) -> dict[Sub | None, list[Call]]:
        """The calls in each sub and, under None, in the main program."""
        found: dict[Sub | None, list[Call]] = {}
        for call in self.calls:
            found.setdefault(self.sub_at(call.line), []).append(call)
        return found

    def sub_at(self, line: int) -> Sub | None:
        """The sub that a line stands in; None in the main program."""
        at = bisect_right(self._starts, line) - 1
        return self.subs[at] if at >= 0 and line <= self.subs[at].end else None

    def uses_in(self, sub: Sub) -> list[Use]:
        """The parameters in a sub, in order of lines."""
        first = bisect_left(self.uses, sub.start, key=attrgetter("line"))
        return self.uses[first : bisect_right(self.uses, sub.end, lo=first, key=attrgetter("line"))]

    def around(self, call: Call) -> Block | None:
        """The block directly around a call."""
        return self._around.get(call.line)

    def is_certain(self, call: Call) -> bool:
        """Whether a call is made each time the sub or main program it stands in is run that far."""
        block, sub = self.around(call), self.sub_at(call.line)
        exits = self._exits if sub is None else sub.exits
        if (block is not None and not block.certain) or (exits and exits[0] < call.line):
            return False
        return "DELETE" not in self.document.node(call.line).kinds

    def loop_end(self, line: int) -> float:
        """The last line of the outermost loop around a line; the line itself outside of loops."""
        at = bisect_right(self._loop_starts, line) - 1
        return max(line, self._loops[at].end) if at >= 0 else line

    def passed_over(self, line: int) -> bool:
        """Whether a line stands in a block that is never run, whatever the values are."""
        at = bisect_right(self._dead_starts, line) - 1
        return at >= 0 and line < self._dead[at][1]

    @cached_property
    def has_main(self) -> bool:
        """Whether anything is done outside of subs, other than to end the program."""
        return any(self._acts(line) for line in self._outside())

    def _outside(self) -> Iterator[int]:
        line = 0
        for sub in self.subs:
            yield from range(line, sub.start)
            line = sub.start if sub.end == inf else int(sub.end)
            line += 1
        if not self.subs or self.subs[-1].end < inf:
            yield from range(line, self.document.line_count)

    def _acts(self, line: int) -> bool:
        node = self.document.node(line)
        if node.kinds.isdisjoint(("word", "setting", "CALL")) and not node.problems:
            return False
        return line not in self._held.ends

    @cached_property
    def _loops(self) -> list[Block]:
        """The outermost loops of the main program and of each sub."""
        return [block for block in self._blocks if block.outermost]

    @cached_property
    def _loop_starts(self) -> list[int]:
        return [block.start for block in self._loops]

    def _all_dead(self) -> Generator[None, None, list[tuple[int, float]]]:
        stretches: list[tuple[int, float]] = []
        for block in paced(self._blocks, FEW):
            if block is None:
                yield
            else:
                stretches += self._never(block)
        found: list[tuple[int, float]] = []
        reach: float = -1
        for start, end in sorted(stretches):
            if start > reach:
                found.append((start, end))
                reach = end
        return found

    @cached_property
    def _dead_starts(self) -> list[int]:
        return [start for start, _ in self._dead]

    def _never(self, block: Block) -> Iterator[tuple[int, float]]:
        if block.kind not in ("if", "while", "repeat"):
            return
        taken = False
        for start, end in zip([block.start, *block.branches], [*block.branches, block.end], strict=True):
            value = None if taken else self._condition(start)
            if taken or value == 0:
                yield start + 1, end
            taken = taken or (value is not None and value != 0)

    def _condition(self, line: int) -> float | None:
        node = self.document.node(line)
        # What hangs on a parameter has no value that is written out, whatever its numbers are.
        written = node.shape.memo.get(_WRITTEN)
        if written is None:
            group = _group(LineNode(node.shape.text, node.reading, node.shape))
            written = node.shape.memo[_WRITTEN] = (
                group is not None and "#" not in node.shape.text[group.start : group.end]
            )
        group = _group(node) if written else None
        value = constant(node.text, group, self._settings) if group is not None else None
        return value if isinstance(value, float) else None

    def _sweep(self) -> Iterator[None]:
        """Go through brackets, calls and program ends in the order of their lines."""
        calls = ((call.line, call) for call in self.calls)
        ends = ((line, None) for line in self._held.ends)
        events: Iterator[tuple[int, Bracket | Call | None]]
        events = merge(self.document.brackets(), calls, ends, key=itemgetter(0))
        sub: Sub | None = None
        outer: Block | None = None
        inner: Block | None = None
        for each in paced(events):
            if each is None:
                yield
                continue
            line, event = each
            if isinstance(event, Call):
                self._around[line] = inner
            elif event is None:
                self._end(line, sub, inner)
            elif event.role is Role.REGION:
                if sub is None:
                    outer = inner
                sub, inner = self._start(line, event, outer), None
            elif event.role is Role.END_REGION:
                if sub is not None:
                    sub.end, sub.closed = line, True
                    sub, inner = None, outer
            else:
                inner = self._block(line, event, sub, inner)

    def _start(self, line: int, bracket: Bracket, outer: Block | None) -> Sub:
        if self.subs and self.subs[-1].end == inf:
            self.subs[-1].end = line - 1
        self.subs.append(Sub(bracket.label, line, bracket.span, outer, line < self.ended))
        return self.subs[-1]

    def _end(self, line: int, sub: Sub | None, inner: Block | None) -> None:
        (self._exits if sub is None else sub.exits).append(line)
        if inner is None and sub is not None:
            sub.returns.append(line)
        elif inner is None:
            self.ended = min(self.ended, line)

    def _block(self, line: int, bracket: Bracket, sub: Sub | None, inner: Block | None) -> Block | None:
        if bracket.role is Role.OPEN:
            self._blocks.append(Block(bracket.kind, line, inner))
            return self._blocks[-1]
        if bracket.role is Role.CLOSE and inner is not None:
            inner.end = line
            return inner.around
        if bracket.word in ("else", "elseif") and inner is not None:
            inner.branches.append(line)
        elif bracket.word == "return" and sub is not None:
            sub.exits.append(line)
            sub.returns += [line] if inner is None else []
        return inner


def program_of(analysis: Analysis) -> Program:
    """The program that is checked."""
    return done(making(analysis))


def making(analysis: Analysis) -> Generator[None, None, Program]:
    """The program that is checked, made in steps and kept with the analysis."""
    return kept(analysis.memo, _MEMO, lambda: Program.making(analysis.document, analysis.settings))


def ready(analysis: Analysis) -> Iterator[None]:
    """Make the program, in steps."""
    yield from making(analysis)


def _group(node: LineNode) -> Node | None:
    """The brackets of an O-word's value."""
    o_line = next(node.find("o_line"), None)
    return next((part for part in o_line.nodes() if part.kind == "group"), None) if o_line is not None else None
