"""The rules that are on for a program, sorted by what triggers them. Never reads a program."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any, NamedTuple

from deburr.catalogue import rules_of
from deburr.finding import Severity
from deburr.rule import (
    Line,
    Long,
    Modal,
    Moved,
    Nodes,
    Noticed,
    Report,
    Rule,
    Structure,
    Syntax,
    Text,
    Whole,
    covers,
)
from deburr.stateful import STEPS, Stateful, stateful_of
from deburr_grammar.dialect import Dialect, Reading
from deburr_grammar.document import Piece
from deburr_grammar.line import LineNode, Shape

_LINES = 4_096
"""How many are kept; whoever has more forgets all."""
_PLANS = "plans"
_SETS = 8
"""Plans that a shape keeps, of as many rule sets and readings."""


class Searched(NamedTuple):
    """A pattern, and characters with one of which every match starts (none given: anything)."""

    pattern: str
    signs: str = ""

    def lines(self, text: str) -> Iterator[int]:
        """The lines of a text that hold a match, counted from its first."""
        line, at, last = 0, 0, -1
        for place in sorted(self._starts(text)):
            line += text.count("\n", at, place)
            at = place
            if line != last:
                last = line
                yield line

    def found(self, text: str) -> bool:
        """Whether there is a match."""
        return next(self._starts(text), None) is not None

    def _starts(self, text: str) -> Iterator[int]:
        if not self.signs:
            yield from (match.start() for match in re.finditer(self.pattern, text, re.M))
        for sign in self.signs:
            at = text.find(sign)
            # `re` keeps what it has compiled: where there is no sign nothing is.
            match_at = re.compile(self.pattern, re.M).match if at >= 0 else None
            while at >= 0 and match_at is not None:
                match = match_at(text, at)
                if match is not None:
                    yield at
                at = text.find(sign, at + 1 if match is None else max(match.end(), at + 1))


class RuleSet:
    """The rules that are on, their severities, and the dialect's settings. Findings are kept under it, so make one and use it again."""

    def __init__(
        self,
        dialect: Dialect,
        settings: Mapping[str, Any] | None = None,
        selected: Callable[[Rule], bool] = lambda rule: rule.default,
        severities: Mapping[str, Severity] | None = None,
        machine: Mapping[str, Any] | None = None,
        steps: int = STEPS,
    ) -> None:
        self.dialect = dialect
        self.machine: Mapping[str, Any] = machine or {}
        """What `[machine]` says, key by key; what is not said is not there."""
        self.steps = steps
        """How many steps of shapes under modal state are kept with it."""
        defaults = {setting.name: setting.default for setting in dialect.settings}
        self.settings: Mapping[str, Any] = {**defaults, **(settings or {})}
        self._all = rules_of(dialect.name)
        self.rules = tuple(rule for rule in self._all if selected(rule))
        self._severities = dict(severities or {})
        self._said: dict[tuple[str, str], tuple[tuple[Rule, Report], ...]] = {}
        self._plans = object()
        """Under this shapes keep what is planned for them, and so do not keep the rule set itself."""

    def severity(self, rule: Rule, said: Severity | None = None) -> Severity:
        """The severity of a rule's findings, or of one of which the rule ``said`` another."""
        return self._severities.get(rule.name, said or rule.severity)

    def knows(self, name: str) -> bool:
        """Whether a name or prefix means any rule of the dialect, on or off."""
        return any(covers(name, rule.name) for rule in self._all)

    def named(self, short: str) -> Rule | None:
        """The rule of a short name, on or off."""
        return self._by_short.get(short)

    def speaks(self, name: str) -> bool:
        """Whether all that a name or prefix is expected to mean is on: only then does silence say something."""
        meant = {rule for rule in self._all if rule.name == name or (rule.default and covers(name, rule.name))}
        return bool(meant) and meant <= set(self.rules)

    def plan(self, shape: Shape, reading: Reading) -> tuple[Rule, ...]:
        """The rules that may have something to say of lines of a shape: decided once a shape."""
        plans = shape.memo.setdefault(_PLANS, {})
        assert isinstance(plans, dict)
        key = self._plans, reading.name
        plan: tuple[Rule, ...] | None = plans.get(key)
        if plan is None:
            planned = self._planned(shape, reading)
            if len(plans) >= _SETS:
                # Those of rule sets that are gone, for the most part: a changed configuration makes new ones.
                plans.clear()
            plan = plans[key] = planned
        return plan

    def _planned(self, shape: Shape, reading: Reading) -> tuple[Rule, ...]:
        facts = shape.facts(reading)
        problems = {problem.kind for problem in facts.problems}
        plan = [
            rule for rule in self._on_parts if rule.short in problems or not facts.kinds.isdisjoint(self._kinds[rule])
        ]
        # A shape is a line of its own, and the sample of all lines that share it.
        sample = LineNode(shape.text, reading, shape)
        return tuple(rule for rule in plan if self._may_speak(rule, sample))

    def _may_speak(self, rule: Rule, sample: LineNode) -> bool:
        if not isinstance(rule.trigger, Nodes):
            return True
        if (where := rule.trigger.where) is not None:
            line = Line(sample, self.settings)
            return any(where(line, part) for part in sample.find(*rule.trigger.kinds))
        return not rule.trigger.by_shape or any(self.on_line(sample, (rule,)))

    def said(self, piece: Piece, index: int) -> tuple[tuple[Rule, Report], ...]:
        """What the planned rules say of a line of a chunk. It hangs on its text alone, and many lines are written more than once."""
        key = (piece.chunk.line(index), piece.outlined.reading(index).name)
        said = self._said.get(key)
        if said is None:
            if len(self._said) >= _LINES:
                self._said.clear()
            node = piece.node(index)
            said = self._said[key] = tuple(self.on_line(node, self.plan(node.shape, node.reading)))
        return said

    def on_line(self, node: LineNode, plan: tuple[Rule, ...], ending: str = "") -> Iterator[tuple[Rule, Report]]:
        """What the planned rules say of a line."""
        line = Line(node, self.settings, ending)
        for rule in plan:
            if isinstance(rule.trigger, Syntax):
                for problem in node.problems:
                    if problem.kind == rule.short:
                        yield from ((rule, report) for report in rule.check(line, problem))
            if rule in self._kinds:
                for part in node.find(*self._kinds[rule]):
                    yield from ((rule, report) for report in rule.check(line, part))
            else:
                yield from ((rule, report) for report in rule.check(line))

    @cached_property
    def _by_short(self) -> Mapping[str, Rule]:
        return {rule.short: rule for rule in self._all}

    @cached_property
    def on_text(self) -> tuple[tuple[Rule, Searched], ...]:
        """Rules on the text of lines, with what is searched for."""
        triggers = ((rule, rule.trigger) for rule in self.rules)
        return tuple(
            (rule, Searched(trigger.pattern, trigger.signs)) for rule, trigger in triggers if isinstance(trigger, Text)
        )

    @cached_property
    def on_length(self) -> tuple[tuple[Rule, int], ...]:
        """Rules on long lines, with the length beyond which they speak."""
        return tuple((rule, rule.trigger.characters) for rule in self.rules if isinstance(rule.trigger, Long))

    @cached_property
    def on_structure(self) -> tuple[Rule, ...]:
        """Rules on faults of structure."""
        return tuple(rule for rule in self.rules if isinstance(rule.trigger, Structure))

    @cached_property
    def on_whole(self) -> tuple[Rule, ...]:
        """Rules on the program as a whole."""
        return tuple(rule for rule in self.rules if isinstance(rule.trigger, Whole))

    @cached_property
    def on_modal(self) -> tuple[tuple[Rule, Modal], ...]:
        """Rules on modal state, with their triggers."""
        return tuple((rule, rule.trigger) for rule in self.rules if isinstance(rule.trigger, Modal))

    @cached_property
    def stateful(self) -> Stateful | None:
        """The rules on modal state along a program's lines; None if none is on."""
        return stateful_of(self)

    @cached_property
    def on_moves(self) -> tuple[Rule, ...]:
        """Rules on the moves of a run that the machine's settings call for."""
        triggers = ((rule, rule.trigger) for rule in self.rules if self.machine)
        return tuple(rule for rule, trigger in triggers if isinstance(trigger, Moved) and self._needs(trigger))

    def _needs(self, trigger: Moved) -> bool:
        said = self.machine.get(trigger.needs, trigger.unless_said)
        return said is not None and said is not False

    @cached_property
    def on_notice(self) -> Mapping[str, Rule]:
        """Rules on notices, by the kind that they word."""
        return {rule.short: rule for rule in self.rules if isinstance(rule.trigger, Noticed)}

    @cached_property
    def _on_parts(self) -> tuple[Rule, ...]:
        """Rules on what a line was read as: those on faults before those on nodes."""
        return tuple(sorted(self._kinds, key=lambda rule: isinstance(rule.trigger, Nodes)))

    @cached_property
    def _kinds(self) -> Mapping[Rule, tuple[str, ...]]:
        """The kinds of node for which each rule on syntax or nodes is called."""
        triggers = ((rule, rule.trigger) for rule in self.rules)
        return {rule: self._of(trigger) for rule, trigger in triggers if isinstance(trigger, Syntax | Nodes)}

    def _of(self, trigger: Syntax | Nodes) -> tuple[str, ...]:
        only = trigger.only if isinstance(trigger, Syntax) else None
        return trigger.kinds if only is None or self.settings.get(only[0]) == only[1] else ()
