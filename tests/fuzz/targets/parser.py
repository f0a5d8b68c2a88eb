"""The parser: a document after edits is the document of its text, and its trees cover what they should."""

from __future__ import annotations

from collections.abc import Iterator

from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos
from deburr_grammar.tree import tokens
from fuzz.choices import Choices, joined
from fuzz.stock import numbered, programs
from support import naive
from support.equality import Case, check
from support.strategies import SIZES

_EDITS = 5


def run(data: bytes) -> None:
    """A dialect, the size of chunks, before which edits all is asked, the text, and edits."""
    choices = Choices(data)
    dialect, size, asked = by_name(choices.pick(NAMES)), choices.pick(SIZES), choices.byte()
    text = choices.text()
    edits = tuple(_edits(choices))
    check(dialect, Case(text, edits, size, frozenset(number for number in range(_EDITS) if asked >> number & 1)))
    _covers(Document.parse(text, dialect, size), text)


def _edits(choices: Choices) -> Iterator[Edit]:
    for _ in range(_EDITS):
        if not choices:
            return
        line, col, lines, end = (choices.byte() for _ in range(4))
        yield Edit(Pos(line, col), Pos(line + lines % 4, end), choices.text())


def _covers(document: Document, text: str) -> None:
    """Each line is its text, and its tokens follow each other in it."""
    lines = naive.lines_of(text)
    assert [node.text for node in document.nodes()] == lines
    for node, line in zip(document.nodes(), lines):
        at = 0
        for token in tokens(node.tree):
            assert at <= token.start <= token.end <= len(line), (token, line)
            at = token.end
        for problem in node.problems:
            assert 0 <= problem.start <= problem.end <= len(line), (problem, line)


def seeds() -> Iterator[bytes]:
    """Each program as it is, and with a line taken out and one put in."""
    for number, dialect in numbered():
        for at, program in enumerate(programs(dialect)):
            yield joined(
                (number, at % len(SIZES), at % 32),
                program,
                bytes((at % 9, 0, 1, 0)) + b"(a ",
                bytes((1, 3, 0, 3)) + b"\r\nG1 X1\n",
            )
