"""A riddle that nobody guesses at once: each sign that is right shows that one is on the way, to a fuzzer that sees which code is run."""

from __future__ import annotations

from collections.abc import Iterator


def run(data: bytes) -> None:
    """Fails for what begins with `O<s>` and nothing else."""
    if data[:1] == b"O":  # noqa: SIM102
        if data[1:2] == b"<":  # noqa: SIM102
            if data[2:3] == b"s":
                assert data[3:4] != b">", "solved"


def seeds() -> Iterator[bytes]:
    """Nothing that helps."""
    yield b"........"
