"""Lines end at three signs and nowhere else, and texts are cut behind line ends only."""

import re
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.text import Edit, Pos, cut_points, line_starts, split_lines, with_newlines
from support import naive
from support.strategies import steady

SIGNS = st.text(st.sampled_from("ab\r\n\f\v\x1c\x85\u2028\u2029\0😋"), max_size=30)


@pytest.mark.parametrize(
    ("text", "lines", "starts"),
    [
        ("", [""], [0]),
        ("a", ["a"], [0]),
        ("a\n", ["a", ""], [0, 2]),
        ("a\r", ["a", ""], [0, 2]),
        ("a\r\n", ["a", ""], [0, 3]),
        ("a\n\rb", ["a", "", "b"], [0, 2, 3]),
        ("\r\r\n\n", ["", "", "", ""], [0, 1, 3, 4]),
        ("a\fb\x85c\u2028d\ve\x1cf", ["a\fb\x85c\u2028d\ve\x1cf"], [0]),
        ("😋\n😋", ["😋", "😋"], [0, 2]),
    ],
)
def test_lines_and_their_starts(text: str, lines: list[str], starts: list[int]) -> None:
    assert split_lines(text) == lines == naive.lines_of(text)
    assert list(line_starts(text)) == starts


@steady(200)
@given(SIGNS)
def test_starts_lead_to_lines(text: str) -> None:
    lines, starts = split_lines(text), list(line_starts(text))
    assert lines == re.split(r"\r\n|\r|\n", text)
    assert len(lines) == len(starts)
    assert all(text.startswith(line, start) for line, start in zip(lines, starts))
    assert with_newlines(text) == "\n".join(lines)


@steady(200)
@given(SIGNS, st.integers(1, 9))
def test_cuts_are_behind_line_ends_and_leave_pieces_of_the_size(text: str, size: int) -> None:
    cuts = [0, *cut_points(text, size), len(text)]
    pieces = [text[a:b] for a, b in pairwise(cuts)]
    assert "".join(pieces) == text
    assert [line for piece in pieces for line in split_lines(piece)[:-1]] == split_lines(text)[:-1]
    for piece in pieces[:-1]:
        assert len(piece) >= size
        assert piece[-1] in "\r\n"
        assert all(len(line) + 2 >= len(piece) - size for line in split_lines(piece)[-2:-1])


def test_cuts_worked_by_hand() -> None:
    assert list(cut_points("", 3)) == []
    assert list(cut_points("ab\ncd\nef\n", 3)) == [6]
    assert list(cut_points("ab\ncd\nef\n", 2)) == [3, 6]
    assert list(cut_points("ab\r\ncd", 3)) == [4]
    assert list(cut_points("ab\r\ncd", 2)) == [4]
    assert list(cut_points("no line end at all", 3)) == []


def test_an_edit_may_be_given_backwards_or_past_the_end() -> None:
    assert naive.edited("ab\ncd", Edit(Pos(1, 1), Pos(0, 1), "-")) == "a-d"
    assert naive.edited("ab\ncd", Edit(Pos(0, 99), Pos(7, 0), "-")) == "ab-"
