"""Programs that fail become as small as they can while they fail."""

from __future__ import annotations

from support.shrinking import Case, shrunk

LONG: Case = {
    "main.x": "".join(f"line {at} of a part\n" for at in range(40)),
    "other.x": "open\nin it\nclose\n",
    "run 1": "A 1\nB 2\n",
    "run 2": "A 3\n",
}


def _fails(case: Case) -> bool:
    """Lines 7 and 31 together, where what is opened is closed, with the first line of a run."""
    words = case.get("main.x", "").split()
    other = case.get("other.x", "")
    return "7" in words and "31" in words and ("open" in other) == ("close" in other) and "A 1" in case.get("run 1", "")


def test_what_does_not_matter_is_left_out() -> None:
    small = shrunk(LONG, _fails, 3_000)
    assert small["main.x"].split() == ["7", "31"]
    assert small == {"main.x": small["main.x"], "run 1": "A 1\n"}


def test_it_is_the_same_every_time_and_fails_as_before() -> None:
    small = shrunk(LONG, _fails, 3_000)
    assert small == shrunk(LONG, _fails, 3_000) and _fails(small)


def test_it_ends_after_so_many_tries() -> None:
    tries = []

    def fails(case: Case) -> bool:
        tries.append(case)
        return _fails(case)

    assert _fails(shrunk(LONG, fails, 25))
    assert len(tries) == 25


def test_a_case_that_is_as_small_as_can_be_stays() -> None:
    case = {"main.x": "7 31\n", "run 1": "A 1\n"}
    assert shrunk(case, lambda each: each == case, 100) == case
