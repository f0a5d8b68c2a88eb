"""Standard streams that are closed, full, or left by their reader: the exit code is that of what was found, and nobody sees a traceback."""

import os
import subprocess
import sys

import pytest

FAULTY = "G21 G90 G17\nF100\nG0 X[1/0]\nM2\n"
CLEAN = "G21 G90 G17\nF100\nG0 X1\nM2\n"
FULL = "deburr: error: standard output: No space left on device\n"
DEBURR = f'"{sys.executable}" -m deburr'

CODES = {
    "check faulty.ngc": 1,
    "check clean.ngc": 0,
    "expand clean.ngc": 0,
    "expand faulty.ngc": 1,
    "expand --stats text clean.ngc": 0,
    "plot clean.ngc": 0,
    "format --check clean.ngc": 0,
    "rule rs274.o-mismatch": 0,
    "explain-dialect clean.ngc": 0,
    "server": 1,
    "--version": 0,
    "check --no-such-option": 2,
    "no-such-command": 2,
}
SILENT = {"expand faulty.ngc", "server", "check --no-such-option", "no-such-command"}
"""What writes nothing to standard output."""


@pytest.fixture
def folder(shell):
    shell.write("faulty.ngc", FAULTY)
    shell.write("clean.ngc", CLEAN)
    return shell.folder


def bash(script, folder):
    return subprocess.run(
        ["bash", "-o", "pipefail", "-c", script], cwd=folder, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL
    )  # fmt: skip


@pytest.mark.parametrize("command", CODES)
def test_closed_streams_and_full_disks(folder, command):
    way = f"{DEBURR} {command}"
    ran = bash(f"{way} >&-; echo $? >&2; {way} >/dev/full", folder)
    assert "Traceback" not in ran.stderr
    assert [int(line) for line in ran.stderr.split("\n") if line.isdigit()] == [CODES[command]]
    assert (ran.returncode, ran.stderr.endswith(FULL)) == ((CODES[command], False) if command in SILENT else (2, True))


def test_what_is_said_on_a_full_disk_or_a_closed_stream_gets_nowhere_else(folder):
    ran = bash(f"{DEBURR} expand faulty.ngc 2>&-", folder)
    assert (ran.returncode, ran.stdout) == (1, "")
    ran = bash(f"{DEBURR} expand faulty.ngc 2>/dev/full", folder)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert bash(f"{DEBURR} check faulty.ngc <&- >&- 2>&-", folder).returncode == 1


@pytest.mark.parametrize("command", ["check -", "expand -", "format -", "explain-dialect -"])
def test_closed_input_is_no_empty_program(folder, command):
    ran = bash(f"{DEBURR} {command} <&-", folder)
    assert ran.returncode == 2 and "deburr: error: -: standard input is closed\n" in ran.stderr


def test_a_reader_who_goes_early_changes_no_exit_code(folder):
    (folder / "long.ngc").write_text("G0 X[1/0]\n" * 1000)
    ran = bash(f"{DEBURR} check long.ngc | head -n 1", folder)
    assert (ran.returncode, len(ran.stdout.splitlines()), ran.stderr) == (1, 1, "")
    ran = bash(f"{DEBURR} check long.ngc --output-format full --output-format concise=report | true", folder)
    assert (ran.returncode, ran.stderr) == (1, "")
    assert len((folder / "report").read_text().splitlines()) == 1002, "what goes elsewhere is written"
    ran = bash(f"{DEBURR} expand long.ngc 2>&1 | true", folder)
    assert (ran.returncode, ran.stderr) == (1, "")
    ran = bash(f"{DEBURR} check clean.ngc | true", folder)
    assert (ran.returncode, ran.stderr) == (0, "")


def test_a_pipe_that_does_not_wait_gets_all(folder):
    (folder / "long.ngc").write_text("G0 X[1/0]\n" * 1000)
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    command = [sys.executable, "-m", "deburr", "check", "--output-format", "concise", "long.ngc"]
    with subprocess.Popen(command, cwd=folder, stdout=writing, stderr=subprocess.PIPE) as process:
        os.close(writing)
        with os.fdopen(reading) as lines:
            assert len(lines.readlines()) == 1002
        assert process.stderr is not None and process.stderr.read() == b""
    assert process.returncode == 1
