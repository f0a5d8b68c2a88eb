"""The formatter: a program laid out once is laid out, and says what it said."""

from __future__ import annotations

from collections.abc import Iterator

from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.tree import tokens
from fuzz.choices import Choices, joined
from fuzz.stock import numbered, programs
from support.formatting import STYLES, laid_out


def run(data: bytes) -> None:
    """A dialect, a style, and the text."""
    choices = Choices(data)
    name, style = choices.pick(NAMES), choices.pick(STYLES)
    text = choices.rest().decode("utf-8", "replace")
    once = laid_out(text, name, style)
    assert laid_out(once, name, style) == once
    assert _said(by_name(name), once) == _said(by_name(name), text)
    assert _signs(once) == _signs(text)


def _said(dialect: Dialect, text: str) -> list[str]:
    """The readings and the kinds of tokens of each line."""
    nodes = Document.parse(text, dialect).nodes()
    return [" ".join((node.reading.name, *(token.kind for token in tokens(node.tree)))) for node in nodes]


def _signs(text: str) -> str:
    """All but blanks and the case of letters."""
    return "".join(text.split()).upper()


def seeds() -> Iterator[bytes]:
    """Each program under each style."""
    for number, dialect in numbered():
        for at, program in enumerate(programs(dialect)):
            yield joined((number, at % len(STYLES)), program)
