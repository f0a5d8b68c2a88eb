"""Rules on modal state along the lines of a program. What they say of a shape under a state is decided once; then a line costs one look-up."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.modal import modal_of
from deburr.rule import Line
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from deburr.modal import Modal, State
    from deburr.rule import Report, Rule
    from deburr.ruleset import RuleSet
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Shape

_STATES = 10_000
STEPS = 8_192
"""Steps of shapes kept under all states together, if nobody says another number: a library comes with the same ones again and again."""


class Said(NamedTuple):
    """A report on a line of a chunk, its line counted from the chunk's first."""

    line: int
    rule: Rule
    report: Report


class _Step(NamedTuple):
    """A shape under a state: the rules that have something to say, and what holds behind it (None: it depends on the line)."""

    plan: tuple[Rule, ...]
    after: _Steps | None


class _Steps(dict["Shape", "_Step | None"]):
    """The steps of shapes under a state and a reading, made when they are met. None: nothing is said, and nothing changes."""

    def __init__(self, state: State, reading: Reading, make: Callable[[_Steps, Shape], _Step | None]) -> None:
        super().__init__()
        self.state = state
        self.reading = reading
        self._make = make

    def __missing__(self, shape: Shape) -> _Step | None:
        step = self[shape] = self._make(self, shape)
        return step


class Stateful:
    """The rules on modal state of a rule set; make one with `stateful_of`."""

    def __init__(self, ruleset: RuleSet, modal: Modal) -> None:
        self._ruleset = ruleset
        self._modal = modal
        self._steps: dict[tuple[State, str], _Steps] = {}
        self._count = 0
        self._most = ruleset.steps

    def findings(self, document: Document) -> Iterator[tuple[Piece, Said]]:
        """What the rules say of a program; kept with each chunk under the state before it."""
        for piece, _, found in self._pieces(document):
            for said in found:
                yield piece, said

    def states(self, document: Document) -> Iterator[tuple[Piece, State]]:
        """The chunks in order, each with the state before it."""
        return ((piece, state) for piece, state, _ in self._pieces(document))

    def _pieces(self, document: Document) -> Iterator[tuple[Piece, State, tuple[Said, ...]]]:
        state = self._modal.start
        for piece in document.pieces():
            key = (self, document.key(piece), state)
            kept: tuple[tuple[Said, ...], State] | None = piece.chunk.memo.get(key)
            if kept is None:
                kept = piece.chunk.memo[key] = self._through(piece, state)
                # Whoever asks for the state at one line after an edit need not go through the chunks above once more.
                document.keep_state(self._modal, piece, state, kept[1])
            found, after = kept
            yield piece, state, found
            state = after

    def line_findings(self, document: Document, line: int) -> Iterator[Said]:
        """What the rules say of one line, counted from itself."""
        node = document.node(line)
        state = document.state(self._modal, line)
        step = self._under(state, node.reading)[node.shape]
        return self._said(node, state, step.plan if step is not None else (), 0)

    def _through(self, piece: Piece, state: State) -> tuple[tuple[Said, ...], State]:
        found: list[Said] = []
        held: dict[int, list[Bracket]] = {}
        for index, bracket in piece.outlined.brackets:
            held.setdefault(index, []).append(bracket)
        for reading, first, shapes in piece.read():
            steps = self._under(state, reading)
            for index, shape in enumerate(shapes, first):
                step = steps[shape]
                if step is None:
                    continue
                if step.plan:
                    found += self._said(piece.node(index), steps.state, step.plan, index)
                after = step.after
                steps = after if after is not None else self._behind(steps, piece.node(index), held.get(index, ()))
            state = steps.state
        return tuple(found), state

    def _said(self, node: LineNode, state: State, plan: tuple[Rule, ...], index: int) -> Iterator[Said]:
        line = Line(node, self._ruleset.settings)
        for rule in plan:
            yield from (Said(index, rule, report) for report in rule.check(line, state))

    def _behind(self, steps: _Steps, node: LineNode, brackets: Sequence[Bracket]) -> _Steps:
        return self._under(self._modal.marked(steps.state, node, brackets), steps.reading)

    def _under(self, state: State, reading: Reading) -> _Steps:
        key = (state, reading.name)
        steps = self._steps.get(key)
        if steps is None:
            if len(self._steps) >= _STATES:
                self._steps.clear()
                self._count = 0
            steps = self._steps[key] = _Steps(state, reading, self._step)
        return steps

    def _step(self, steps: _Steps, shape: Shape) -> _Step | None:
        if self._count >= self._most:
            self._count = 0
            for known in self._steps.values():
                known.clear()
        self._count += 1
        state, reading = steps.state, steps.reading
        plan = self._planned(state, reading, shape)
        if shape.marked:
            return _Step(plan, None)
        after = self._modal.plain(state, reading, shape)
        return _Step(plan, self._under(after, reading)) if plan or after is not state else None

    def _planned(self, state: State, reading: Reading, shape: Shape) -> tuple[Rule, ...]:
        if reading.start is None:
            return ()
        kinds = shape.facts(reading).kinds
        asked = ((rule, trigger) for rule, trigger in self._ruleset.on_modal if not kinds.isdisjoint(trigger.kinds))
        # A shape is a line of its own, and the sample of all lines that share it.
        line = Line(LineNode(shape.text, reading, shape), self._ruleset.settings)
        return tuple(
            rule
            for rule, trigger in asked
            if (trigger.where(line, state) if trigger.where is not None else any(True for _ in rule.check(line, state)))
        )


def stateful_of(ruleset: RuleSet) -> Stateful | None:
    """The rules on modal state; None if none is on."""
    modal = modal_of(ruleset.dialect) if ruleset.on_modal else None
    return Stateful(ruleset, modal) if modal is not None else None
