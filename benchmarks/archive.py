"""A whole archive: cold, from the cache, with one program changed, in four parts, and LinuxCNC's interpreter in a loop beside it.

`python -m benchmarks.archive` makes 20,000 programs (200 MB), half of them LinuxCNC's own with small changes, and prints the
times. What must hold is asserted on the way, in work done: which programs were read anew, and that all reports are equal.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from random import Random
from shutil import rmtree, which
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks import corpus

SAMPLES = Path("/usr/share/linuxcnc/ncfiles")
PROGRAMS, BYTES, PARTS, PATIENCE = 20_000, 200_000_000, 4, 10
CALLERS = 9
PLAIN, SHARED = "cam/000/0.ngc", "shared/part.ngc"


@dataclass(frozen=True)
class Figures:
    """Seconds of each step; how many programs there are, and how many bytes; ``interpreter``: seconds for all, None where there is none."""

    programs: int
    size: int
    cold: float
    warm: float
    changed: float
    depending: float
    parts: float
    findings: int
    interpreter: float | None
    timed: int
    """Programs that the interpreter was timed with."""


def made(folder: Path, programs: int, size: int) -> None:
    """Write the archive, the same each time."""
    random = Random(corpus.SEED)
    shared = folder / "shared"
    shared.mkdir(parents=True)
    (folder / SHARED).write_text("o<part> sub\nG1 X[10/#1] F100\no<part> endsub\nM2\n")
    for number in range(1, CALLERS + 1):
        (shared / f"{number}.ngc").write_text(f"G21 G90 G17\no<part> call [{number}]\nM2\n")
    written = CALLERS + 1
    for path in _samples(folder, programs // 2):
        text = path.read_text(encoding="latin-1")
        path.write_text(_changed(text, random), encoding="latin-1", newline="")
        written += 1
    left = size - sum(path.stat().st_size for path in folder.rglob("*.ngc"))
    each = max(left // max(programs - written, 1), 1000)
    base = corpus.cam(each // 20)
    for number in range(programs - written):
        place = folder / "cam" / f"{number // 100:03}" / f"{number}.ngc"
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(_program(base, each, number, random))


def _samples(folder: Path, count: int) -> Iterator[Path]:
    """Copies of LinuxCNC's programs with their folders, so that they find each other."""
    found = sorted(path.relative_to(SAMPLES) for path in SAMPLES.rglob("*.ngc"))
    for at in range(count):
        copy, number = divmod(at, len(found))
        path = folder / "linuxcnc" / f"{copy:03}" / found[number]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes((SAMPLES / found[number]).read_bytes())
        yield path


def _program(base: str, size: int, number: int, random: Random) -> str:
    """A program of about that many bytes, unlike all others."""
    lines = base[:size].split("\n")[:-1]
    for _ in range(5):
        at = random.randrange(3, len(lines))
        lines[at] = f"{lines[at]} (revised {random.randint(1, 999)})"
    return "\n".join([f"(program {number})", *lines, "M2", ""])


def _changed(text: str, random: Random) -> str:
    """A program as somebody leaves it who had little time: digits changed, lines lost, doubled or cut."""
    lines = text.split("\n")
    for _ in range(random.randint(0, 3)):
        at = random.randrange(len(lines))
        line = lines[at]
        how = random.randrange(4)
        if how == 0:
            lines[at] = line.translate(str.maketrans("123", "231"))
        elif how == 1:
            del lines[at]
        elif how == 2:
            lines.insert(at, line)
        else:
            lines[at] = line[: len(line) // 2]
        lines = lines or [""]
    return "\n".join(lines)


class Archive:
    """Checks of a folder in processes of their own, with a cache of their own beside it."""

    def __init__(self, folder: Path, cache: Path) -> None:
        self.folder = folder
        self._cache = cache

    def check(self, *options: str) -> tuple[float, str]:
        """Seconds, and what was said on stderr."""
        command = [sys.executable, "-m", "deburr", "check", ".", "--exit-zero", "-j", "2", *options]
        return self._timed(command)

    def merge(self, *options: str) -> tuple[float, str]:
        """Seconds, and what was said on stderr."""
        return self._timed([sys.executable, "-m", "deburr", "merge", "--exit-zero", *options])

    def forget(self) -> None:
        """The next check is the first."""
        rmtree(self._cache, ignore_errors=True)

    def anew(self, said: str) -> list[str]:
        """The programs that a check with `-v` worked on."""
        lines = (line for line in said.split("\n") if line and "run stopped" not in line)
        return [line.split(": ")[1] for line in lines if not line.endswith("known from an earlier check")]

    def _timed(self, command: Sequence[str]) -> tuple[float, str]:
        environment = {**os.environ, "DEBURR_CACHE_DIR": str(self._cache)}
        start = perf_counter()
        done = subprocess.run(
            command, cwd=self.folder, env=environment, capture_output=True, text=True, check=False, errors="replace"
        )
        taken = perf_counter() - start
        assert done.returncode == 0, done.stderr[-2000:]
        return taken, done.stderr


def measured(archive: Archive, every: int, say: Callable[[str], None] = print) -> Figures:
    """All steps. ``every``: the interpreter is timed with each so-manieth program, and its time multiplied."""
    report = archive.folder.parent / "whole.json"
    whole = ("-q", "--output-format", f"json-lines={report}")
    files = sorted(archive.folder.rglob("*.ngc"))
    archive.forget()
    cold, _ = archive.check(*whole)
    first = report.read_bytes()
    say(f"cold, -j 2: {cold:.1f} s")
    warm = min(archive.check(*whole)[0] for _ in range(2))
    assert report.read_bytes() == first, "what is known is what was found"
    say(f"from the cache: {warm:.2f} s, {cold / warm:.0f} times faster")
    changed = _touched(archive, PLAIN, [PLAIN])
    say(f"one program changed: {changed:.2f} s, 1 read anew")
    callers = [f"shared/{number}.ngc" for number in range(1, CALLERS + 1)]
    depending = _touched(archive, SHARED, [*callers, SHARED])
    say(f"a subprogram changed: {depending:.2f} s, {CALLERS + 1} read anew: it and the programs that call it")
    archive.check(*whole)
    parts = _parts(archive, report)
    say(f"{PARTS} parts, merged: {parts:.2f} s, the same report")
    size = sum(path.stat().st_size for path in files)
    some = files[::every]
    interpreter = _interpreted(some) * len(files) / len(some) if which("rs274") else None
    findings = first.count(b"\n")
    return Figures(len(files), size, cold, warm, changed, depending, parts, findings, interpreter, len(some))


def _touched(archive: Archive, name: str, expected: Sequence[str]) -> float:
    """Seconds behind a change of a program; exactly the programs that hang on it are read anew."""
    path = archive.folder / name
    path.write_text(path.read_text() + "(one more line)\n")
    taken, said = archive.check("-v", "--output-format", f"json-lines={archive.folder.parent / 'again.json'}")
    anew = archive.anew(said)
    assert anew == sorted(expected), anew[:20]
    return taken


def _parts(archive: Archive, whole: Path) -> float:
    """Seconds for all parts one after the other; together they report what one check does."""
    names = [str(whole.with_name(f"{number}.json")) for number in range(1, PARTS + 1)]
    taken = 0.0
    for number, name in enumerate(names, 1):
        taken += archive.check("-q", "--shard", f"{number}/{PARTS}", "--output-format", f"json-lines={name}")[0]
    merged = whole.with_name("merged.json")
    taken += archive.merge(*names, "--output-format", f"json-lines={merged}")[0]
    assert merged.read_bytes() == whole.read_bytes(), "the parts are the whole"
    return taken


def _interpreted(files: Sequence[Path]) -> float:
    """Seconds for which LinuxCNC's interpreter runs over programs, one after the other, each for as long as anybody would wait."""
    with TemporaryDirectory() as home:
        folder = Path(home)
        (folder / "tools.tbl").write_text("".join(f"T{n} P{n} D0.001\n" for n in range(1, 100)))
        (folder / "p.var").write_text("")
        start = perf_counter()
        for path in files:
            command = [
                "rs274",
                "-g",
                "-n",
                "2",
                "-t",
                str(folder / "tools.tbl"),
                "-v",
                str(folder / "p.var"),
                str(path),
            ]
            with suppress(subprocess.TimeoutExpired):
                subprocess.run(
                    command,
                    cwd=path.parent,
                    env={**os.environ, "HOME": home},
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    timeout=PATIENCE,
                    check=False,
                )
        return perf_counter() - start


def main(arguments: Sequence[str] | None = None) -> int:
    """Make the archive, measure, print."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.archive", description=__doc__)
    parser.add_argument("--programs", type=int, default=PROGRAMS)
    parser.add_argument("--bytes", type=int, default=BYTES)
    parser.add_argument("--every", type=int, default=20, help="time rs274 with each so-manieth program (default: 20)")
    asked = parser.parse_args(arguments)
    with TemporaryDirectory() as home:
        folder = Path(home) / "archive"
        made(folder, asked.programs, asked.bytes)
        found = measured(Archive(folder, Path(home) / "kept"), asked.every)
    print(f"{found.programs:,} programs, {found.size / 1e6:.0f} MB, {found.findings:,} findings")
    if found.interpreter is not None:
        beside = f"{found.interpreter:.0f} s for all, timed with {found.timed:,} of them"
        print(f"rs274 -g in a loop: {beside}, one after the other, each for {PATIENCE} s at most")
    return 0


if __name__ == "__main__":
    sys.exit(main())
