"""Runs of random programs do what is proven of them, in each language; programs of which something wrong was once proven are kept and tried in every run."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from pathlib import Path

import pytest

from support.runs import KEPT, Language, agree, kept, plant, read
from support.runs.cgt import CGT
from support.runs.metagcode import METAGCODE
from support.runs.rs274 import LOOPS, RS274
from support.runs.z32 import Z32

LANGUAGES = (RS274, METAGCODE, CGT, Z32)
SEEDS: tuple[tuple[Language, int, int, int], ...] = (
    (RS274, 1_500, 100, 1_000),
    (METAGCODE, 2_000, 250, 250),
    (CGT, 600, 60, 1_000),
    (Z32, 1_000, 100, 1_000),
)
"""A language, how many of its programs are run, how many together, and how much must be looked at in those."""
PROGRAMS = 5_000
"""So many programs of all languages are run at least."""
FAULTS = [pytest.param(each, fault, id=f"{each.name}-{fault}") for each in LANGUAGES for fault in each.mutants]
CASES = [(each, path) for each in LANGUAGES for path in kept(each)]
_OTHERS = range(90_000, 92_000)
"""Seeds at which faults of the analysis are looked for."""


def _groups() -> Iterator[tuple[Language, range, int]]:
    for language, count, together, least_seen in SEEDS:
        for first in range(0, count, together):
            yield language, range(first, first + together), least_seen


def test_so_many_programs_are_run() -> None:
    """Each seed of a language is in one group only."""
    programs = [(language.name, seed) for language, seeds, _ in _groups() for seed in seeds]
    assert len(set(programs)) == len(programs) >= PROGRAMS


@pytest.fixture(scope="module", autouse=True)
def _tables_at_rest() -> Iterator[None]:
    """What was made before, such as the tables of the parser, need not be looked through for garbage again and again."""
    gc.freeze()
    yield
    gc.unfreeze()


@pytest.mark.parametrize(
    ("language", "seeds", "seen"),
    [pytest.param(*each, id=f"{each[0].name}-{each[1].start}") for each in _groups()],
)
def test_runs_see_what_is_proven(language: Language, seeds: range, seen: int) -> None:
    """Each value that a run sees lies in the range of its place, nothing is passed of which a fault is proven, and no way is gone that is never taken."""
    tried = agree(language, seeds)
    assert tried.seen > seen
    assert sum(tried.confirmed.values()) > 0


def test_loops_that_never_end_never_do() -> None:
    """A run that comes to one stops in it because it was enough, and no loop that ends is called endless."""
    confirmed = agree(LOOPS, range(200)).confirmed
    assert confirmed["rs274.limit"] > 100 and confirmed["rs274.loop-idle"] > 100


@pytest.mark.parametrize(
    ("language", "path"), [pytest.param(*each, id=f"{each[0].name}-{each[1].stem}") for each in CASES]
)
def test_what_was_wrong_once_is_right(language: Language, path: Path) -> None:
    assert not language.tried(read(path.read_text(encoding="utf-8"))).wrong


def test_each_folder_belongs_to_a_language() -> None:
    assert {path.name for path in KEPT.iterdir()} == {each.name for each in LANGUAGES}


@pytest.mark.parametrize(("language", "fault"), FAULTS)
def test_a_fault_of_the_analysis_is_seen_in_random_programs(
    language: Language, fault: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The proof that runs are looked at."""
    plant(language, fault, monkeypatch)
    assert any(language.tried(language.case(seed)).wrong for seed in _OTHERS)


@pytest.mark.parametrize(("language", "fault"), FAULTS)
def test_a_fault_of_the_analysis_is_seen_in_what_is_kept(
    language: Language, fault: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant(language, fault, monkeypatch)
    assert any(language.tried(read(path.read_text(encoding="utf-8"))).wrong for path in kept(language))


def test_a_program_that_fails_is_told_with_little_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    plant(RS274, "ways of which none is ever taken", monkeypatch)
    with pytest.raises(AssertionError) as caught:
        agree(RS274, _OTHERS)
    said = str(caught.value)
    assert "of rs274: " in said and "tests/values/kept/rs274/" in said and said.startswith("seed 9")
    assert len(said.splitlines()) < 12
