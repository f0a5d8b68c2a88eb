"""A grammar's tables at work: one line in, its tree or where it stopped out. Never builds tables: Lark does (`grammar.py`).

The lexer is contextual, as Lark's: in each state it looks for the terminals that can stand
there, and only what is none of them is looked for among all.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import NamedTuple

from deburr_grammar.tree import Node, Token

END = "$END"
Part = Node | Token
Value = Part | list[Part]
"""What has been read on the way; a list is what a helper rule holds, whose parts go to the rule around it."""


class Rule(NamedTuple):
    """A rule: what it is to the rules around it, what its node is called, how many parts it takes, whether a single part stands for it, whether it only helps."""

    origin: str
    name: str
    size: int
    single: bool
    helper: bool


class Tables(NamedTuple):
    """What Lark makes of a grammar, in plain values; states and rules are numbers.

    ``actions``: of each state, what each terminal does: go to a state, or, as ``~rule``, finish a rule.
    ``gotos``: of each state, where a finished rule leads. ``scanners``: patterns whose groups are
    terminals; ``scanner``: which of them a state looks with. ``every``: the pattern of all
    terminals, ``spelled``: of some of them those that they are if they are spelled so.
    ``starts``: the first and the last state of each start rule.
    """

    actions: list[dict[str, int]]
    gotos: list[dict[str, int]]
    rules: list[tuple[str, str, int, bool, bool]]
    scanners: list[str]
    scanner: list[int]
    every: str
    spelled: dict[str, str]
    ignored: list[str]
    starts: dict[str, tuple[int, int]]
    flags: int


class Stopped(NamedTuple):
    """Where a line cannot be read on: the columns, the terminal found there ("" for none), what had been read, and the states of that."""

    start: int
    end: int
    found: str
    values: list[Value]
    states: list[int]


class _Way:
    """How far a line has been read: the states gone through, and what was read in each."""

    def __init__(self, parser: Parser, first: int) -> None:
        self._parser = parser
        self.states = [first]
        self.values: list[Value] = []

    def take(self, kind: str, start: int, end: int) -> bool:
        """Read a terminal; whether it can stand here."""
        states, actions = self.states, self._parser.actions
        while (action := actions[states[-1]].get(kind)) is not None:
            if action >= 0:
                states.append(action)
                self.values.append(Token(kind, start, end))
                return True
            self._finish(~action)
        return False

    def end(self, last: int) -> bool:
        """Finish all rules; whether the line may end here."""
        while self.states[-1] != last:
            action = self._parser.actions[self.states[-1]].get(END)
            if action is None or action >= 0:
                return False
            self._finish(~action)
        return True

    def _finish(self, number: int) -> None:
        origin, name, size, single, helper = self._parser.rules[number]
        states, values = self.states, self.values
        parts: list[Part] = []
        if size:
            for value in values[-size:]:
                if isinstance(value, list):
                    parts += value
                else:
                    parts.append(value)
            del states[-size:], values[-size:]
        states.append(self._parser.gotos[states[-1]][origin])
        if helper:
            values.append(parts)
        elif single and len(parts) == 1:
            values.append(parts[0])
        else:
            values.append(Node(name, parts[0].start if parts else 0, parts[-1].end if parts else 0, tuple(parts)))


class Parser:
    """Reads lines by tables."""

    def __init__(self, tables: Tables) -> None:
        self.actions = tables.actions
        self.gotos = tables.gotos
        self.rules = [Rule(*rule) for rule in tables.rules]
        self._tables = tables
        self._ignored = frozenset(tables.ignored)
        self._scan: list[Callable[[str, int], re.Match[str] | None] | None] = [None] * len(tables.actions)

    def parse(self, start: str, text: str) -> Part | Stopped:
        """The whole of a line under a start rule."""
        first, last = self._tables.starts[start]
        way = _Way(self, first)
        stopped = self._through(way, text)
        if stopped is None and not way.end(last):
            stopped = Stopped(len(text), len(text), END, way.values, way.states)
        if stopped is not None:
            return stopped
        (whole,) = way.values
        assert not isinstance(whole, list), "a start rule is no helper"
        return whole

    def following(self, start: str, text: str) -> frozenset[str]:
        """The terminals that could stand behind the start of a line; none if that itself cannot be read."""
        way = _Way(self, self._tables.starts[start][0])
        return frozenset() if self._through(way, text) is not None else self.accepted(way.states)

    def accepted(self, states: list[int]) -> frozenset[str]:
        """The terminals that could stand next. The lookahead sets of an LALR state hold too many, so each is tried."""
        return frozenset(name for name in self.actions[states[-1]] if self._fits(states, name))

    def _through(self, way: _Way, text: str) -> Stopped | None:
        at = 0
        while at < len(text):
            match = self._scanner(way.states[-1])(text, at)
            if match is None:
                return self._unknown(way, text, at)
            kind, end = match.lastgroup or "", match.end()
            if kind not in self._ignored and not way.take(kind, at, end):
                return Stopped(at, end, kind, way.values, way.states)
            at = end
        return None

    def _scanner(self, state: int) -> Callable[[str, int], re.Match[str] | None]:
        """How the terminals are found that can stand in a state; made when the state is first met."""
        scan = self._scan[state]
        if scan is None:
            # `re.compile` keeps its patterns, so states with the same terminals share one.
            pattern = self._tables.scanners[self._tables.scanner[state]]
            scan = self._scan[state] = re.compile(pattern, self._tables.flags).match
        return scan

    def _unknown(self, way: _Way, text: str, at: int) -> Stopped:
        """Nothing that could stand here does: what does, if it is anything."""
        while match := self._every.match(text, at):
            kind, end = match.lastgroup or "", match.end()
            if kind not in self._ignored:
                return Stopped(at, end, self._spelled(kind, match[0]), way.values, way.states)
            at = end
        return Stopped(at, at + 1, "", way.values, way.states)

    @cached_property
    def _every(self) -> re.Pattern[str]:
        return re.compile(self._tables.every, self._tables.flags)

    def _spelled(self, kind: str, said: str) -> str:
        """The terminal of a text: a keyword is one, though a more general terminal matches it too."""
        pattern = self._tables.spelled.get(kind)
        match = re.fullmatch(pattern, said, self._tables.flags) if pattern is not None else None
        return (match.lastgroup or kind) if match is not None else kind

    def _fits(self, states: list[int], terminal: str) -> bool:
        states = list(states)
        while (action := self.actions[states[-1]].get(terminal)) is not None:
            if action >= 0:
                return True
            rule = self.rules[~action]
            # The rule's parts leave the stack, the rule itself takes their place.
            del states[len(states) - rule.size :]
            states.append(self.gotos[states[-1]][rule.origin])
        return False


def read_parts(values: list[Value]) -> Iterator[Part]:
    """What was read before a line stopped. A helper rule is no part of the tree: only what it holds is."""
    for value in values:
        if isinstance(value, list):
            yield from value
        else:
            yield value
