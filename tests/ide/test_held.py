"""Findings that are kept in blocks stand, behind any edits, where findings stand that are moved one by one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.finding import Finding, Place, Related, Severity
from deburr.ide.held import Held
from support.strategies import steady

LINES = 400


def found(rule: str, line: int, *points: int, file: str = "a") -> Finding:
    related = tuple(Related(Place(file, each, 0, each, 1), "") for each in points)
    return Finding(rule, Severity.ERROR, "m", Place("a", line, 2, line, 4), related)


PLAIN = st.builds(found, st.sampled_from("xy"), st.integers(0, LINES))
LINKED = st.builds(
    lambda line, points, file: found("z", line, *points, file=file),
    st.integers(0, LINES),
    st.lists(st.integers(0, LINES), min_size=1, max_size=3),
    st.sampled_from("aab"),
)
EDITS = st.tuples(st.integers(0, LINES), st.integers(0, 3), st.integers(-2, 3))


def moved(finding: Finding, first: int, last: int, shift: int) -> Finding | None:
    """What an edit does to a finding that takes whole lines away: gone on them, further down behind them; what points to them points to the first."""
    line = finding.place.line
    if first <= line <= last:
        return None
    related = tuple(pointing(each, first, last, shift) for each in finding.related)
    if line < first:
        return finding if related == finding.related else finding._replace(related=related)
    return finding._replace(place=Place("a", line + shift, 2, line + shift, 4), related=related)


def pointing(related: Related, first: int, last: int, shift: int) -> Related:
    line = related.place.line
    if related.place.file != "a" or line < first:
        return related
    return related._replace(place=Place("a", now := first if line <= last else line + shift, 0, now, 1))


def test_blocks_move_as_their_findings_would() -> None:
    @given(st.lists(PLAIN | LINKED, max_size=300), st.lists(EDITS, max_size=5), st.lists(PLAIN | LINKED, max_size=3))
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


LINKS = {
    "above": (lambda line: (line - 1,)),
    "far away": (lambda line: (line - 4_000, line - 1)),
    "to one place": (lambda line: (10, 4_000)),
}
"""To what the finding on a line points."""


@pytest.mark.parametrize("links", LINKS.values(), ids=LINKS)
@pytest.mark.parametrize("line", [4_500, 7_000])
@pytest.mark.parametrize("shift", [0, 1])
def test_an_edit_looks_at_few_of_the_findings_that_point_elsewhere(
    links: Callable[[int], tuple[int, ...]], line: int, shift: int
) -> None:
    """There are 5,000, and those near the edit are looked at, with those that point there."""
    findings = [found("x", each, *links(each)) for each in range(4_000, 9_000)]
    looked = list[Finding]()

    def each(finding: Finding) -> Finding | None:
        looked.append(finding)
        return moved(finding, line, line, shift)

    held = Held.of(findings)
    after = held.changed(line, line, shift, each)
    assert len(looked) <= 4 * 64
    assert list(after) == [now for one in findings if (now := moved(one, line, line, shift))]
    kept = set(map(id, findings)) & set(map(id, after))
    same = sum(one.place.line < line or not shift for one in after) - len(looked)
    assert len(kept) >= same, "what stands where it stood is the same"
