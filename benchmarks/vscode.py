"""`python -m benchmarks.vscode`: from a key to its repaint in a real VS Code, with a large program and while a large toolpath is drawn.

The rows are those of the table *In VS Code* of `python -m benchmarks`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import TYPE_CHECKING

from benchmarks import corpus
from benchmarks.rows import Files, Row, Sizes

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

if TYPE_CHECKING:
    from support.vscode import Workbench

LINES = 300_000
MOVES = 1_000_000
KEYS = 30
_FROZEN_MS = 2_000
"""From here on a window counts as frozen, on a busy machine too."""
_VSIX = Path(__file__).parents[1] / "vscode-extension" / "deburr.vsix"


def table(_files: Files, sizes: Sizes) -> Iterator[Row]:
    """Keys in a large program and beside a large toolpath; one row that says why, if nothing can be measured."""
    if not sizes.judged:
        yield Row("left out of a quick run", "")
        return
    try:
        from support.vscode import installed
    except ImportError:
        yield Row("not measured: playwright is not installed", "")
        return
    if not installed() or not _VSIX.exists():
        yield Row("not measured: `.ci/vscode` and `npm run package` in `vscode-extension` come first", "")
        return
    with TemporaryDirectory() as folder:
        found = {name: _typed(Path(folder) / name, f"large.{name}") for name in ("ngc", "plain")}
        yield _compared(f"{LINES:,} lines: key to repaint, median", median(found["ngc"]), median(found["plain"]))
        yield _compared(f"{LINES:,} lines: key to repaint, slowest of {KEYS}", max(found["ngc"]), max(found["plain"]))
        yield from _drawn(Path(folder) / "toolpath")


def _compared(what: str, taken: float, other: float, most: float | None = None) -> Row:
    said = "" if most is None else f"≤ {most:g} ms"
    holds = None if most is None else taken <= most
    return Row(what, f"{taken:.0f} ms", f"{other:.0f} ms", f"{taken / other:.2f} ×", said, holds)


@contextmanager
def _opened(home: Path, file: str, text: str) -> Iterator[Workbench]:
    """A window with a program in a VS Code of its own."""
    from support.vscode import browser, code_server, workbench

    job = home / "job"
    job.mkdir(parents=True)
    (job / file).write_text(text)
    # From 10 MB on it asks before it opens a file that is not on its own machine.
    settings = {"files.associations": {"*.plain": "plaintext"}, "workbench.editorLargeFileConfirmation": 1024}
    with (
        code_server(home / "code", _VSIX, settings) as address,
        browser() as used,
        workbench(used, address, job, f"large-{home.name}") as opened,
    ):
        opened.open(file)
        yield opened


def _typed(home: Path, file: str) -> Sequence[float]:
    """Milliseconds from each of some keys to its repaint."""
    from support.keys import key_to_repaint

    with _opened(home, file, corpus.cam(LINES)) as opened:
        opened.page.wait_for_timeout(20_000)
        opened.focus()
        opened.go_to(LINES // 2)
        return [key_to_repaint(opened, "17"[number % 2]) for number in range(KEYS)]


def _drawn(home: Path) -> Iterator[Row]:
    """Keys in another file of the window, before a toolpath is asked for and until it is there."""
    from support.keys import key_to_repaint
    from support.plots import rows

    with _opened(home, "rows.ngc", rows(MOVES)) as opened:
        page = opened.page
        page.wait_for_timeout(20_000)
        opened.command("File: New Untitled Text File")
        page.keyboard.type("text ")
        before = [key_to_repaint(opened, "17"[number % 2]) for number in range(KEYS)]
        page.keyboard.press("Control+1")
        opened.command("View: Open Previous Editor in Group")
        started = perf_counter()
        opened.command("deburr: Show Toolpath")
        opened.focus()
        opened.command("View: Open Next Editor in Group")
        while_drawn, ready = [], 0.0
        while not ready and perf_counter() - started < 300:
            while_drawn.append(key_to_repaint(opened, "17"[len(while_drawn) % 2]))
            ready = perf_counter() - started if _moves(opened) else 0.0
        yield Row(f"{MOVES:,} moves: command to the whole toolpath", f"{ready:.1f} s")
        what = f"{MOVES:,} moves: key to repaint while they are drawn"
        yield _compared(f"{what}, median", median(while_drawn), median(before))
        yield _compared(f"{what}, slowest of {len(while_drawn)}", max(while_drawn), max(before), _FROZEN_MS)


def _moves(opened: Workbench) -> int:
    """Moves that the toolpath's view shows; 0 before it is there."""
    for frame in opened.page.frames:
        if frame.name == "active-frame" or "fake.html" in frame.url:
            said = frame.evaluate("document.getElementById('deburr')?.dataset.ready ?? ''")
            if said:
                return int(said)
    return 0


if __name__ == "__main__":
    from benchmarks.__main__ import main

    sys.exit(main(["--only", "VS Code"]))
