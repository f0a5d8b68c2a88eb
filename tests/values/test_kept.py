"""What is kept of lines that were gone through is bounded by the lines in all."""

from __future__ import annotations

from deburr.values.kept import Kept


def test_the_longest_unused_go_when_there_are_too_many_lines() -> None:
    kept: Kept[str] = Kept(10)
    for key, lines in (("a", 4), ("b", 4), ("c", 2)):
        kept.add(key, key.upper(), lines)
    assert (kept.get("a"), kept.lines) == ("A", 10)
    kept.add("d", "D", 3)
    assert [kept.get(key) for key in "abcd"] == ["A", None, "C", "D"]
    assert kept.lines == 9


def test_what_is_larger_than_all_that_may_be_kept_is_kept_alone() -> None:
    kept: Kept[str] = Kept(10)
    kept.add("a", "A", 1)
    kept.add("b", "B", 50)
    assert (len(kept), kept.lines, kept.get("b")) == (1, 50, "B")
    kept.add("c", "C", 1)
    assert (len(kept), kept.lines, kept.get("c")) == (1, 1, "C")


def test_what_is_added_again_counts_once_and_nothing_counts_for_nothing() -> None:
    kept: Kept[str] = Kept(10)
    for lines in (3, 8, 0):
        kept.add("a", f"A{lines}", lines)
    assert (len(kept), kept.lines, kept.get("a")) == (1, 1, "A0")


def test_a_program_that_is_longer_fits_as_long_as_it_is_gone_through() -> None:
    kept: Kept[str] = Kept(10)
    kept.fit(20)
    for key in "abcd":
        kept.add(key, key, 10)
    assert len(kept) == 4
    kept.fit(3)
    kept.add("e", "e", 5)
    assert (len(kept), kept.lines) == (1, 5)
