"""A long day: every answer comes, and memory stays where it was after the first rounds. DEBURR_SOAK=MINUTES makes it that long."""

from __future__ import annotations

import os
import time
from collections import Counter
from collections.abc import Callable
from random import Random

import pytest

from support.client import PUSHED, Client
from support.soak import FILES, Seen, Typist, requests

MINUTES = float(os.environ.get("DEBURR_SOAK", "0"))
ROUNDS, WARM = 6, 2
FILLING = 1 / 3
"""The part of the long run that is its warm-up: nobody pauses, so that what is kept of text that is ever new is as much as it may be."""
PAUSE = 0.02
"""Seconds between two keystrokes of the rest; someone who types fast needs ten times as many."""
MOST = 0.05


@pytest.mark.timeout(600 + 60 * MINUTES)
def test_every_request_is_answered_and_memory_is_flat(launch: Callable[..., Client]) -> None:
    client = launch()
    client.start(PUSHED)
    begun = time.monotonic()
    filled, until = begun + 60 * MINUTES * FILLING, begun + 60 * MINUTES

    def pause() -> None:
        if MINUTES and time.monotonic() > filled:
            time.sleep(PAUSE)

    typist, warm = Typist(client, client.folder, pause, Random(0) if MINUTES else None), WARM
    while len(typist.seen.resident) < ROUNDS or time.monotonic() < until:
        # The same work comes again and again, in the long run every third time, with text that is ever new: whatever grows then is a leak.
        typist.round(len(typist.seen.resident) % 3 if MINUTES else 0)
        if time.monotonic() < filled:
            warm = max(len(typist.seen.resident), WARM)
    assert client.stop() == 0
    check(typist.seen, warm)


def check(seen: Seen, warm: int) -> None:
    megabytes = [round(each / 1e6, 1) for each in seen.resident]
    growth = seen.growth(warm)
    print(f"{FILES} files, {len(megabytes)} rounds, {seen.edits} edits, {seen.answers.total()} answers")
    print(f"resident MB after each round: {megabytes}; growth after round {warm}: {growth:.1%}")
    assert Counter(seen.wrong) == Counter()
    assert set(requests()) <= set(seen.answers)
    assert growth < MOST
