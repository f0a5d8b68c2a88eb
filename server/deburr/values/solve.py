"""One routine's values at each of its nodes: round after round until nothing grows, then back to what loops really leave. Knows no language."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence

from deburr.values.graph import (
    RETURN,
    STOP,
    Calls,
    Env,
    Flows,
    Graph,
    Key,
    Node,
    Proof,
    join,
    joined_all,
    silent,
    widen,
)
from deburr.values.region import Outcome, Parts, Region, calling, regions

_PATIENCE = 2
"""Rounds in which a loop's values may grow as they like; after that they go to resting places."""
_BACK = 4
"""Rounds back at each node. The values of each round are true, so that any number will do."""
_ENTRY = -3
_PACE = 100
"""Nodes between two moments at which the work can be left: some milliseconds' worth."""


class Solution:
    """The values before each node that can be reached, and what leaves the routine."""

    def __init__(
        self,
        graph: Graph,
        entry: Env,
        calls: Calls,
        forgotten: frozenset[Key] = frozenset(),
        earlier: Solution | None = None,
    ) -> None:
        """``forgotten``: variables of which nothing is known behind the places that set them. ``earlier``: of the routine before an edit."""
        self.graph = graph
        self._forgotten = forgotten
        self._calls = calls
        self._came: dict[int, dict[int, Env]] = {node: {} for node in (*graph.nodes, RETURN, STOP)}
        self._targets: dict[int, tuple[int, ...]] = {}
        self._rounds: Counter[int] = Counter()
        self._done = 0
        """Nodes that were gone through."""
        self._waiting = bytearray(max(graph.nodes, default=RETURN) + 1)
        """1 at each node that is to be gone through: the first one is found faster than in any other way."""
        self.before: dict[int, Env] = {}
        self.proofs: dict[int, Proof] = {}
        """What is certain to go wrong at a node that can be reached."""
        self.remarks: dict[int, Proof] = {}
        """What is certain there and does not stop the control."""
        self.doubtful: set[int] = set()
        """The nodes at which something may go wrong."""
        self._entry = entry
        self._is_resumed = earlier is not None and self._resumed(earlier)
        if not self._is_resumed:
            first = min(graph.nodes, default=RETURN)
            self._came[first][_ENTRY] = entry
            self._queue(first)

    def _resumed(self, earlier: Solution) -> bool:
        """Go on from the values before an edit, if that is less work. Where nothing comes round, each node hangs on those above it alone."""
        nodes, known = self.graph.nodes, earlier.graph.nodes
        same = {node for node, here in nodes.items() if known.get(node) is here}
        if (
            any(graph.heads or graph.callees for graph in (self.graph, earlier.graph))
            or 2 * len(same) < len(nodes)
            or min(nodes, default=RETURN) != min(known, default=RETURN)
            or (self._forgotten, self._entry) != (earlier._forgotten, earlier._entry)
        ):
            return False
        self._take(earlier)
        for node in [node for node in (*nodes, *(known.keys() - nodes.keys())) if node not in same]:
            self._forget(node)
        return True

    def _take(self, earlier: Solution) -> None:
        """All that was known before an edit."""
        for node, came in earlier._came.items():
            if node in self._came:
                self._came[node] = came.copy()
        self._targets.update(earlier._targets)
        self.before.update(earlier.before)
        self.proofs.update(earlier.proofs)
        self.remarks.update(earlier.remarks)
        self.doubtful |= earlier.doubtful

    def _forget(self, node: int) -> None:
        """Nothing is known of a node that is another one now, or gone: it is gone through, and so are those to which it led."""
        for target in self._targets.pop(node, ()):
            if target in self._came:
                self._came[target].pop(node, None)
                self._queue(target)
        for found in (self.before, self.proofs, self.remarks):
            found.pop(node, None)
        self.doubtful.discard(node)
        if node in self.graph.nodes:
            self._queue(node)

    def steps(self) -> Iterator[None]:
        """Find them, in work that can be left at each step. What is behind a loop is gone through with what the loop really leaves."""
        for region in regions(self.graph):
            yield from self._follow(region.first - 1, self._grown)
            outside = joined_all(self._came[region.first].values())
            is_entered_inside = self._waiting.find(1, region.first + 1, region.last + 1) >= 0
            key = None if is_entered_inside else region.key(outside, self._forgotten)
            known = region.found
            if key is not None and outside is not None and known is not None and known.key == key:
                self._take_over(region, known, outside)
                yield
                continue
            yield from self._loop(region)
            if key is not None:
                region.found = self._outcome(region, key)
        yield from self._follow(max(self.graph.nodes, default=RETURN), self._grown)
        if self.graph.heads:
            self._calls.again()
            for node in calling(self.graph):
                if node in self.before:
                    self._flows(node, self.before[node])
        if self._is_resumed:
            self.before = dict(sorted(self.before.items()))
        del self._calls

    def _loop(self, region: Region) -> Iterator[None]:
        """Go round the loops of a region until they rest, and back to what they really leave."""
        yield from self._follow(region.last, self._grown)
        self._rounds.clear()
        for head in region.heads:
            self._queue(head)
        yield from self._follow(region.last, self._settled)
        self._rounds.clear()

    def _outcome(self, region: Region, key: object) -> Outcome:
        """What came of a region, as far as it concerns it."""
        nodes = [node for node in range(region.first, region.last + 1) if node in self.before]
        parts = Parts(region.keys)
        return Outcome(
            key,
            [(node, parts.add(self.before[node]), self._ways(node, parts)) for node in nodes],
            parts.envs,
            {node: self.proofs[node].with_traceback(None) for node in nodes if node in self.proofs},
            {node: self.remarks[node].with_traceback(None) for node in nodes if node in self.remarks},
            self.doubtful.intersection(nodes),
        )

    def _ways(self, node: int, parts: Parts) -> Sequence[tuple[int, int]]:
        return [(target, parts.add(self._came[target][node])) for target in self._targets.get(node, ())]

    def _take_over(self, region: Region, known: Outcome, outside: Env) -> None:
        """A region to which the same came before, in all that concerns it."""
        rest = {key: value for key, value in outside.items() if key not in region.keys}
        envs = [{**rest, **env} for env in known.envs]
        for node, before, ways in known.nodes:
            self.before[node] = envs[before]
            self._waiting[node] = 0
            self._targets[node] = tuple([target for target, _ in ways])
            for target, env in ways:
                self._came[target][node] = envs[env]
                if target > region.last:
                    self._waiting[target] = 1
        self.proofs.update(known.proofs)
        self.remarks.update(known.remarks)
        self.doubtful |= known.doubtful

    @property
    def returned(self) -> Env | None:
        """What it returns with; None: it does not return."""
        return joined_all(self._came[RETURN].values())

    @property
    def ending(self) -> Env | None:
        """What it ends the program with; None: it does not."""
        return joined_all(self._came[STOP].values())

    @property
    def ends(self) -> bool:
        """Whether any way comes to its end, or to that of the program."""
        return bool(self._came[RETURN] or self._came[STOP])

    def targets(self, node: int) -> tuple[int, ...]:
        """Where a node may go on."""
        return self._targets.get(node, ())

    def sources(self, node: int) -> Iterable[int]:
        """From where a node may be reached."""
        return [source for source in self._came[node] if source != _ENTRY]

    def entering(self, head: int) -> Env | None:
        """What comes to the head of a loop from outside of it; None: nothing does."""
        last = self.graph.heads[head].last
        return joined_all(env for source, env in self._came[head].items() if not head <= source <= last)

    def _queue(self, node: int) -> None:
        if node >= 0:
            self._waiting[node] = 1

    def _follow(self, last: int, now: Callable[[int], Env | None]) -> Iterator[None]:
        """Go on with all that waits up to a node: the first one first, so that a loop comes to rest before what is behind it."""
        waiting, nodes, heads, before = self._waiting, self.graph.nodes, self.graph.heads, self.before
        all_came, step = self._came, self.graph.step
        while (node := waiting.find(1, 0, last + 1)) >= 0:
            waiting[node] = 0
            came = all_came[node]
            if node in heads:
                env = now(node)
            elif len(came) == 1:
                (env,) = came.values()
            else:
                env = joined_all(came.values())
            old = before.get(node)
            while env is not old and env != old:
                here = nodes[node]
                self._done += 1
                if self._done % _PACE == 0 or here.calls:
                    yield
                if env is None or here.change is None or self._forgotten:
                    self._pass(node, env)
                    break
                env = self._go_on(node, here, here.change, env)
                node += step
                if env is None or node > last:
                    break
                waiting[node], old = 0, None

    def _grown(self, head: int) -> Env | None:
        """What comes to the head of a loop; where it comes round, with all that came before, so that it comes to rest."""
        new = self._met(head)
        if new is None or (old := self.before.get(head)) is None:
            return new
        self._rounds[head] += 1
        return (widen if self._rounds[head] > _PATIENCE else join)(old, new)

    def _settled(self, head: int) -> Env | None:
        """What comes to a head now that nothing grows: it forgets the resting places that no way leads to."""
        self._rounds[head] += 1
        if self._rounds[head] > _BACK:
            return self.before.get(head)
        return self._met(head)

    def _met(self, head: int) -> Env | None:
        """What comes to the head of a loop from all sides. Round the loop nothing comes that is not set in it: it is what it was before."""
        last, sets = self.graph.heads[head]
        outside = inside = None
        for source, env in self._came[head].items():
            if head <= source <= last:
                inside = env if inside is None else join(inside, env)
            else:
                outside = env if outside is None else join(outside, env)
        return outside if outside is None or inside is None else join(outside, inside, sets)

    def _pass(self, node: int, env: Env | None) -> None:
        """Send values through a node. What that changes is gone through next."""
        if env is None:
            del self.before[node]
            self.proofs.pop(node, None)
            self.remarks.pop(node, None)
            self.doubtful.discard(node)
            flows: Flows = ()
        else:
            self.before[node] = env
            flows = self._flows(node, env)
        targets = (flows[0][0],) if len(flows) == 1 else tuple([target for target, _ in flows])
        old = self._targets.get(node, ())
        if targets != old:
            self._targets[node] = targets
            for gone in old:
                if gone not in targets:
                    del self._came[gone][node]
                    self._queue(gone)
        for target, values in flows:
            came = self._came[target]
            known = came.get(node)
            if known is not values and known != values:
                came[node] = values
                if known is None and self._is_resumed:
                    # As if all of them had come now, one after the other.
                    self._came[target] = dict(sorted(came.items()))
                if target >= 0:
                    self._waiting[target] = 1

    def _go_on(self, node: int, here: Node, change: Callable[[Env], Env], env: Env) -> Env | None:
        """The same where it only goes on to the next node: most do. What comes there, if that is new and comes from nowhere else."""
        try:
            values = change(env)
        except Proof:
            self._pass(node, env)
            return None
        self.before[node] = env
        if node in self.proofs:
            del self.proofs[node]
        self._note(node, here)
        following = node + self.graph.step
        self._targets[node] = (following,)
        came = self._came[following]
        known = came.get(node)
        if known is values or known == values:
            return None
        came[node] = values
        self._waiting[following] = 1
        return values if len(came) == 1 and following not in self.graph.heads else None

    def _flows(self, node: int, env: Env) -> Flows:
        """What comes next, to each node once."""
        here = self.graph.nodes[node]
        try:
            flows = here.flow(env, self._calls)
        except Proof as proof:
            flows, self.proofs[node] = (), proof
        else:
            if node in self.proofs:
                del self.proofs[node]
        self._note(node, here)
        if self._forgotten and (gone := self._forgotten & here.sets):
            flows = [(to, {key: value for key, value in values.items() if key not in gone}) for to, values in flows]
        return flows if len(flows) < 2 else _once(flows)

    def _note(self, node: int, here: Node) -> None:
        """What a node says of itself now that it was gone through."""
        if here.remark is not silent:
            if (remark := here.remark()) is not None and node not in self.proofs:
                self.remarks[node] = remark
            else:
                self.remarks.pop(node, None)
        if here.doubtful is not bool:
            (self.doubtful.add if here.doubtful() else self.doubtful.discard)(node)


def _once(flows: Flows) -> Flows:
    """Each node once, with what comes there on all ways."""
    found: dict[int, Env] = {}
    for target, values in flows:
        found[target] = join(found[target], values) if target in found else values
    return tuple(found.items())
