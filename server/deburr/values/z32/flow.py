"""The flow of one Z32 program as a graph: lines and their fields in order, jumps, ranges that return, the loops that jumps back make (spec/z32.md §6). Solves nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Callable, Generator, Hashable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.z32 import NEAR_INTEGER
from deburr.steps import FEW, paced
from deburr.values.domain import ANY, UNSET, exactly
from deburr.values.graph import RETURN, Calls, Dead, Env, Flows, Graph, Head, Loop, Node, Proof, silent
from deburr.values.z32.blocks import add_block
from deburr.values.z32.expressions import Expressions, Unread, World
from deburr.values.z32.fields import Fields
from deburr.values.z32.lines import Taken
from deburr.values.z32.made import Made, made
from deburr_grammar.text import Span
from deburr_grammar.tree import Node as Part
from deburr_grammar.tree import Token

if TYPE_CHECKING:
    from deburr.values.domain import Value

UNSEEN = " "
"""The name of a program that is called and that only the run knows. No file's program has it."""
_DEEP = ANY._replace(unset=True)
"""Who knows how many returns wait for a block, and where they lead."""
_UNREADABLE = frozenset(("bad_number", "loose", "stray", "reserved", "movement", "mixed", "computed"))
_MOST = 100_000
"""Ways of computed jumps; a program with more is not looked at."""


class Torn(Exception):
    """Inside this package: nothing can be said of the program, because its flow hangs on what nobody can see."""


class Site(NamedTuple):
    """A jump with a return: its number among those of its last block, that block, and the node to which it returns."""

    number: float
    end: int
    returns: int


class Builder:
    """Makes the graph of one program. ``called``: the program that a call leads to, or `UNSEEN`; by the text of its line and the column."""

    def __init__(
        self,
        lines: Sequence[Taken],
        world: World,
        delete: bool | None,
        called: Mapping[tuple[str, int], str],
        only_called: bool,
    ) -> None:
        """``only_called``: whether its first line starts a section that nothing runs into."""
        self.lines = lines
        self.world = world
        self.delete = delete
        self.called = called
        self.only_called = only_called
        self.callees: set[str] = set()
        self._made = [made(world, line.node) for line in lines]
        self._backs: list[Loop] = []
        self._nodes: dict[int, Node] = {}
        self._ways: dict[int, set[int]] = {}
        self._first: list[int] = []
        self._labels: dict[float, list[int]] = {}
        self._targets: dict[tuple[float, bool, int], Sequence[int]] = {}
        self._sections = [at for at, line in enumerate(lines) if line.section is not None]
        self._sites: dict[tuple[int, int], Site] = {}
        self._ends: dict[int, list[Site]] = {}
        self._used: set[Hashable] = set()
        self._sets: Counter[Hashable] = Counter()
        self._literals: Counter[Hashable] = Counter()
        """How often each is set to a number that is written out."""

    def graph(self) -> Generator[None, None, Graph]:
        """The program's flow, built in steps."""
        yield from self._place()
        for each in paced(enumerate(self.lines), FEW):
            if each is None:
                yield
            else:
                self._take(*each)
        yield
        heads: dict[int, Head] = {}
        for number, head in self._heads():
            heads[number] = head
            yield
        everything = self._used | self._sets.keys()
        returns = frozenset[Hashable](("returns", end) for end in self._ends)
        graph = Graph(
            self._nodes,
            heads,
            tuple(loop for loop in self._backs if self._counts(loop)),
            returns,
            None if None in everything else frozenset(everything),
            None if None in self._used else frozenset(self._used),
            None if None in self._sets else frozenset(self._sets),
            frozenset(self.callees),
            frozenset(key for key in self._sets if self._is_constant(key)),
            hidden=returns,
        )
        # What the nodes do may ask the builder: it does not hold them, so that they go with the graph.
        self._nodes = {}
        return graph

    def behind(self, at: int) -> int:
        """The first node of the next line, or where the program ends."""
        return self._first[at + 1] if at + 1 < len(self.lines) else RETURN

    def first(self, at: int) -> int:
        """The first node of a line."""
        return self._first[at]

    def made(self, at: int) -> Made:
        """What is made of a line's text."""
        return self._made[at]

    def targets(self, at: int, value: float, near: bool) -> Sequence[int]:
        """The lines of a block number, as a jump on a line finds them. Sections have numbers of their own."""
        section = bisect_right(self._sections, at)
        found = self._targets.get((value, near, section))
        if found is None:
            rows = [row for number in self._numbers(value, near) for row in self._labels[number]]
            own = [row for row in rows if bisect_right(self._sections, row) == section]
            found = self._targets[value, near, section] = own or rows if len(rows) > 1 else rows
        return found

    def labelled(self, value: Value) -> list[float]:
        """The block numbers among a range of values."""
        return [each for each in self._labels if value.low - NEAR_INTEGER <= each <= value.high + NEAR_INTEGER]

    def site(self, at: int, field: Part) -> Site | None:
        """What is known of a jump with a return; None: its last block does not exist here."""
        return self._sites.get((at, field.start))

    def leaving(self, at: int) -> Callable[[int, Env], Flows]:
        """What becomes of a way that leaves a line: behind the last block of a range the newest return happens that waits for it."""
        sites = self._ends.get(at)
        if sites is None:
            return lambda to, env: ((to, env),)
        key = ("returns", at)

        def left(to: int, env: Env) -> Flows:
            value = env.get(key, _DEEP)
            then = {**env, key: UNSET if value.low > 0 else _DEEP}
            back = [(site.returns, then) for site in sites if value.has(site.number)]
            return ((to, env), *back) if value.unset else back

        return left

    def pushed(self, env: Env, site: Site) -> Env:
        """The values behind a jump that is to come back."""
        key = ("returns", site.end)
        return {**env, key: exactly(site.number) if env.get(key, _DEEP) == UNSET else _DEEP}

    def is_end(self, at: int) -> bool:
        """Whether a line is the last one of a range."""
        return at in self._ends

    def only_stops(self, at: int) -> bool:
        """Whether all that happens from a line on is that the program ends: who jumps there guards against something."""
        lines = self.lines[at : at + 3]
        end = next((line for line in lines if "M_END" in line.node.kinds), None)
        return end is not None and all("advanced" not in line.node.kinds for line in lines[: lines.index(end)])

    def exits(self, at: int, to: Iterable[int]) -> set[int]:
        """All nodes to which ways may lead that leave a line for others."""
        return {*to, *(site.returns for site in self._ends[at])} if at in self._ends else set(to)

    def add(
        self,
        number: int,
        at: int,
        flow: Callable[[Env, Calls], Flows],
        expressions: Expressions,
        ways: Iterable[int],
        *,
        condition: Span | None = None,
        callee: str | None = None,
        calls: bool = False,
        dead: tuple[Dead, ...] = (),
        sure: bool = False,
        change: Callable[[Env], Env] | None = None,
    ) -> None:
        """Take a node in. ``ways``: all nodes that may come next. ``sure``: nothing can go wrong in it. ``change``: as of a `Node`."""
        part = number - self._first[at]
        if part == 0 and "DELETE" in self.lines[at].node.kinds and self.delete is not False:
            flow, ways, dead = self._optional(at, flow, expressions), {*ways, *self.exits(at, [self.behind(at)])}, ()
            sure, change = False, None

        used, sets = expressions.touched()
        self._used |= used
        for key in sets:
            self._sets[key] += 1
            if key in expressions.literals:
                self._literals[key] += 1
        self._ways[number] = ways if isinstance(ways, set) else set(ways)
        # What changes values only says of itself whether it is doubtful, and has no remarks.
        flowing = flow if sure or change is not None else _flowing(flow, expressions)
        doubtful = bool if sure else expressions.is_doubtful
        remark = silent if sure or change is not None else expressions.remark
        self._nodes[number] = Node(
            at, flowing, used, sets, condition, doubtful, callee, calls, remark, dead, part, change
        )

    def add_change(
        self,
        number: int,
        at: int,
        to: int,
        change: Callable[[Env], Env],
        expressions: Expressions,
        ways: Iterable[int],
        *,
        condition: Span | None = None,
        sure: bool = False,
    ) -> None:
        """Take a node in that goes on to one place only, with what it makes of the values."""
        following = change if to == number + 1 and expressions.is_narrow else None

        def changed(env: Env, calls: Calls) -> Flows:
            return ((to, change(env)),)

        self.add(number, at, changed, expressions, ways, condition=condition, sure=sure, change=following)

    def back(self, number: int, to: int, test: int, span: Span) -> None:
        """Note a jump back that an IF decides: it makes a loop."""
        self._backs.append(Loop(to, to, number, test, span, "limit"))

    def _is_constant(self, key: Hashable) -> bool:
        """Whether a parameter is a switch: it is set to numbers that are written out, and to nothing else."""
        return key is not None and self._sets[key] == self._literals[key]

    def _counts(self, loop: Loop) -> bool:
        """Whether anything in a loop sets what its condition asks for; where nothing does, an option decides."""
        used = self._nodes[loop.test].used
        inside = (self._nodes[at] for at in range(loop.first, loop.last + 1) if at in self._nodes)
        return any(None in node.sets or not used.isdisjoint(node.sets) for node in inside)

    def _optional(
        self, at: int, flow: Callable[[Env, Calls], Flows], expressions: Expressions
    ) -> Callable[[Env, Calls], Flows]:
        """A line that the operator may leave out."""
        left, behind, always = self.leaving(at), self.behind(at), self.delete

        def maybe(env: Env, calls: Calls) -> Flows:
            passed = left(behind, env)
            if always:
                return passed
            try:
                return (*flow(env, calls), *passed)
            except Proof:
                expressions.doubtful = True
                return passed
            finally:
                expressions.remarks.clear()

        return maybe

    def _place(self) -> Iterator[None]:
        """Number the nodes, and find what jumps name."""
        number = 0
        for each in paced(enumerate(self.lines)):
            if each is None:
                yield
                continue
            at, line = each
            self._first.append(number)
            number += max(1, self._made[at].fields) + len(self._made[at].ranges)
            if line.label is not None:
                self._labels.setdefault(line.label, []).append(at)
        self._sorted = sorted(self._labels)
        for at in range(len(self.lines)):
            for number, jump in enumerate(self._made[at].ranges, self._first[at] + self._made[at].fields):
                self._place_range(at, jump, number)
        if any(at in self._ends for at, _ in self._sites):
            raise Torn

    def _place_range(self, at: int, jump: Part, returns: int) -> None:
        last = jump.node("range_end")
        assert last is not None, "only ranges are placed"
        part = last.children[1]
        value = self._made[at].text.constant(part)
        if value is None:
            raise Torn
        ends = self.targets(at, value, part.kind == "angle")
        if len(ends) == 1:
            sites = self._ends.setdefault(ends[0], [])
            site = self._sites[at, jump.start] = Site(len(sites) + 1.0, ends[0], returns)
            sites.append(site)

    def _numbers(self, value: float, near: bool) -> Sequence[float]:
        if value in self._labels or not near:
            return (value,) if value in self._labels else ()
        at = bisect_left(self._sorted, value - NEAR_INTEGER)
        found = self._sorted[at] if at < len(self._sorted) else None
        return (found,) if found is not None and found <= value + NEAR_INTEGER else ()

    def _take(self, at: int, line: Taken) -> None:
        try:
            if line.node.problems or not _UNREADABLE.isdisjoint(line.node.kinds):
                raise Unread
            if "advanced" in line.node.kinds:
                Fields(self, at, line).add()
            else:
                add_block(self, at, line)
        except Unread:
            self._unread(at, line)

    def _unread(self, at: int, line: Taken) -> None:
        """A line that cannot be read: the control stops there, or whoever mends it may set anything."""
        expressions = Expressions(self._made[at].text, self.world)
        expressions.used.add(None)
        expressions.sets.add(None)
        left, behind = self.leaving(at), self.behind(at)

        def passed(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            return left(behind, {key: value for key, value in env.items() if not isinstance(key, str)})

        self.add(self._first[at], at, passed, expressions, self.exits(at, [behind]), calls=True)

    def _heads(self) -> Iterable[tuple[int, Head]]:
        """The nodes to which ways lead back. What is not set between such a node and the last way back is what it was before, if nothing comes in from elsewhere."""
        back: dict[int, int] = {}
        entering: list[tuple[int, int]] = []
        for number in sorted(self._nodes):
            for to in self._ways[number]:
                if to <= number and to in self._nodes:
                    back[to] = number
                if to >= 0 and to != number + 1:
                    entering.append((to, number))
        entering.sort()
        if len(entering) > _MOST:
            raise Torn
        for head, last in back.items():
            yield head, self._head(head, last, entering)

    def _head(self, head: int, last: int, entering: Sequence[tuple[int, int]]) -> Head:
        first, behind = bisect_left(entering, (head + 1, -1)), bisect_left(entering, (last + 1, -1))
        inside = range(head, last + 1)
        if any(source not in inside for _, source in entering[first:behind]):
            # Ways come in past the head: all that comes is looked at together.
            return Head(head - 1, lambda key: True)
        nodes = [self._nodes[at] for at in inside if at in self._nodes]
        sets = frozenset(key for node in nodes for key in node.sets)
        anything = None in sets or any(node.calls for node in nodes)
        return Head(last, lambda key: anything or key in sets or not isinstance(key, str))


def _flowing(flow: Callable[[Env, Calls], Flows], expressions: Expressions) -> Callable[[Env, Calls], Flows]:
    def flowing(env: Env, calls: Calls) -> Flows:
        expressions.doubtful = False
        expressions.remarks.clear()
        return flow(env, calls)

    return flowing


def places(parts: Iterable[Part | Token]) -> Span:
    """From the first of some parts to the last."""
    found = list(parts)
    return Span(found[0].start, found[-1].end)
