"""Ranges against the numbers in them: whatever is calculated with the numbers lies in what is calculated with the ranges."""

import math
from collections.abc import Callable, Sequence
from functools import reduce

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.arithmetic import Refusal
from deburr.arithmetic.rs274 import atan, function, operation
from deburr.values.domain import (
    ANY,
    UNITS,
    UNSET,
    Value,
    above,
    apart,
    below,
    exactly,
    joined,
    near,
    truth,
    widened,
    without_zero,
)
from deburr.values.operations import Lifted
from deburr.values.rs274.expressions import ATAN, FUNCTIONS, lifted_operation
from deburr.values.words import said

SIGNS = ("+", "-", "*", "/", "MOD", "**", "LT", "GT", "LE", "GE", "EQ", "NE", "AND", "OR", "XOR")
NUMBERS = st.one_of(
    st.integers(-20, 20).map(float),
    st.integers(-40, 40).map(lambda n: n / 4),
    st.sampled_from((0.1, -0.3, 1e-5, 1.00005, 1e12, -1e12, 2.0**41, 1e300, -1e300, 1e-310)),
    st.floats(allow_nan=False, allow_infinity=False),
)
SOME = st.lists(NUMBERS, min_size=1, max_size=4)
TOLERANCES = st.sampled_from((1e-4, 1e-6))


def holding(numbers: Sequence[float]) -> Value:
    """The narrowest value that holds these."""
    return reduce(joined, map(exactly, numbers))


def check_lifted(exact: Callable[..., float], lifted: Lifted, *operands: Sequence[float]) -> None:
    """No result lies outside; and where the range is refused, so is each number."""
    ways: list[tuple[float, ...]] = [()]
    for numbers in operands:
        ways = [(*way, number) for way in ways for number in numbers]
    try:
        found: Value | None = lifted(*map(holding, operands))
    except Refusal:
        found = None
    for way in ways:
        try:
            result = exact(*way)
        except Refusal:
            continue
        assert found is not None, f"{way} is not refused"
        assert found.has(result), f"{way} gives {result!r}, which is not in {found}"


@given(SOME, SOME, st.sampled_from(SIGNS), TOLERANCES)
def test_operators(one: list[float], two: list[float], sign: str, tolerance: float) -> None:
    check_lifted(operation(sign, tolerance), lifted_operation(sign, tolerance), one, two)


@given(SOME, st.sampled_from(sorted(FUNCTIONS)))
def test_functions(numbers: list[float], name: str) -> None:
    check_lifted(function(name), FUNCTIONS[name], numbers)


@given(SOME, SOME)
def test_the_angle_of_a_direction(one: list[float], two: list[float]) -> None:
    check_lifted(atan, ATAN, one, two)


@given(SOME, NUMBERS, st.booleans())
def test_bounds_keep_what_is_within(numbers: list[float], limit: float, strictly: bool) -> None:
    value = holding(numbers)
    for number in numbers:
        if number < limit or (number == limit and not strictly):
            assert below(value, limit, strictly).has(number)
        if number > limit or (number == limit and not strictly):
            assert above(value, limit, strictly).has(number)


@given(SOME, SOME, TOLERANCES)
def test_near_and_apart_keep_what_is_so(numbers: list[float], others: list[float], tolerance: float) -> None:
    value, other = holding(numbers), holding(others)
    for number in numbers:
        if any(abs(number - each) < tolerance for each in others):
            assert near(value, other, tolerance).has(number)
        if any(abs(number - each) >= tolerance for each in others):
            assert apart(value, other, tolerance).has(number)
        if number:
            assert without_zero(value).has(number)
        assert truth(value) in (None, bool(number))


@given(SOME, SOME)
def test_what_widens_holds_both_and_comes_to_rest(one: list[float], two: list[float]) -> None:
    value, rounds = holding(one), 0
    for step in range(1, 40):
        new = widened(value, joined(value, holding([number * step for number in two])))
        assert all(new.has(number) for number in (*one, *(n * step for n in two if math.isfinite(n * step))))
        rounds += new != value
        value = new
    assert rounds < 15


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (exactly(5.0), "5"),
        (holding([0.0, 10.0, 90.0]), "0 … 90 step 10"),
        (holding([1.0, 2.0]), "1 … 2, integers"),
        (holding([0.1, 0.4]), "0.1 … 0.4"),
        (above(ANY, 0.0, True), "above 0"),
        (below(ANY, 3.0, False), "at most 3"),
        (without_zero(ANY), "never 0"),
        (without_zero(holding([-0.3, 0.4])), "-0.3 … 0.4, never 0"),
        (UNSET, "not set"),
        (joined(UNSET, exactly(2.0)), "2, or not set"),
        (ANY, ""),
    ],
)
def test_values_in_words(value: Value, text: str) -> None:
    assert said(value) == text


def test_a_grid_is_kept_by_a_bound() -> None:
    tens = Value(0.0, 2.0**39, 10 * UNITS)
    assert below(tens, 95.0, False) == Value(0.0, 90.0, 10 * UNITS)
    assert above(below(tens, 100.0, False), 100.0, False) == exactly(100.0)
