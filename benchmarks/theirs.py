"""The same of tree-sitter (C) with tree-sitter-gcode, and of LinuxCNC's own interpreter. Each function runs in a process of its own."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from random import Random
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

from tree_sitter import Language, Parser
from tree_sitter_gcode import language

from benchmarks.corpus import TOOLS
from benchmarks.measure import growth, seconds
from benchmarks.ours import KEYSTROKES, SEED, Keystroke, read

_END = " PROGRAM_END()\n"
"""What the interpreter prints of M2 and M30."""
_TAIL = 500
"""Bytes at the end of what it prints among which that stands, whatever is reset behind it."""


class Unfinished(Exception):
    """The interpreter did not run a program to its end."""


def parser() -> Parser:
    """A parser of G-code."""
    return Parser(Language(language()))


def full(path: str) -> float:
    """Seconds of a full parse."""
    text, parses = read(path).encode(), parser()
    return seconds(lambda: parses.parse(text))


def memory(path: str) -> int:
    """Bytes beyond the text of a parsed program."""
    text, parses = read(path).encode(), parser()
    return growth(lambda: parses.parse(text))


def keystrokes(path: str, places: int) -> dict[str, float]:
    """The median seconds of an incremental parse after each keystroke at random places."""
    text, parses = read(path).encode(), parser()
    tree = parses.parse(text)
    lines = text.split(b"\n")
    starts = [0]
    for ended in lines[:-1]:
        starts.append(starts[-1] + len(ended) + 1)
    found = {}
    for stroke in KEYSTROKES:
        random = Random(SEED)
        taken = []
        for _ in range(places):
            line = random.randrange(len(lines) - 1)
            col = _col(lines[line], stroke)
            at, new = starts[line] + col, stroke.text.encode()
            edited = text[:at] + new + text[at:]
            old = tree.copy()
            end = (line + new.count(b"\n"), 0 if b"\n" in new else col + len(new))
            begin = perf_counter()
            old.edit(at, at, at + len(new), (line, col), (line, col), end)
            parses.parse(edited, old)
            taken.append(perf_counter() - begin)
        found[stroke.name] = median(taken)
    return found


def _col(line: bytes, stroke: Keystroke) -> int:
    return next((col for col, char in enumerate(line, 1) if char in b"0123456789"), 0) if stroke.in_number else 0


def interpreter(path: str) -> float | None:
    """Seconds in which `rs274` runs a program to its end and prints what it does to a file; None where it is not installed.

    Raises Unfinished where it did not get there, for then its time is that of something else.
    """
    command = shutil.which("rs274")
    if command is None:
        return None
    with TemporaryDirectory() as folder:
        tools = Path(folder, "tool.tbl")
        tools.write_text("".join(f"T{number} P{number} Z0.1 D1.0 ;\n" for number in range(1, TOOLS + 1)))
        run, printed, said = [command, "-t", str(tools), "-g", path], Path(folder, "out"), Path(folder, "said")
        with printed.open("wb") as out, said.open("wb") as err:
            begin = perf_counter()
            code = subprocess.run(run, cwd=folder, stdout=out, stderr=err, check=False).returncode
            taken = perf_counter() - begin
        if code or _END not in _tail(printed):
            raise Unfinished(f"{path}: rs274 ended with {code}: {_tail(said) or _tail(printed)}")
        return taken


def _tail(file: Path) -> str:
    with file.open("rb") as lines:
        lines.seek(max(0, file.stat().st_size - _TAIL))
        return lines.read().decode("utf-8", "replace")
