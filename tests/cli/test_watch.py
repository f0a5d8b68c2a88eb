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

from deburr.paths import PART

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

    def end(self) -> None:
        """Leave no process."""
        self.process.kill()
        self.process.wait()
        assert self.process.stdout is not None
        self.process.stdout.close()


@pytest.fixture
def watched(tmp_path: Path) -> Iterator[Watched]:
    (tmp_path / "a.ngc").write_text(CLEAN)
    (tmp_path / "b.ngc").write_text(CLEAN)
    running = Watched(tmp_path, "--output-format", "json=found.json")
    yield running
    running.end()


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


def test_what_no_check_hangs_on_starts_none(tmp_path: Path) -> None:
    (tmp_path / "a.ngc").write_text("#1=5\no<deep> call\nG0 X#31\nM2\n")
    (tmp_path / "deep.ngc").write_text("o<deep> sub\nG0 Z1\no<deep> endsub\nM2\n")
    (tmp_path / "deburr.toml").write_text('[rs274]\nparameters = "stored.dat"\n')
    (tmp_path / "stored.dat").write_text("31 2\n")
    running = Watched(tmp_path, "--no-cache", "--output-format", "sarif=found.sarif")
    try:
        running.until(f"watching {tmp_path.as_posix()}")
        for name in ("run.log", "notes.txt", "other.sarif", "found.sarif", ".found.sarif.0" + PART):
            (tmp_path / name).write_text("nothing that a control reads\n")
            time.sleep(0.3)
        for number, (name, text) in enumerate(
            (("stored.dat", "31 3\n"), ("deep.ngc", CLEAN), ("new.ngc", "G21 G90 G17\nG0 X1\nM2\n")), 1
        ):
            (tmp_path / name).write_text(text)
            running.until("watching again", number)
            time.sleep(0.5)
        (tmp_path / "run.log").write_text("still nothing\n")
        time.sleep(0.5)
        (tmp_path / "a.ngc").write_text(CLEAN)
        running.until("watching again", 4)
        time.sleep(0.5)
        (tmp_path / "deburr.toml").unlink()
        running.until("watching again", 5)
        time.sleep(0.5)
        assert running.said.count("watching again") == 5
    finally:
        running.end()


def test_a_log_in_the_folder_starts_none(tmp_path: Path) -> None:
    (tmp_path / "a.ngc").write_text(FAULTY)
    command = [sys.executable, "-m", "deburr", "check", "--watch", "--no-cache", "--dialect", "rs274"]
    with (tmp_path / "log.txt").open("w") as log:
        process = subprocess.Popen(command, cwd=tmp_path, stdout=log, stderr=log)
        try:
            end = time.monotonic() + PATIENCE
            while "watching" not in (tmp_path / "log.txt").read_text():
                assert time.monotonic() < end and process.poll() is None
                time.sleep(0.1)
            time.sleep(1)
        finally:
            process.kill()
            process.wait()
    assert "watching again" not in (tmp_path / "log.txt").read_text()


def test_a_log_starts_none_while_the_configuration_is_at_fault(tmp_path: Path) -> None:
    """Whoever hands on what a check says, such as `tee`, writes into the folder each time that it says something."""
    (tmp_path / "a.ngc").write_text(CLEAN)
    (tmp_path / "deburr.toml").write_text('extend = "base.conf"\n')
    (tmp_path / "base.conf").write_text("[check]\nselct = []\n")
    running = Watched(tmp_path)
    try:
        running.until(f"watching {tmp_path.as_posix()}")
        for _ in range(2):
            for name in ("run.log", "log.txt", "base.conf.log"):
                with (tmp_path / name).open("a") as log:
                    log.write(running.said)
            time.sleep(0.5)
        # A program that comes is one more that the same is said of; what is at fault may be mended.
        (tmp_path / "b.ngc").write_text(FAULTY)
        time.sleep(0.5)
        (tmp_path / "base.conf").write_text("[check]\nselect = []\n")
        assert "All checks passed (2 checked, 1 skipped" in running.until("watching again")
        (tmp_path / "deburr.toml").write_text("[machine\n")
        assert "deburr.toml:1:9: " in running.until("watching again", 2)
        (tmp_path / "run.log").write_text(running.said)
        (tmp_path / "b.ngc").write_text(CLEAN)
        time.sleep(0.5)
        (tmp_path / "deburr.toml").unlink()
        running.until("watching again", 3)
        assert running.said.count("did you mean `select`") == 1
    finally:
        running.end()


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
