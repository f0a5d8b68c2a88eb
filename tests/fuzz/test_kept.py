"""What a fuzzer has found once is tried in every run, and so is what it begins with. No fuzzer is needed."""

from __future__ import annotations

from pathlib import Path

import pytest

from fuzz.choices import Choices, joined
from fuzz.targets import names, target

KEPT = Path(__file__).parent / "kept"


@pytest.mark.parametrize(
    "path", [pytest.param(path, id=f"{path.parent.name}/{path.name}") for path in sorted(KEPT.glob("*/*"))]
)
def test_what_was_found_once(path: Path) -> None:
    target(path.parent.name).run(path.read_bytes())


@pytest.mark.parametrize("name", names())
def test_what_it_begins_with(name: str) -> None:
    found = target(name)
    seeds = list(found.seeds())
    assert seeds
    for seed in seeds[:: max(len(seeds) // 60, 1)]:
        found.run(seed)


def test_everything_that_is_kept_belongs_to_a_target() -> None:
    assert {path.name for path in KEPT.iterdir()} <= set(names())


def test_bytes_are_read_as_choices() -> None:
    choices = Choices(joined((4, 1), "é", b"b\xffc"))
    assert (choices.pick("abc"), choices.byte(), choices.text(), choices.text()) == ("b", 1, "é", "b")
    assert choices
    assert choices.rest() == b"c"
    assert not choices
    assert (choices.byte(), choices.text(), choices.rest()) == (0, "", b"")
