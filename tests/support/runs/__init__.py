"""Runs of programs beside what is proven of them, in any language: whether they agree, and if not, how little is enough to see it. Knows no language."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

from deburr.values.kept import Kept
from support.shrinking import Case, is_run, shrunk

KEPT = Path(__file__).parents[2] / "values" / "kept"
"""Programs of which something wrong was once proven, a folder for each language."""
STEPS = 800
"""Tries to make a program smaller."""
_NAME = re.compile(r"^-- (.+) --\n", re.M)


class Wrong(NamedTuple):
    """Something that a run did although it was proven that it cannot: where, in which way, what was seen and what was proven."""

    place: object
    how: str
    seen: object = ""
    proven: object = ""


class Tried(NamedTuple):
    """What runs of a case came to: how many values were looked at, how often findings of which rules on ways and loops were, and what was wrong."""

    seen: int = 0
    confirmed: Mapping[str, int] = {}
    wrong: Sequence[Wrong] = ()


class Language(NamedTuple):
    """How programs of a language are made and tried, where its analysis keeps what it has built, and faults of it, each of which runs must show."""

    name: str
    case: Callable[[int], Case]
    tried: Callable[[Case], Tried]
    caches: tuple[str, ...]
    mutants: Mapping[str, Callable[[pytest.MonkeyPatch], None]]


def plant(language: Language, fault: str, patch: pytest.MonkeyPatch) -> None:
    """Put a fault into the analysis. Nothing is used that was built before, and nothing afterwards that is built from now on."""
    for place in (*language.caches, "deburr.values.ledger._kept", "deburr.values.ledger._latest"):
        patch.setattr(place, Kept())
    language.mutants[fault](patch)


def agree(language: Language, seeds: Iterable[int]) -> Tried:
    """Assert that runs of the programs of these seeds do what is proven; how much was looked at."""
    seen, confirmed = 0, Counter[str]()
    for seed in seeds:
        case = language.case(seed)
        tried = language.tried(case)
        assert not tried.wrong, told(language, seed, case, tried.wrong[0])
        seen += tried.seen
        confirmed.update(tried.confirmed)
    return Tried(seen, confirmed)


def told(language: Language, seed: int, case: Case, wrong: Wrong) -> str:
    """What is said of a program of which something wrong is proven, with as little of it as shows that."""
    small = least(language, case, wrong.how)
    found = next(each for each in language.tried(small).wrong if each.how == wrong.how)
    return (
        f"seed {seed} of {language.name}: {found.place} {found.how}; seen: {found.seen}; proven: {found.proven}\n"
        f"{written(small)}\nWhen it is mended, keep this as {'/'.join(KEPT.parts[-3:])}/{language.name}/NAME.txt"
    )


def least(language: Language, case: Case, how: str) -> Case:
    """As little of a case as goes wrong in the same way."""
    return shrunk(case, lambda each: any(wrong.how == how for wrong in language.tried(each).wrong), STEPS)


def kept(language: Language) -> list[Path]:
    """The cases that are kept of a language."""
    return sorted((KEPT / language.name).glob("*.txt"))


def given(case: Case) -> list[str]:
    """What each run of a case is given."""
    return [text for name, text in case.items() if is_run(name)]


def written(case: Case) -> str:
    """A case as it is kept."""
    return "".join(f"-- {name} --\n{text}" + ("" if text.endswith("\n") else "\n") for name, text in case.items())


def read(text: str) -> Case:
    """A case that was kept; what stands above its first file tells of it."""
    parts = _NAME.split(text)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))
