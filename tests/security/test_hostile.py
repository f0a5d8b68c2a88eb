"""No file that deburr is given can make it read elsewhere, hang, fill the memory, or write to the terminal what it likes."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from pathlib import Path

import pytest

from support.hostile import ALL, SECRET, Hostile

ROOT = Path(__file__).parents[2]
SECONDS = 60
"""Each takes one or two; a busy machine may take more."""


@pytest.mark.parametrize("hostile", ALL, ids=lambda hostile: hostile.name)
def test_it_is_refused_soon_and_cheaply(hostile: Hostile, tmp_path: Path) -> None:
    folder = made(hostile, tmp_path)
    with (tmp_path / "said").open("wb") as said:
        command = [sys.executable, "-m", "deburr", *hostile.command]
        running = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        code, mebibytes = ended(running)
    answer = (tmp_path / "said").read_text("utf-8", "replace")
    assert code == hostile.code, answer[:2000]
    assert hostile.says in answer, answer[:2000]
    assert SECRET not in answer and "Traceback" not in answer
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", answer), "nothing in a file speaks to the terminal"
    assert mebibytes < hostile.most


def made(hostile: Hostile, around: Path) -> Path:
    """The folder, with secrets beside it."""
    for name in ("secret", "secret.ngc"):
        (around / name).write_text(f"{SECRET}\n")
    folder = around / "job"
    folder.mkdir()
    for name, text in hostile.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    hostile.prepare(folder)
    return folder


def ended(running: subprocess.Popen[bytes]) -> tuple[int, int]:
    """The exit code and the mebibytes of a process that ends by itself."""
    until = time.monotonic() + SECONDS
    while True:
        done, status, used = os.wait4(running.pid, os.WNOHANG)
        if done:
            running.returncode = os.waitstatus_to_exitcode(status)
            return running.returncode, used.ru_maxrss // 1024
        if time.monotonic() > until:
            running.kill()
            running.wait()
            raise AssertionError(f"not ended after {SECONDS} s")
        time.sleep(0.01)


def test_the_threat_model_names_each() -> None:
    page = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
    assert re.findall(r"(?m)^\| `([a-z-]+)` \|", page) == [each.name for each in ALL]
