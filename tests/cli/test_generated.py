"""What is derived from the code is what the code says now: `python -m deburr.dev.generate` writes it anew."""

from pathlib import Path

import pytest

from deburr.dev.generate import main, stale


def test_derived_files_are_fresh():
    assert stale(Path(__file__).parents[2]) == []


def test_elsewhere_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(tmp_path)
    assert main() == 2
    assert "run this in its top folder" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
