"""The same program gives the same answer in every process, to the byte and in the same order."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

TESTS = Path(__file__).parents[1]
FIRST, BEHIND = 0, 5


def test_processes_say_the_same_in_the_same_order() -> None:
    """Python hashes texts otherwise in each process, and places differ: nothing may hang on the order of a set."""
    first, second = (_told(seed) for seed in ("1", "2"))
    sorts = Counter(line.split(" ", 1)[1].rpartition(" ")[0] for line in first)
    assert sorts == dict.fromkeys(("rs274", "rs274 with mistakes", "z32", "metagcode", "cgt"), BEHIND - FIRST)
    assert len({line.rpartition(" ")[2] for line in first}) > 3 * (BEHIND - FIRST)
    assert first == second


def _told(hashes: str) -> list[str]:
    environment = {**os.environ, "PYTHONHASHSEED": hashes, "PYTHONPATH": str(TESTS)}
    command = [sys.executable, "-m", "support.told", str(FIRST), str(BEHIND)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()
