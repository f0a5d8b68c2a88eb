"""The monoids of block structure: associative, with a neutral element, and the same however a program is split."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.structure import (
    EVEN,
    NOTHING,
    Balance,
    Fault,
    Placed,
    Reduction,
    balance,
    joined,
    reduction,
    single,
)
from deburr_grammar.text import Span
from support import naive
from support.strategies import steady

ROLES = (Role.OPEN, Role.OPEN, Role.OPEN, Role.CLOSE, Role.CLOSE, Role.CLOSE, Role.MIDDLE, Role.REGION, Role.END_REGION)
BRACKETS = st.builds(
    lambda role, kind, label, col: Bracket(
        role, "sub" if role in (Role.REGION, Role.END_REGION) else kind, kind, label, Span(col, col + 1)
    ),
    st.sampled_from(ROLES),
    st.sampled_from(("if", "loop")),
    st.sampled_from(("1", "2", None)),
    st.just(0),
)
SWEEPS = st.lists(BRACKETS, max_size=24)
BALANCES = st.lists(BRACKETS, max_size=10).map(balance)


def lined(brackets: list[Bracket]) -> list[tuple[int, Bracket]]:
    return list(enumerate(brackets))


def parts(brackets: list[Bracket], cuts: list[int]) -> list[Reduction]:
    """The reduction of each stretch between cuts, counted from its own first line and moved to its place."""
    at = sorted({0, len(brackets), *(cut % (len(brackets) + 1) for cut in cuts)})
    return [reduction(lined(brackets[a:b])).moved(a) for a, b in pairwise(at)]


def combined(stretches: list[Reduction]) -> Reduction:
    total = NOTHING
    for each in stretches:
        total = total.then(each)
    return total


@steady(200)
@given(BALANCES, BALANCES, BALANCES)
def test_balance_is_a_monoid(a: Balance, b: Balance, c: Balance) -> None:
    assert a.then(b).then(c) == a.then(b.then(c))
    assert EVEN.then(a) == a == a.then(EVEN) == a.then(Balance())


@steady(200)
@given(SWEEPS)
def test_balance_is_what_a_sweep_counts(brackets: list[Bracket]) -> None:
    assert tuple(balance(brackets)) == naive.balance(lined(brackets))
    assert joined(map(single, brackets)) == balance(brackets)


@steady(200)
@given(SWEEPS, SWEEPS, SWEEPS)
def test_reduction_is_a_monoid(a: list[Bracket], b: list[Bracket], c: list[Bracket]) -> None:
    one, two, three = reduction(lined(a)), reduction(lined(b)).moved(len(a)), reduction(lined(c)).moved(len(a) + len(b))
    left, right = one.then(two).then(three), one.then(two.then(three))
    assert bare(left) == bare(right)
    assert left.all_faults() == right.all_faults()
    assert bare(NOTHING.then(one)) == bare(one) == bare(one.then(NOTHING))


@steady(300)
@given(SWEEPS, st.lists(st.integers(0, 30), max_size=6))
def test_a_whole_is_any_split_of_it(brackets: list[Bracket], cuts: list[int]) -> None:
    whole, split = reduction(lined(brackets)), combined(parts(brackets, cuts))
    assert bare(split) == bare(whole)
    assert split.all_faults() == whole.all_faults()


def bare(found: Reduction) -> tuple[object, ...]:
    """A reduction without the order in which its faults were met: that depends on the split."""
    return found.closers, found.openers, sorted(map(repr, found.faults)), found.first, found.last


@steady(200)
@given(SWEEPS)
def test_faults_are_in_order_and_name_brackets_of_the_program(brackets: list[Bracket]) -> None:
    faults = reduction(lined(brackets)).all_faults()
    assert [fault.at.line for fault in faults] == sorted(fault.at.line for fault in faults)
    for fault in faults:
        for placed in filter(None, (fault.at, fault.other)):
            assert brackets[placed.line] == placed.bracket
    good = all(_paired(brackets))
    assert not (good and faults), "a clean program has faults"


def _paired(brackets: list[Bracket]) -> list[bool]:
    """Whether each pair ties, all are paired, and regions follow each other, by the plainest sweep."""
    found, stack, region = [], list[Bracket](), None
    for bracket in brackets:
        if bracket.role is Role.OPEN:
            stack.append(bracket)
        elif bracket.role is Role.CLOSE:
            found.append(bool(stack) and _ties(stack.pop(), bracket))
        elif bracket.role is Role.REGION:
            found.append(not stack and region is None)
            region, stack = bracket, []
        elif bracket.role is Role.END_REGION:
            found.append(not stack and region is not None and _ties(region, bracket))
            region, stack = None, []
    return [*found, not stack and region is None]


def _ties(one: Bracket, two: Bracket) -> bool:
    return one.kind == two.kind and (one.label == two.label or None in (one.label, two.label))


_SIGNS = {
    "(": (Role.OPEN, "if"),
    ")": (Role.CLOSE, "if"),
    "{": (Role.OPEN, "loop"),
    "}": (Role.CLOSE, "loop"),
    "S": (Role.REGION, "sub"),
    "E": (Role.END_REGION, "sub"),
    "-": (Role.MIDDLE, "if"),
}


def written(signs: str) -> list[Bracket]:
    """`(1` is an `if` with the label 1, `{2` a loop with the label 2, `S1` a region; one a line."""
    return [Bracket(*_SIGNS[sign], sign, label, Span(0, 1)) for sign, label in zip(signs[::2], signs[1::2])]


@pytest.mark.parametrize(
    ("signs", "wanted"),
    [
        ("", []),
        ("(1)1", []),
        ("(1(2)2-1)1", []),
        (")1", [(Fault.UNOPENED, 0, None)]),
        ("(1", [(Fault.UNCLOSED, 0, None)]),
        ("(1)2", [(Fault.MISMATCH, 1, 0)]),
        ("(1}1", [(Fault.MISMATCH, 1, 0)]),
        ("(1(2)1)2", [(Fault.CROSSED, 2, 1)]),
        ("(1(2)1", [(Fault.UNCLOSED, 1, 2)]),
        ("S1E1", []),
        ("S1E2", [(Fault.REGION_MISMATCH, 1, 0)]),
        ("S1", [(Fault.REGION_UNCLOSED, 0, None)]),
        ("E1", [(Fault.REGION_UNOPENED, 0, None)]),
        ("S1S2E2", [(Fault.REGION_NESTED, 1, 0)]),
        ("S1(1E1)1", [(Fault.ACROSS, 1, 3)]),
        ("S1)2E1", [(Fault.UNOPENED, 1, None)]),
        ("(1S1E1", [(Fault.UNCLOSED, 0, None)]),
    ],
)
def test_faults_of_small_programs(signs: str, wanted: list[tuple[Fault, int, int | None]]) -> None:
    brackets = written(signs)
    found = [
        (fault.fault, fault.at.line, fault.other.line if fault.other else None)
        for fault in reduction(lined(brackets)).all_faults()
    ]
    assert found == wanted
    for cut in range(len(brackets) + 1):
        assert combined(parts(brackets, [cut])).all_faults() == reduction(lined(brackets)).all_faults()


def test_a_label_that_only_the_run_knows_ties_with_any() -> None:
    opener, closer = written("(1)2")
    unknown = Bracket(closer.role, closer.kind, closer.word, None, closer.span)
    assert reduction(lined([opener, unknown])).all_faults() == ()


def test_values_worked_by_hand() -> None:
    assert balance(written(")1)2(3")) == Balance(2, 1, False)
    assert balance(written(")1(2S1)3(4(5")) == Balance(1, 2, True)
    assert Balance(0, 2).then(Balance(3, 1)) == Balance(1, 1)
    assert Balance(0, 2).then(Balance(1, 1, True)) == Balance(0, 1, True)
    closer, opener = written(")1(2")
    assert reduction([(4, closer), (9, opener)]) == Reduction((Placed(4, closer),), (Placed(9, opener),))
    assert reduction([(4, closer)]).moved(3) == Reduction((Placed(7, closer),))
    assert NOTHING.moved(5) == NOTHING


def test_many_faults_are_explained_in_good_time() -> None:
    """Ten thousand of a sort: the work must not grow with the square of them."""
    brackets = written("(1" * 10_000 + "}2" * 10_000)
    assert len(reduction(lined(brackets)).all_faults()) == 10_000
    apart = written("(1" * 10_000 + "S1E1" + ")1" * 10_000)
    assert {fault.fault for fault in reduction(lined(apart)).all_faults()} == {Fault.ACROSS}
