"""No file that deburr is given can make it read elsewhere, hang, fill the memory, or write to the terminal what it likes."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from support.hostile import ALL, SECRET, Hostile

ROOT = Path(__file__).parents[2]
SECONDS = 60
"""Each takes one or two; a busy machine may take more."""
LAUNCHER = """
import resource, subprocess, sys
code = subprocess.call(sys.argv[2:])
with open(sys.argv[1], "w") as used:
    used.write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss))
sys.exit(code)
"""
"""A process counts the memory of the one that started it as its own, so a small one starts it."""


@pytest.mark.parametrize("hostile", ALL, ids=lambda hostile: hostile.name)
def test_it_is_refused_soon_and_cheaply(hostile: Hostile, tmp_path: Path) -> None:
    folder = made(hostile, tmp_path)
    command = [sys.executable, "-c", LAUNCHER, str(tmp_path / "used"), sys.executable, "-m", "deburr", *hostile.command]
    with (tmp_path / "said").open("wb") as said:
        ran = subprocess.run(
            command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said, timeout=SECONDS, check=False
        )
    answer = (tmp_path / "said").read_text("utf-8", "replace")
    assert ran.returncode == hostile.code, answer[:2000]
    assert hostile.says in answer, answer[:2000]
    assert SECRET not in answer and "Traceback" not in answer
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", answer), "nothing in a file speaks to the terminal"
    assert int((tmp_path / "used").read_text()) // 1024 < hostile.most


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


def test_the_threat_model_names_each() -> None:
    page = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
    assert re.findall(r"(?m)^\| `([a-z-]+)` \|", page) == [each.name for each in ALL]
