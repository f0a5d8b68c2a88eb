"""Whatever a client does to a document: the server's text is the client's, and its diagnostics are those of a document just opened."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import Edit, Pos
from support.inside import Inside
from support.strategies import edits, steady, texts

ENCODINGS = {"utf-8": "utf-8", "utf-16": "utf-16-le", "utf-32": "utf-32-le"}
UNIT = {"utf-8": 1, "utf-16": 2, "utf-32": 4}
_EOL = re.compile(r"\r\n|\n|\r")
URI = "untitled:Untitled-1"


class Model:
    """A text as a client has it, in the plainest way there is: bytes of the encoding."""

    def __init__(self, text: str, encoding: str) -> None:
        self.text = text
        self._encoding = encoding

    def change(self, edit: Edit) -> dict[str, Any]:
        """Make an edit whose columns are units; the change that the server is sent."""
        start, end = self._at(edit.start), self._at(edit.end)
        if end < start:
            start, end, edit = end, start, Edit(edit.end, edit.start, edit.text)
        self.text = self.text[:start] + edit.text + self.text[end:]
        said = [{"line": pos.line, "character": pos.col} for pos in (edit.start, edit.end)]
        return {"range": {"start": said[0], "end": said[1]}, "text": edit.text}

    def _at(self, pos: Pos) -> int:
        """The offset of a place; in the middle of a character its start."""
        starts = [0, *(match.end() for match in _EOL.finditer(self.text))]
        if pos.line >= len(starts):
            return len(self.text)
        line = _EOL.split(self.text[starts[pos.line] :], maxsplit=1)[0]
        wire, unit = ENCODINGS[self._encoding], UNIT[self._encoding]
        data = line.encode(wire, "surrogatepass")[: pos.col * unit]
        return starts[pos.line] + len(data.decode(wire, "ignore"))


FRESH = "untitled:Untitled-2"


def diagnostics(inside: Inside, uri: str) -> Any:
    return named(inside.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})["items"])


def named(found: Any) -> Any:
    """Both documents under one name."""
    return json.loads(json.dumps(found).replace(FRESH, URI))


def check(dialect: str, encoding: str, text: str, rounds: Sequence[Sequence[Edit]]) -> None:
    """Open, edit, and compare with a fresh copy."""
    offered = {"general": {"positionEncodings": [encoding]}, "textDocument": {"diagnostic": {}}}
    with Inside(offered) as inside:
        model = Model(text, encoding)
        inside.open(URI, text, dialect)
        for version, changes in enumerate(rounds, 2):
            sent = [model.change(edit) for edit in changes]
            document = {"uri": URI, "version": version}
            inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": sent})
        assert inside.server.session.open[URI].document.text == model.text
        inside.open(FRESH, model.text, dialect)
        assert diagnostics(inside, URI) == diagnostics(inside, FRESH)


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("dialect", NAMES)
def test_any_edits_leave_what_a_fresh_copy_is(dialect: str, encoding: str) -> None:
    language = by_name(dialect)

    @steady(25)
    @given(texts(language), st.lists(st.lists(edits(language), min_size=1, max_size=3), max_size=4))
    def holds(text: str, rounds: list[list[Edit]]) -> None:
        check(dialect, encoding, text, rounds)

    holds()


def test_a_change_without_a_range_is_the_whole_text() -> None:
    with Inside({"textDocument": {"diagnostic": {}}}) as inside:
        inside.open(URI, "G1 (a (b)\n", "rs274")
        change = {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": "G21\nM2\n"}]}
        inside.notify("textDocument/didChange", change)
        assert inside.server.session.open[URI].document.text == "G21\nM2\n"
        assert diagnostics(inside, URI) == []


@pytest.mark.parametrize("dialect", NAMES)
def test_what_is_said_at_once_is_what_is_said_in_the_end(dialect: str) -> None:
    """A client that is pushed to sees, right after an edit, no finding of a line that the whole check then takes back."""
    language = by_name(dialect)

    @steady(25)
    @given(texts(language), edits(language))
    def holds(text: str, edit: Edit) -> None:
        with Inside({"general": {"positionEncodings": ["utf-32"]}}) as inside:
            inside.open(URI, text, dialect)
            inside.settle()
            change = Model(text, "utf-32").change(edit)
            document = {"uri": URI, "version": 2}
            inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [change]})
            inside.settle()
            program = inside.server.session.open[URI]
            inside.open(FRESH, program.document.text, dialect)
            inside.settle()
            said = {each["params"]["uri"]: each["params"]["diagnostics"] for each in inside.said}
            assert said.get(URI, []) == named(said.get(FRESH, []))

    holds()
