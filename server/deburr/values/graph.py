"""The flow of one routine as data: nodes that turn the values before them into those behind them. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol

from deburr.finding import Severity
from deburr.values.domain import ANY, UNSET, Value, joined, widened
from deburr_grammar.text import Span

Key = Hashable
"""A variable as its language tells them apart."""
Env = dict[Key, Value]
"""What the variables hold at one point. Of one that is not there nothing is known."""
RETURN, STOP = -1, -2
"""Where a routine goes on in its caller, and where the whole program ends."""
Flows = Sequence[tuple[int, Env]]
"""The nodes that come next, each with the values that come there."""


class Telling:
    """A key that says itself what became of it where a chain of reasons comes by."""

    __slots__ = ()

    def told(self, value: Value) -> str:
        """What became of it, with the value that it has then."""
        raise NotImplementedError


class Proof(Exception):
    """What is certain to go wrong at a place: a rule's short name, the columns, and why in the user's words.

    ``used``: the variables that it hangs on. ``severity``: where it weighs less than its rule does elsewhere.
    """

    def __init__(
        self,
        kind: str,
        span: Span,
        message: str,
        used: frozenset[Key] = frozenset(),
        severity: Severity | None = None,
    ) -> None:
        super().__init__(message)
        self.kind = kind
        self.span = span
        self.message = message
        self.used = used
        self.severity = severity


class Summary(NamedTuple):
    """What is known of a routine that is called.

    ``env``: what the variables hold that it may set, when it returns; None: it does not return.
    ``touched`` and ``written``: the shared variables that concern it, and those that it may set, by itself and by its own calls; None: all.
    ``mentions``: the variables that it reads or sets itself; None: who knows which.
    """

    env: Env | None
    touched: frozenset[Key] | None
    written: frozenset[Key] | None
    mentions: frozenset[Key] | None


class Calls(Protocol):
    """What a node asks of the routines around it."""

    def call(self, label: str, arguments: Env, shared: Env) -> Summary | None:
        """Call a routine with arguments and with what all share; what is known of it by now. None: nobody can see what is called."""

    def again(self) -> None:
        """All calls come once more, now with what is really passed: what came before was a guess."""


def silent() -> None:
    """The remark of a node that never has one."""


class Dead(NamedTuple):
    """A way that a place ought to take now and then: where it leads, and what is said, by which rule, if no values ever go there.

    ``later``: it need not come next, but before the program ends.
    It is said only where that holds whatever the routine is called with and whatever is written where a variable
    is set once and for all: what hangs on these is a switch that somebody set on purpose.
    """

    target: int
    kind: str
    span: Span
    message: str
    severity: Severity | None = None
    later: bool = False


class Node(NamedTuple):
    """A point of a routine. ``line`` counts its lines; ``used`` and ``sets`` are the variables that it reads and sets.

    ``flow`` gives what comes next, and raises a `Proof` where nothing can. ``condition``: the columns of what decides here.
    ``doubtful``: whether something in it may fail on some way, after ``flow`` was asked. ``callee``: the routine that it calls, if that is known; ``calls``: whether it calls any.
    ``remark``: what is certain and does not stop the control, after ``flow`` was asked. ``part``: which of several nodes of its line it is.
    ``change``: what it makes of the values, if it only ever goes on to the next node: that is ``flow`` said shorter.
    """

    line: int
    flow: Callable[[Env, Calls], Flows]
    used: frozenset[Key] = frozenset()
    sets: frozenset[Key] = frozenset()
    condition: Span | None = None
    doubtful: Callable[[], bool] = bool
    callee: str | None = None
    calls: bool = False
    remark: Callable[[], Proof | None] = silent
    dead: tuple[Dead, ...] = ()
    part: int = 0
    change: Callable[[Env], Env] | None = None


class Head(NamedTuple):
    """Where a loop comes round: the last node of the loop, and whether a variable may be set in it."""

    last: int
    sets: Callable[[Key], bool]


class Loop(NamedTuple):
    """A loop: where it comes round, its first and last node, the node that decides, the columns of its command, and the rule of one that never ends."""

    head: int
    first: int
    last: int
    test: int
    span: Span
    kind: str


@dataclass(frozen=True, eq=False, slots=True)
class Graph:
    """A routine's flow: nodes under their numbers, in the order of lines; where it starts; at which of them it comes round again.

    ``locals``: variables that are its own and not set at first. ``mentions``: all that it reads or sets itself; ``reads`` and ``writes``:
    what it shares with others and reads or sets itself; None: who knows what. ``constants``: variables that are set at one place, and
    might as well have been given another value there. ``hasty``: it is so small, and calls so many, that it goes on with what is known of
    those that were gone through before, and once more when more is known. ``family``: what it has in common with what it was before
    an edit; None: nobody asks. ``step``: from the number of a line's node to that of the next one. ``hidden``: the variables that a node may read and
    set without saying so; None: who knows which. ``memo``: room for what others derive from it alone.
    """

    nodes: Mapping[int, Node]
    heads: Mapping[int, Head]
    loops: Sequence[Loop]
    locals: frozenset[Key]
    mentions: frozenset[Key] | None
    reads: frozenset[Key] | None
    writes: frozenset[Key] | None
    callees: frozenset[str]
    constants: frozenset[Key] = frozenset()
    hasty: bool = False
    family: Hashable = None
    step: int = 1
    hidden: frozenset[Key] | None = None
    memo: dict[str, Any] = field(default_factory=dict)


def join(one: Env, two: Env, may_differ: Callable[[Key], bool] | None = None) -> Env:
    """What holds on both ways; of variables that cannot differ on them, what holds on the first."""
    return one if one is two else _merged(one, two, joined, may_differ)


def widen(old: Env, new: Env) -> Env:
    """What holds on both ways and comes to rest."""
    return _merged(old, new, widened)


def _merged(
    one: Env, two: Env, merge: Callable[[Value, Value], Value], may_differ: Callable[[Key], bool] | None = None
) -> Env:
    """What is made of the values of both; the first itself where that is the same."""
    get = two.get
    found = None
    # Most values are the same object on both ways: only the others are looked at.
    for key in [key for key, value in one.items() if get(key) is not value]:
        if may_differ is not None and not may_differ(key):
            continue
        value, other = one[key], get(key)
        both = ANY if other is None else merge(value, other)
        if both is value:
            continue
        if found is None:
            found = one.copy()
        if both == ANY:
            del found[key]
        else:
            found[key] = both
    return one if found is None else found


def joined_all(envs: Iterable[Env]) -> Env | None:
    """What holds on all ways; None: there is none."""
    found: Env | None = None
    for env in envs:
        found = env if found is None or found is env else join(found, env)
    return found


def unset(keys: Iterable[Key], certain: bool) -> Env:
    """Variables at the start: certainly without a value, or with any or none."""
    value = UNSET if certain else ANY._replace(unset=True)
    # Sets of names have another order in each process: what is said in the order of values must not.
    return dict.fromkeys(sorted(keys, key=str), value)
