"""What is derived from the code is what the code says now: `python -m deburr.dev.generate` writes it anew."""

from deburr.dev.generate import stale


def test_derived_files_are_fresh():
    assert stale() == []
