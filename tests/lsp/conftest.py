"""A server of its own for each test, in a folder of its own."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from support.client import Client


@pytest.fixture
def launch(tmp_path: Path) -> Iterator[Callable[..., Client]]:
    """Starts servers; none outlives its test."""
    started: list[Client] = []

    def made(*arguments: str) -> Client:
        started.append(Client(tmp_path, *arguments))
        return started[-1]

    yield made
    for client in started:
        client.kill()


@pytest.fixture
def client(launch: Callable[..., Client]) -> Client:
    """A server that nobody has spoken to."""
    return launch()
