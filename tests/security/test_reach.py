"""Who can reach the server, and what is left of a file when whoever writes it is killed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from deburr.cli.main import main


@pytest.mark.parametrize(
    ("host", "warned"), [("127.0.0.1", False), ("", False), ("localhost", False), ("0.0.0.0", True)]
)
def test_a_server_that_others_can_reach_says_so(host: str, warned: bool) -> None:
    command = [sys.executable, "-m", "deburr", "server", "--tcp", f"{host}:0"]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as server:
        assert server.stderr is not None
        try:
            assert "listening on" in server.stderr.readline()
            time.sleep(0.2)
        finally:
            server.kill()
        assert ("can be reached from other machines" in server.stderr.read()) is warned


def test_a_killed_run_leaves_the_old_files(tmp_path: Path) -> None:
    (tmp_path / "p.ngc").write_text("o1 while [1]\n#1=[#1+1]\nG1 X#1 F1\no1 endwhile\nM2\n")
    (tmp_path / "flat").write_text("as it was\n")
    command = [sys.executable, "-m", "deburr", "expand", "p.ngc", "--max-steps", "0", "--max-blocks", "0", "-o", "flat"]
    with subprocess.Popen([*command, "--partial"], cwd=tmp_path, stdin=subprocess.DEVNULL) as running:
        until = time.monotonic() + 60
        while not _writes(running.pid) and time.monotonic() < until:
            time.sleep(0.05)
        running.send_signal(signal.SIGKILL)
    assert (tmp_path / "flat").read_text() == "as it was\n"


def _writes(process: int) -> bool:
    """Whether a process has written a good deal."""
    said = Path(f"/proc/{process}/io").read_text()
    return int(said.partition("wchar: ")[2].split()[0]) > 100_000


def test_a_report_that_breaks_off_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "p.ngc").write_text("o1 cal\nM2\n")
    (tmp_path / "report").write_text("as it was\n")

    def broken(*_: object) -> None:
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr("deburr.cli.output._report", broken)
    assert main(["check", "p.ngc", "--output-file", "report"]) == 2
    assert (tmp_path / "report").read_text() == "as it was\n"
    assert sorted(each.name for each in tmp_path.iterdir() if not each.name.startswith(".deburr_cache")) == [
        "p.ngc",
        "report",
    ]
