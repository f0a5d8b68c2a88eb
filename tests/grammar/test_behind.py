"""What is read behind faults: the rest of the line, in its own columns, with blanks in the faults' place."""

from __future__ import annotations

import pytest
from hypothesis import given

from deburr_grammar.behind import rests
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from support.strategies import steady, texts


def node(dialect: str, text: str) -> LineNode:
    return Document.parse(text, by_name(dialect)).node(0)


@pytest.mark.parametrize(
    ("dialect", "text", "found"),
    [
        ("rs274", "G1 X#<a> Y[1]", []),
        ("rs274", "G1 ?? X1", ["G1  ? X1", "G1    X1"]),
        ("rs274", "G1 X[1+ Y123", ["        Y123"]),
        ("z32", "G1 X<HA+> Y<HB", ["          Y<HB"]),
        ("z32", "!HA=1; FOO; HB=HC!", ["!HA=1;    ; HB=HC!"]),
    ],
)
def test_the_rest_is_in_its_columns(dialect: str, text: str, found: list[str]) -> None:
    assert [each.text for each in rests(node(dialect, text))] == found


@pytest.mark.parametrize("dialect", NAMES)
def test_rests_are_the_line_with_blanks_in_it(dialect: str) -> None:
    @steady(100)
    @given(texts(by_name(dialect)))
    def holds(text: str) -> None:
        for line in Document.parse(text, by_name(dialect)).nodes():
            before, found = line.text, list(rests(line))
            assert not found or line.problems
            for each in found:
                assert len(each.text) == len(before)
                assert all(one == other or one == " " for one, other in zip(each.text, before, strict=True))
                before = each.text

    holds()
