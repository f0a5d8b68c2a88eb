"""`--watch` and the progress that a terminal shows."""

from __future__ import annotations

import os
import pty
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

CLEAN, FAULTY = "G21 G90 G17\nF100\nM2\n", "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n"
PATIENCE = 60
"""Seconds that a machine may take over what takes a moment."""


class Watched:
    """A check that goes on, and all that it has said."""

    def __init__(self, folder: Path, *arguments: str) -> None:
        command = [sys.executable, "-m", "deburr", "check", "--watch", "--output-format", "concise", *arguments]
        # Whoever runs the tests in the background has interrupts ignored, and a child inherits that.
        self.process = subprocess.Popen(
            command,
            cwd=folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )
        self.said = ""

    def until(self, text: str, times: int = 1) -> str:
        """What is said until a text has come so often."""
        assert self.process.stdout is not None
        end = time.monotonic() + PATIENCE
        while self.said.count(text) < times:
            assert time.monotonic() < end and self.process.poll() is None, self.said
            if select.select([self.process.stdout], [], [], 1)[0]:
                self.said += os.read(self.process.stdout.fileno(), 65536).decode()
        return self.said


@pytest.fixture
def watched(tmp_path: Path) -> Iterator[Watched]:
    (tmp_path / "a.ngc").write_text(CLEAN)
    (tmp_path / "b.ngc").write_text(CLEAN)
    running = Watched(tmp_path, "--output-format", "json=found.json")
    yield running
    running.process.kill()
    running.process.wait()
    assert running.process.stdout is not None
    running.process.stdout.close()


def test_each_change_is_checked(watched: Watched, tmp_path: Path) -> None:
    assert "All checks passed (2 checked)" in watched.until(f"watching {tmp_path.as_posix()}")
    (tmp_path / "a.ngc").write_text(FAULTY)
    assert "a.ngc:2:8: error rs274.divide-by-zero" in watched.until("watching again")
    (tmp_path / "deburr.toml").write_text("[check]\nselct = []\n")
    assert "did you mean `select`" in watched.until("watching again", 2)
    (tmp_path / "deburr.toml").unlink()
    (tmp_path / "a.ngc").write_text(CLEAN)
    assert watched.until("watching again", 3).count("All checks passed") == 2
    # It wrote a report and kept results, and was not woken by that.
    assert watched.said.count("watching again") == 3
    watched.process.send_signal(signal.SIGINT)
    assert watched.process.wait(PATIENCE) == 130


def test_it_ends_when_its_reader_has_gone(watched: Watched, tmp_path: Path) -> None:
    watched.until(f"watching {tmp_path.as_posix()}")
    assert watched.process.stdout is not None
    watched.process.stdout.close()
    (tmp_path / "a.ngc").write_text(FAULTY)
    assert watched.process.wait(PATIENCE) == 0


def test_without_the_library_the_way_out_is_said(shell, monkeypatch):
    shell.write("a.ngc", CLEAN)
    monkeypatch.setitem(sys.modules, "watchfiles", None)
    said = "deburr: error: --watch needs the library watchfiles: pip install 'watchfiles>=1.0'\n"
    assert shell.run("check", "--watch") == (2, "", said)


@pytest.mark.parametrize("options", [["--fix"], ["--diff"], ["-"], ["--stdin-filename", "a.ngc"]])
def test_what_cannot_be_watched(shell, options):
    ran = shell.run("check", "--watch", *options)
    assert ran.code == 2 and "--watch: watches files and changes none" in ran.err


def test_a_folder_that_is_not_there(shell):
    assert "none/a.ngc: no such file or folder" in shell.run("check", "--watch", "none/a.ngc").err


def on_a_terminal(folder: Path, *arguments: str) -> str:
    """What a check writes on a terminal."""
    mine, theirs = pty.openpty()
    command = [sys.executable, "-c", SLOW, *arguments]
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    said = b""
    while True:
        try:
            said += (part := os.read(mine, 65536))
        except OSError:
            break
        if not part:
            break
    process.wait()
    os.close(mine)
    return said.decode()


SLOW = """
import sys
import deburr.cli.progress as progress
progress._PAUSE = 0
from deburr.cli.main import main
sys.exit(main(["check", "--no-cache", *sys.argv[1:]]))
"""


def test_a_terminal_shows_how_far_it_is(tmp_path: Path) -> None:
    for name in "abc":
        (tmp_path / f"{name}.ngc").write_text(CLEAN)
    said = on_a_terminal(tmp_path)
    assert "deburr: 1 of 3 programs" in said and "deburr: 3 of 3 programs" in said
    assert said.endswith("\r\x1b[K")
    assert on_a_terminal(tmp_path, "-q") == ""
    assert on_a_terminal(tmp_path, "a.ngc") == ""


def test_nobody_else_is_shown_progress(shell):
    for name in "abc":
        shell.write(f"{name}.ngc", CLEAN)
    assert shell.run("check").err == ""
