"""The rules that are on for a program, sorted by what triggers them. Never reads a program."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any

from deburr_grammar.dialect import Dialect, Reading
from deburr_grammar.line import LineNode, Shape

from deburr.finding import Severity
from deburr.rule import Line, Long, Nodes, Noticed, Report, Rule, Structure, Syntax, Text, Whole, covers, rules_of

Planned = Callable[[Line], Iterator[tuple[Rule, Report]]]
_PLANS = 100_000


class RuleSet:
    """The rules that are on, their severities, and the dialect's settings. Findings are kept under it, so make one and use it again."""

    def __init__(
        self,
        dialect: Dialect,
        settings: Mapping[str, Any] | None = None,
        selected: Callable[[Rule], bool] = lambda rule: rule.default,
        severities: Mapping[str, Severity] | None = None,
    ) -> None:
        self.dialect = dialect
        self.settings = {setting.name: setting.default for setting in dialect.settings} | dict(settings or {})
        self._all = rules_of(dialect.name)
        self.rules = tuple(rule for rule in self._all if selected(rule))
        self._severities = dict(severities or {})
        self._plans: dict[tuple[Shape, str], tuple[Rule, ...]] = {}

    def severity(self, rule: Rule) -> Severity:
        """The severity of a rule's findings."""
        return self._severities.get(rule.name, rule.severity)

    def knows(self, name: str) -> bool:
        """Whether a name or prefix means any rule of the dialect, on or off."""
        return any(covers(name, rule.name) for rule in self._all)

    def speaks(self, name: str) -> bool:
        """Whether all that a name or prefix is expected to mean is on: only then does silence say something."""
        meant = {rule for rule in self._all if rule.name == name or (rule.default and covers(name, rule.name))}
        return bool(meant) and meant <= set(self.rules)

    def plan(self, shape: Shape, reading: Reading) -> tuple[Rule, ...]:
        """The rules that may have something to say of lines of a shape: decided once a shape."""
        plan = self._plans.get((shape, reading.name))
        if plan is None:
            if len(self._plans) >= _PLANS:
                self._plans.clear()
            plan = self._plans[shape, reading.name] = self._planned(shape, reading)
        return plan

    def _planned(self, shape: Shape, reading: Reading) -> tuple[Rule, ...]:
        facts = shape.facts(reading)
        problems = {problem.kind for problem in facts.problems}
        plan = [r for r, kinds in self._on_syntax if r.short in problems or not kinds.isdisjoint(facts.kinds)]
        sample = LineNode(shape.text, reading, shape)
        for rule, kinds, by_shape in self._on_nodes:
            # A shape is a line of its own, and the sample of all lines that share it.
            if not kinds.isdisjoint(facts.kinds) and not (by_shape and not any(self.on_line(sample, (rule,)))):
                plan.append(rule)
        return tuple(plan)

    def on_line(self, node: LineNode, plan: tuple[Rule, ...]) -> Iterator[tuple[Rule, Report]]:
        """What the planned rules say of a line."""
        line = Line(node, self.settings)
        for rule in plan:
            if isinstance(rule.trigger, Syntax):
                for problem in node.problems:
                    if problem.kind == rule.short:
                        yield from ((rule, report) for report in rule.check(line, problem))
            if isinstance(rule.trigger, Syntax | Nodes):
                for part in node.find(*rule.trigger.kinds):
                    yield from ((rule, report) for report in rule.check(line, part))
            else:
                yield from ((rule, report) for report in rule.check(line))

    @cached_property
    def on_text(self) -> tuple[tuple[Rule, re.Pattern[str]], ...]:
        """Rules on the text of lines, with their patterns."""
        return tuple((rule, re.compile(rule.trigger.pattern, re.M)) for rule in self.rules if isinstance(rule.trigger, Text))

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
    def on_notice(self) -> Mapping[str, Rule]:
        """Rules on notices, by the kind that they word."""
        return {rule.short: rule for rule in self.rules if isinstance(rule.trigger, Noticed)}

    @cached_property
    def _on_syntax(self) -> tuple[tuple[Rule, frozenset[str]], ...]:
        syntax = ((rule, rule.trigger) for rule in self.rules if isinstance(rule.trigger, Syntax))
        return tuple((rule, frozenset(trigger.kinds)) for rule, trigger in syntax)

    @cached_property
    def _on_nodes(self) -> tuple[tuple[Rule, frozenset[str], bool], ...]:
        nodes = ((rule, rule.trigger) for rule in self.rules if isinstance(rule.trigger, Nodes))
        return tuple((rule, frozenset(trigger.kinds), trigger.by_shape) for rule, trigger in nodes)
