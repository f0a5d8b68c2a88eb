"""What is made again of the same objects is the object that it was; what only looks the same is made anew."""

from __future__ import annotations

from typing import Any

import pytest

from deburr.values.again import again
from deburr.values.domain import exactly
from deburr.values.graph import Env, join
from deburr.values.kept import Kept


@pytest.fixture(autouse=True)
def _nothing_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("deburr.values.again._kept", Kept[Any](100))


def test_the_same_two_give_the_same_object() -> None:
    one, two = {"a": exactly(1.0)}, {"a": exactly(2.0)}
    made = again(join, one, two)
    assert made == join(one, two)
    assert again(join, one, two) is made


def test_what_is_equal_but_another_object_is_made_anew() -> None:
    one, two = {"a": exactly(1.0)}, {"a": exactly(2.0)}
    made = again(join, one, two)
    other = again(join, dict(one), two)
    assert other == made and other is not made


def test_another_way_of_making_gives_something_else() -> None:
    one: Env = {"a": exactly(1.0), "b": exactly(2.0)}
    assert again(lambda env, keys: [*env], one, ("a",)) == ["a", "b"]
    assert again(lambda env, keys: [*keys], one, ("a",)) == ["a"]


def test_no_other_object_comes_into_the_place_of_one_that_is_gone() -> None:
    """A place in memory is used again at once, so that it would be taken for what was there."""
    for number in range(1_000):
        assert again(join, {"a": exactly(float(number))}, {"a": exactly(0.0)})["a"].high == number


def test_what_is_kept_is_bounded_by_its_variables(monkeypatch: pytest.MonkeyPatch) -> None:
    kept = Kept[Any](100)
    monkeypatch.setattr("deburr.values.again._kept", kept)
    for number in range(200):
        again(join, {"a": exactly(float(number))}, {"b": exactly(1.0)})
    assert kept.lines == 100 and len(kept) == 50
