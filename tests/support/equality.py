"""The one claim that all else rests on: a document after any edits is the document of the text that it now has.

`check` is used by the property tests, and by the mutants, which it must reject.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple
from unittest import mock

from deburr.analysis import Analysis
from deburr.blocks import Block, Scope
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Bracket, Dialect, Reading, Role
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode, Shape
from deburr_grammar.shape import Folding
from deburr_grammar.structure import Fault, Placed
from deburr_grammar.text import Edit
from support import naive


class Case(NamedTuple):
    """A text, edits, the size of chunks, and before which of the edits everything is asked for."""

    text: str
    edits: tuple[Edit, ...]
    size: int
    asked: frozenset[int] = frozenset()


class Tally:
    """A fold that notices everything it is shown, and forgets enough to agree with itself again."""

    start = 0
    only_brackets = False

    def plain(self, state: int, reading: Reading, shape: Shape) -> int:
        return (state * 3 + len(shape.text) + len(reading.name)) % 11

    def marked(self, state: int, line: LineNode, brackets: Sequence[Bracket]) -> int:
        return (
            state * 5 + len(line.text) + len(line.reading.name) + sum(len(bracket.word) for bracket in brackets)
        ) % 11


TALLY = Tally()


def check(dialect: Dialect, case: Case) -> None:
    """Edit step by step, then compare with a fresh document and with the naive model."""
    document, text = Document.parse(case.text, dialect, case.size), case.text
    for number, edit in enumerate(case.edits):
        if number in case.asked:
            answers(document)
        document, text = document.edit(edit), naive.edited(text, edit)
    found = answers(document)
    _same(found, answers(Document.parse(text, dialect, case.size)), "a fresh document")
    _same(found, expected(text, dialect), "the naive model")
    _sound(document, case.size)


def check_reading(dialect: Dialect, case: Case) -> None:
    """A document that has been read re-reads no more than the lines an edit touched and two beside them."""
    document = Document.parse(case.text, dialect, case.size)
    for edit in case.edits:
        answers(document)
        touched = len(naive.lines_of(edit.text))
        with counted() as lines:
            document = document.edit(edit)
            answers(document)
        assert sum(lines) <= touched + 2, (lines, touched, edit)


@contextmanager
def counted() -> Iterator[list[int]]:
    """How many lines each call folds: the only way from text to what a line is."""
    counts: list[int] = []
    fold = Folding.fold

    def counting(self: Folding, text: str) -> str:
        counts.append(text.count("\n") + (not text.endswith("\n")))
        return fold(self, text)

    with mock.patch.object(Folding, "fold", counting):
        yield counts


def answers(document: Document) -> dict[str, Any]:
    """All that a document and its analysis say."""
    brackets = list(document.brackets())
    analysis = Analysis(document, _ruleset(document.dialect), "a.txt")
    return {
        "text": document.text,
        "line_count": document.line_count,
        "lines": [document.line(number) for number in range(document.line_count)],
        "readings": [node.reading for node in document.nodes()],
        "texts": [node.text for node in document.nodes()],
        "trees": [node.tree for node in document.nodes()],
        "node_problems": [node.problems for node in document.nodes()],
        "problems": list(document.problems()),
        "brackets": brackets,
        "balance": tuple(document.balance),
        "faults": document.faults,
        "facts": document.facts,
        "partners": {one: document.partner(*one) for one in brackets if one[1].role in (Role.OPEN, Role.CLOSE)},
        "states": [document.state(TALLY, number) for number in range(document.line_count)],
        "scopes": [_flat(scope) for scope in analysis.scopes],
        "findings": analysis.findings(),
    }


def expected(text: str, dialect: Dialect) -> dict[str, Any]:
    """What the naive model says, as far as it goes."""
    lines = naive.outlined(text, dialect)
    brackets = naive.placed(lines)
    read = [naive.read_directly(dialect, line.reading.start, line.text) for line in lines]
    return {
        "text": text,
        "line_count": len(lines),
        "lines": [line.text for line in lines],
        "readings": [line.reading for line in lines],
        "texts": [line.text for line in lines],
        "trees": [tree for tree, _ in read],
        "node_problems": [problems for _, problems in read],
        "problems": [(number, problem) for number, (_, problems) in enumerate(read) for problem in problems],
        "brackets": brackets,
        "balance": naive.balance(brackets),
        "faults": tuple(
            each
            for each in naive.faults(brackets)
            if not (dialect.file_ends_region and each.fault is Fault.REGION_UNCLOSED)
        ),
        "facts": dialect.outline.facts("\n".join(naive.lines_of(text))),
        "partners": dict(naive.partners(brackets)),
        "states": list(_states(lines, dialect)),
    }


def _states(lines: Sequence[naive.NaiveLine], dialect: Dialect) -> Iterator[int]:
    state = TALLY.start
    for line in lines:
        yield state
        shape = Shape(dialect, line.shape)
        if shape.marked:
            state = TALLY.marked(state, LineNode(line.text, line.reading, shape), line.brackets)
        else:
            state = TALLY.plain(state, line.reading, shape)


def _same(found: Mapping[str, Any], wanted: Mapping[str, Any], what: str) -> None:
    for name, value in wanted.items():
        assert found[name] == value, f"{name} of the edited document and of {what} differ:\n{found[name]!r}\n{value!r}"


def _sound(document: Document, size: int) -> None:
    """The chunks are whole lines, none but the last is empty, and their sums are right."""
    chunks = list(document.chunks())
    assert all(chunk.text and chunk.text[-1] in "\r\n" for chunk in chunks[:-1])
    assert not any(one.text[-1] == "\r" and two.text[:1] == "\n" for one, two in pairwise(chunks))
    assert [chunk.eols for chunk in chunks] == [len(naive.lines_of(chunk.text)) - 1 for chunk in chunks]
    assert [len(chunk.starts) for chunk in chunks] == [chunk.eols + 1 for chunk in chunks]
    assert all(len(chunk.text) <= 2 * size or chunk.eols <= 2 * size for chunk in chunks)


def _flat(scope: Scope) -> tuple[object, ...]:
    """A scope as plain data without nesting, so that comparing deep ones needs no recursion."""
    blocks = tuple((block.opener, block.closer, _opener(block.around), tuple(block.middles)) for block in scope.blocks)
    return (scope.start, scope.end, blocks, tuple((placed, _opener(block)) for placed, block in scope.middles))


def _opener(block: Block | None) -> Placed | None:
    return block.opener if block is not None else None


@cache
def _ruleset(dialect: Dialect) -> RuleSet:
    return RuleSet(dialect, selected=lambda rule: True)
