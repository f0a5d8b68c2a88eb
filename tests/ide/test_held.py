"""Findings that are kept in blocks stand, behind any edits, where findings stand that are moved one by one."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from hypothesis import given
from hypothesis import strategies as st

from deburr.finding import Finding, Place, Related, Severity
from deburr.ide.held import Held
from support.strategies import steady

LINES = 400


def found(rule: str, line: int, *points: int) -> Finding:
    related = tuple(Related(Place("a", each, 0, each, 1), "") for each in points)
    return Finding(rule, Severity.ERROR, "m", Place("a", line, 2, line, 4), related)


PLAIN = st.builds(found, st.sampled_from("xy"), st.integers(0, LINES))
LINKED = st.builds(found, st.just("z"), st.integers(0, LINES), st.integers(0, LINES))
EDITS = st.tuples(st.integers(0, LINES), st.integers(0, 3), st.integers(-2, 3))


def moved(finding: Finding, first: int, last: int, shift: int) -> Finding | None:
    """What an edit does to a finding that takes whole lines away: gone on them, further down behind them."""
    line = finding.place.line
    if first <= line <= last:
        return None
    return finding if line < first else finding._replace(place=Place("a", line + shift, 2, line + shift, 4))


def test_blocks_move_as_their_findings_would() -> None:
    @given(st.lists(PLAIN | LINKED, max_size=300), st.lists(EDITS, max_size=5), st.lists(PLAIN, max_size=3))
    @steady(150)
    def holds(findings: list[Finding], edits: Sequence[tuple[int, int, int]], more: list[Finding]) -> None:
        held, each = Held.of(findings), set(findings)
        for first, several, shift in edits:
            last = first + several
            held = held.changed(first, last, shift, partial(moved, first=first, last=last, shift=shift))
            each = {kept for one in each if (kept := moved(one, first, last, shift)) is not None}
        held, each = held.also(more), each | set(more)
        expected = sorted(each, key=lambda one: (one.order, one.related))
        assert list(held) == expected
        assert len(held) == len(expected)
        assert held.first(7) == expected[:7]
        assert held.on(90, 110) == [one for one in expected if 90 <= one.place.line <= 110]
        lines = sorted({one.place.line for one in more})
        assert list(held.without(lines, frozenset("x"))) == [
            one for one in expected if one.rule != "x" or one.place.line not in lines
        ]

    holds()


def test_an_edit_looks_at_the_findings_near_it_alone() -> None:
    held, looked = Held.of(found("x", line) for line in range(5_000)), list[Finding]()

    def each(finding: Finding) -> Finding:
        looked.append(finding)
        return finding

    after = held.changed(2_500, 2_500, 1, each)
    assert 0 < len(looked) <= 130
    assert [one.place.line for one in after.on(3_001, 3_002)] == [3_001, 3_002]
