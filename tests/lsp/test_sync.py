"""Whatever a client does to a document: the server's text is the client's, and its diagnostics are those of a document just opened."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import Edit
from support.inside import Inside
from support.model import ENCODINGS, Model
from support.strategies import edits, steady, texts

URI = "untitled:Untitled-1"
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
