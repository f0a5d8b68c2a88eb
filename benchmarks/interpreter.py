"""LinuxCNC's interpreter as the judge of a program: whether it runs, what is said, and on which line. Never judges deburr."""

from __future__ import annotations

import os
import re
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

SECONDS = 2
"""How long a program may run before it is called endless."""
_SHOWN = 250
"""So much of a long line is shown at least."""
_LIMITS = f'ulimit -t {SECONDS}; ulimit -f 40000; exec rs274 -g -n 2 -t tools.tbl -v p.var "$0"'
_TOOLS = "".join(f"T{number} P{number} D0.001\n" for number in range(1, 100))
_OWN_NUMBER = re.compile(r"([ \t]*/?[ \t]*)(?:[Nn][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?)?")
_MARK = re.compile(r"N7(\d{3})(\d{6})", re.I)
_AT_END = re.compile(r"^(?:File ended with no percent sign|Failed to find sub )")
_CALL = re.compile(r"^EOF in file:(.+) seeking o-word: .* from line: (\d+)$")


@dataclass(frozen=True)
class Program:
    """A program with the files beside it; ``main`` is the name of its own file."""

    main: str
    text: str
    files: tuple[tuple[str, str], ...] = ()

    @property
    def all_files(self) -> dict[str, str]:
        """Every file, the program's own first."""
        return {self.main: self.text, **dict(self.files)}


class Answer(NamedTuple):
    """What became of a run. ``file`` and ``line`` (from 0) are where it was refused; at the end of a file no line is. ``echo`` is the line that it showed."""

    ran: bool
    endless: bool = False
    message: str = ""
    echo: str = ""
    file: str | None = None
    line: int | None = None


class _Run(NamedTuple):
    status: int | None
    output: str
    said: tuple[str, ...]


def answer(program: Program) -> Answer:
    """Run a program; if it is refused, find the line."""
    run = _run(program.main, program.all_files)
    if run.status is None:
        return Answer(False, endless=True)
    if run.status == 0:
        return Answer(True)
    message, echo = _said(run)
    return Answer(False, False, message, echo, *_place(program, run))


def _place(program: Program, run: _Run) -> tuple[str | None, int | None]:
    """The file and line of a refusal. The interpreter names neither: a copy whose lines bear numbers of ours tells both, if it fails the same way."""
    message, echo = _said(run)
    if call := _CALL.match(message):
        return (call[1], int(call[2]) - 1) if int(call[2]) else (call[1], None)
    if _AT_END.match(message):
        return None, None
    names = list(program.all_files)
    numbered = {name: _numbered(text, at) for at, (name, text) in enumerate(program.all_files.items())}
    again = _run(program.main, numbered)
    mark = _MARK.search(_said(again)[1]) if again.status else None
    if mark and _plain(again) == _plain(run):
        return names[int(mark[1])], int(mark[2])
    found = [
        (name, at)
        for name, text in program.all_files.items()
        for at, line in enumerate(_lines(text))
        if line.rstrip() == echo.rstrip() or len(echo) >= _SHOWN and line.startswith(echo)
    ]
    return found[0] if found else (None, None)


def _numbered(text: str, file: int) -> str:
    return "\n".join(
        line if line.lstrip()[:1] in ("", "%") else _OWN_NUMBER.sub(rf"\g<1>N7{file:03}{at:06}", line, count=1)
        for at, line in enumerate(_lines(text))
    )


def _lines(text: str) -> list[str]:
    return text.split("\n")


def _plain(run: _Run) -> tuple[str, str]:
    """What two runs must share to be the same, but for line numbers."""
    message = re.sub(r"(?<=')[ \t]+", "", _MARK.sub("", _said(run)[0]))
    return message, re.sub(r"(?m)^ *\d+ N\S* *", "", run.output)


def _said(run: _Run) -> tuple[str, str]:
    # Errors of O-words carry a line number of their own kind in front.
    lines = [*run.said, "", ""]
    return re.sub(r"^\d+: ", "", lines[0]), lines[1]


def _run(main: str, files: dict[str, str]) -> _Run:
    """Run in a folder and with a home of its own: the interpreter writes into both."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in {**files, "tools.tbl": _TOOLS, "p.var": ""}.items():
            (folder / file).write_bytes(text.encode("utf-8"))
        with (folder / "out").open("wb") as out, (folder / "err").open("wb") as err:
            status = _status(["sh", "-c", _LIMITS, main], folder, out.fileno(), err.fileno())
        output, said = ((folder / one).read_bytes()[:1_000_000].decode("utf-8", "replace") for one in ("out", "err"))
    return _Run(status, output, tuple(line for line in said.split("\n") if line and line != "executing"))


def _status(command: list[str], folder: Path, out: int, err: int) -> int | None:
    """The exit status; None if time or room for output ran out."""
    environment = {**os.environ, "HOME": str(folder)}
    try:
        status = subprocess.run(
            command,
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=err,
            timeout=SECONDS,
            check=False,
        ).returncode
    except subprocess.TimeoutExpired:
        return None
    return None if status in (-signal.SIGXCPU, -signal.SIGXFSZ, -signal.SIGKILL) else status
