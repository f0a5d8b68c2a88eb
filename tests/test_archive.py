"""A small archive, as `python -m benchmarks.archive` makes a large one: the reports are equal, and only what changed is read anew."""

from __future__ import annotations

import pytest
from benchmarks.archive import Archive, made, measured

PROGRAMS, BYTES = 200, 600_000


@pytest.mark.oracle
def test_an_archive(tmp_path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "archive"
    made(folder, PROGRAMS, BYTES)
    said: list[str] = []
    found = measured(Archive(folder, tmp_path / "kept"), 50, said.append)
    with capsys.disabled():
        print(f"\narchive: {'; '.join(said)}")
    assert (found.programs, found.timed) == (PROGRAMS, 4)
    assert 0.5 * BYTES < found.size < 1.5 * BYTES and found.findings > 50
    assert found.interpreter is not None and found.interpreter > 0
    # Seven times and more were measured for so few programs, of which most of the time is the start.
    assert found.warm * 2 < found.cold


def test_it_is_the_same_each_time(tmp_path) -> None:
    for name in ("one", "other"):
        made(tmp_path / name, 30, 100_000)
    one, other = (
        {path.relative_to(tmp_path / name): path.read_bytes() for path in (tmp_path / name).rglob("*.ngc")}
        for name in ("one", "other")
    )
    assert one == other and len(one) == 30
