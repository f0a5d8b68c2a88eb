"""Flat lines as they are written, under the rules on lines and on modal state: what the text left open, values and modes decide. Writes nothing."""

from __future__ import annotations

import re
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
    from collections.abc import Iterable, Iterator, Sequence

    from deburr.expand.job import Job
    from deburr.expand.rs274.unit import Unit
    from deburr.fault import Frame
    from deburr.modal import State
    from deburr.rule import Report, Rule
    from deburr_grammar.dialect import Dialect
    from deburr_grammar.line import Shape

_MOST = 20_000
"""Combinations of shape and state that are kept, and lines that are looked at together."""
_ON_MOVES = (
    "arc-radius",
    "cycle-depth",
    "feed-zero",
    "g-unknown",
    "inside-arc-small",
    "m-unknown",
    "polar-at-origin",
    "probe-in-place",
    "tool-unknown",
)
"""Rules on the program as a whole that are about its moves, codes and tools."""
_ON_TOOLS = "tool-unknown"
"""The one of them that looks at each line by itself, so that it need not see all of the others."""
_TOOL = re.compile("[TtHhDdQqPp]")
"""Letters of words that may name a tool."""


class _Step(NamedTuple):
    """A shape under a state: the rules that may have something to say, and the state behind it."""

    on_line: tuple[Rule, ...]
    on_state: tuple[Rule, ...]
    after: State


_Place = tuple["Unit", "Frame | None"]
"""Where flat lines come from, but for the row."""


class _Lines:
    """Flat lines with where they come from, in parallel columns, and their shapes as far as they are known."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.shapes: list[Shape | None] = []
        self.rows: list[int] = []
        self.numbers: list[int] = []
        """Which lines of the flat program they are."""
        self.places: list[_Place] = []
        self.unwritten: set[int] = set()
        """Which of them stand for what a written line does: they are heeded, and not judged."""
        self.asked: set[int] = set()
        """Which of them are only judged: others say what they do."""

    def __len__(self) -> int:
        return len(self.texts)

    def append(self, text: str, row: int, place: _Place, number: int) -> None:
        """One more line."""
        self.texts.append(text)
        self.shapes.append(None)
        self.rows.append(row)
        self.numbers.append(number)
        self.places.append(place)

    def extend(
        self, texts: Sequence[str], shapes: Sequence[Shape | None], rows: Sequence[int], place: _Place, behind: int
    ) -> None:
        """More lines of one place, the last that the flat program has: it has ``behind``."""
        self.texts += texts
        self.shapes += shapes
        self.rows += rows
        self.numbers += range(behind - len(texts), behind)
        self.places += [place] * len(texts)

    def take(self, other: _Lines, count: int) -> None:
        """Add the first lines of others."""
        self.texts += ("" if at in other.asked else text for at, text in enumerate(other.texts[:count]))
        self.rows += other.rows[:count]
        self.numbers += other.numbers[:count]
        self.places += other.places[:count]

    def pick(self, other: _Lines, wanted: Iterable[int]) -> None:
        """Add some lines of others, as long as they are not too many."""
        for at in islice(wanted, _MOST - len(self)):
            self.texts.append("" if at in other.asked else other.texts[at])
            self.rows.append(other.rows[at])
            self.numbers.append(other.numbers[at])
            self.places.append(other.places[at])

    def known_shapes(self, dialect: Dialect) -> list[Shape]:
        """The shapes of all."""
        open_ones = [at for at, shape in enumerate(self.shapes) if shape is None]
        read = shapes_of(dialect).read("\n".join(self.texts[at] for at in open_ones)) if open_ones else []
        for at, shape in zip(open_ones, read):
            self.shapes[at] = shape
        return [shape for shape in self.shapes if shape is not None]


class Judge:
    """Looks at what one run writes, some lines at a time: it raises for the first that the control refuses."""

    def __init__(self, job: Job) -> None:
        modal = modal_of(job.ruleset.dialect)
        assert modal is not None, "the dialect says what its lines do"
        self._job = job
        self._ruleset = job.ruleset
        self._modal = modal
        self._state = modal.start
        self._steps: dict[State, dict[Shape, _Step]] = {}
        self._waiting = _Lines()
        self._first = _Lines()
        """The first lines of the flat program, to be looked at together in the end."""
        self._tools = _Lines()
        """Those of the later ones that may name a tool."""

    def add(self, text: str, unit: Unit, row: int, frame: Frame | None) -> None:
        """A flat line and where it comes from."""
        self._waiting.append(text, row, (unit, frame), self._job.emitted - 1)

    def heed(self, texts: Sequence[str], unit: Unit, row: int, frame: Frame | None) -> None:
        """What the last flat line does, said in others: it brings modes back, which its own text does not name."""
        for text in texts:
            self._waiting.unwritten.add(len(self._waiting))
            self.add(text, unit, row, frame)

    def ask(self, text: str, unit: Unit, row: int, frame: Frame | None) -> None:
        """A line to be judged that is not in the flat program as it stands: what comes next says what it does."""
        self._waiting.asked.add(len(self._waiting))
        self._waiting.append(text, row, (unit, frame), self._job.emitted)

    def copied(
        self, texts: Sequence[str], shapes: Sequence[Shape], unit: Unit, rows: Sequence[int], frame: Frame | None
    ) -> None:
        """Flat lines of which the shapes are known."""
        self._waiting.extend(texts, shapes, rows, (unit, frame), self._job.emitted)

    def settle(self) -> None:
        """Judge the lines that wait."""
        waiting, self._waiting = self._waiting, _Lines()
        if not waiting:
            return
        state = self._state
        steps = self._under(state)
        for at, shape in enumerate(waiting.known_shapes(self._ruleset.dialect)):
            step = steps.get(shape) or self._step(steps, state, shape)
            if (step.on_line or step.on_state) and at not in waiting.unwritten:
                try:
                    self._judge(waiting, at, LineNode(waiting.texts[at], PROGRAM, shape), step, state)
                except Halt:
                    self._keep(waiting, at)
                    self._follow()
                    raise
            if step.after is not state and at not in waiting.asked:
                state = step.after
                steps = self._under(state)
        self._state = state
        self._keep(waiting, len(waiting))

    def finish(self) -> None:
        """Judge what is left, and where the moves of the program lead."""
        self.settle()
        self._follow()

    def _keep(self, lines: _Lines, count: int) -> None:
        """Keep of the first lines of some what is to be looked at in the end."""
        first = max(min(count, _MOST - len(self._first)), 0)
        self._first.take(lines, first)
        if first < count and self._ruleset.settings["tool-table"]:
            shapes = lines.known_shapes(self._ruleset.dialect)
            naming = {shape for shape in set(shapes) if _TOOL.search(shape.text)}
            self._tools.pick(lines, (at for at in range(first, count) if shapes[at] in naming))

    def _follow(self) -> None:
        """Ask the rules that follow the tool through what was written."""
        rules = [rule for rule in self._ruleset.on_whole if rule.short in _ON_MOVES]
        self._ask(rules, self._first)
        self._ask([rule for rule in rules if rule.short == _ON_TOOLS], self._tools)

    def _ask(self, rules: Sequence[Rule], lines: _Lines) -> None:
        if not lines:
            return
        document = Document.parse("\n".join(lines.texts), self._ruleset.dialect)
        analysis = Analysis(document, self._ruleset, "", self._job.host)
        reports = ((rule, report) for rule in rules for report in rule.on_program(analysis) if report is not None)
        for rule, report in sorted(reports, key=lambda found: found[1].line):
            self._raise(lines, report.line, document.node(report.line), rule, report)

    def _under(self, state: State) -> dict[Shape, _Step]:
        if len(self._steps) >= _MOST:
            self._steps.clear()
        return self._steps.setdefault(state, {})

    def _step(self, steps: dict[Shape, _Step], state: State, shape: Shape) -> _Step:
        if len(steps) >= _MOST:
            steps.clear()
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
        step = steps[shape] = _Step(on_line, on_state, self._modal.plain(state, PROGRAM, shape))
        return step

    def _judge(self, lines: _Lines, at: int, node: LineNode, step: _Step, state: State) -> None:
        for rule, report in self._said(node, step, state):
            self._raise(lines, at, node, rule, report)

    def _raise(self, lines: _Lines, at: int, node: LineNode, rule: Rule, report: Report) -> None:
        """End the run where an error is reported that no comment allows; of the flat program only what stands before is right."""
        severity = self._ruleset.severity(rule, report.severity)
        if severity is not Severity.ERROR:
            return
        (unit, frame), row = lines.places[at], lines.rows[at]
        document, file = unit.document, unit.file
        span = _in_source(report.span, node, document.node(row))
        place = Place(file, row, span.start, row, span.end)
        if not is_allowed(document, Finding(rule.name, severity, report.message, place)):
            self._job.keep(lines.numbers[at])
            raise Halt(Fault(rule.short, file, row, span, report.message, frame))

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
