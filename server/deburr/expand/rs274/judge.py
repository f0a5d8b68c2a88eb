"""Flat lines as they are written, under the rules on lines and on modal state: what the text left open, values and modes decide. Writes nothing."""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.fault import Fault, Halt
from deburr.finding import Finding, Place, Severity
from deburr.modal import modal_of
from deburr.rule import Line
from deburr.suppress import is_allowed
from deburr_grammar.dialects.rs274.outline import PROGRAM
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode, shapes_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.expand.rs274.unit import Unit
    from deburr.fault import Frame
    from deburr.modal import State
    from deburr.rule import Report, Rule
    from deburr.ruleset import RuleSet
    from deburr_grammar.line import Shape

_MOST = 20_000
"""Combinations of shape and state that are kept, and lines that are looked at together."""
_ON_MOVES = ("arc-radius", "feed-zero", "g-unknown", "m-unknown")
"""Rules on the program as a whole that are about its moves and codes."""


class _Step(NamedTuple):
    """A shape under a state: the rules that may have something to say, and the state behind it."""

    on_line: tuple[Rule, ...]
    on_state: tuple[Rule, ...]
    after: State


class _Written(NamedTuple):
    text: str
    unit: Unit
    row: int
    frame: Frame | None


class Judge:
    """Looks at what one run writes, some lines at a time: it raises for the first that the control refuses."""

    def __init__(self, ruleset: RuleSet) -> None:
        modal = modal_of(ruleset.dialect)
        assert modal is not None, "the dialect says what its lines do"
        self._ruleset = ruleset
        self._modal = modal
        self._state = modal.start
        self._steps: dict[tuple[State, Shape], _Step] = {}
        self._waiting: list[_Written] = []
        self._first: list[_Written] = []
        """The first lines of the flat program, to be looked at together in the end."""

    def add(self, text: str, unit: Unit, row: int, frame: Frame | None) -> None:
        """A flat line and where it comes from."""
        self._waiting.append(_Written(text, unit, row, frame))

    def settle(self) -> None:
        """Judge the lines that wait."""
        waiting, self._waiting = self._waiting, []
        if not waiting:
            return
        shapes = shapes_of(self._ruleset.dialect).read("\n".join(each.text for each in waiting))
        state, steps = self._state, self._steps
        for at, (written, shape) in enumerate(zip(waiting, shapes)):
            step = steps.get((state, shape)) or self._step(state, shape)
            if step.on_line or step.on_state:
                try:
                    self._judge(written, LineNode(written.text, PROGRAM, shape), step, state)
                except Halt:
                    self._follow(waiting[:at])
                    raise
            state = step.after
        self._state = state
        self._first += waiting[: _MOST - len(self._first)]

    def finish(self) -> None:
        """Judge what is left, and where the moves of the program lead."""
        self.settle()
        self._follow([])

    def _follow(self, more: list[_Written]) -> None:
        """Ask the rules that follow the tool through what was written."""
        lines = [*self._first, *more]
        rules = [rule for rule in self._ruleset.on_whole if rule.short in _ON_MOVES]
        document = Document.parse("\n".join(written.text for written in lines), self._ruleset.dialect)
        analysis = Analysis(document, self._ruleset)
        reports = ((rule, report) for rule in rules for report in rule.check(analysis))
        for rule, report in sorted(reports, key=lambda found: found[1].line):
            self._raise(lines[report.line], document.node(report.line), rule, report)

    def _step(self, state: State, shape: Shape) -> _Step:
        if len(self._steps) >= _MOST:
            self._steps.clear()
        kinds = shape.facts(PROGRAM).kinds
        # A shape is a line of its own, and the sample of all lines that share it.
        sample = Line(LineNode(shape.text, PROGRAM, shape), self._ruleset.settings)
        on_state = tuple(
            rule
            for rule, trigger in self._ruleset.on_modal
            if not kinds.isdisjoint(trigger.kinds)
            and (
                trigger.where(sample, state)
                if trigger.where is not None
                else any(True for _ in rule.check(sample, state))
            )
        )
        on_line = self._ruleset.plan(shape, PROGRAM)
        step = self._steps[state, shape] = _Step(on_line, on_state, self._modal.plain(state, PROGRAM, shape))
        return step

    def _judge(self, written: _Written, node: LineNode, step: _Step, state: State) -> None:
        for rule, report in self._said(node, step, state):
            self._raise(written, node, rule, report)

    def _raise(self, written: _Written, node: LineNode, rule: Rule, report: Report) -> None:
        """End the run where an error is reported that no comment allows."""
        severity = self._ruleset.severity(rule, report.severity)
        if severity is not Severity.ERROR:
            return
        document, file, row = written.unit.document, written.unit.file, written.row
        span = _in_source(report.span, node, document.node(row))
        place = Place(file, row, span.start, row, span.end)
        if not is_allowed(document, Finding(rule.name, severity, report.message, place)):
            raise Halt(Fault(rule.short, file, row, span, report.message, written.frame))

    def _said(self, node: LineNode, step: _Step, state: State) -> Iterator[tuple[Rule, Report]]:
        yield from self._ruleset.on_line(node, step.on_line)
        line = Line(node, self._ruleset.settings)
        for rule in step.on_state:
            yield from ((rule, report) for report in rule.check(line, state))


def _in_source(span: Span, flat: LineNode, source: LineNode) -> Span:
    """The word of the source line that a place in the flat line comes from; the whole line where that cannot be said."""
    words, theirs = list(flat.find("word")), list(source.find("word"))
    at = next((at for at, word in enumerate(words) if word.start <= span.start < word.end), None)
    if at is not None and len(words) == len(theirs):
        word = next(islice(theirs, at, None))
        return Span(word.start, word.end)
    text = source.text
    return Span(len(text) - len(text.lstrip()), len(text.rstrip()))
