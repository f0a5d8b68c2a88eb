"""`python -m benchmarks.plot [MOVES]`: a program of a million moves as a picture and as a page in a real browser, drawn by the processor."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from playwright.sync_api import Browser, Page

from support import vscode
from support.plots import rows
from support.vscode import browser

MOVES = 1_000_000
LOADED, ANSWERED = 10.0, 2.0
"""Seconds that are allowed, from the address to the picture and from a click to its answer."""
CLICKS = 5


def main(moves: int) -> int:
    """Measure and print; 1 if the page is slower than is allowed, or there is no browser."""
    if not Path(vscode.CHROMIUM).exists():
        print("a Chromium is needed", file=sys.stderr)
        return 1
    with TemporaryDirectory() as folder:
        program = Path(folder) / "rows.ngc"
        program.write_text(rows(moves))
        for end in ("svg", "html"):
            seconds, said = _made(program, program.with_suffix(f".{end}"))
            size = program.with_suffix(f".{end}").stat().st_size / 1e6
            print(f"{moves:,} moves, .{end}: {seconds:.1f} s, {size:.1f} MB{said}")
        with browser() as window:
            loaded, answered = _opened(window, program.with_suffix(".html"))
    return int(loaded > LOADED or answered > ANSWERED)


def _made(program: Path, out: Path) -> tuple[float, str]:
    """Seconds that the command line takes, and what it says."""
    started = perf_counter()
    command = [
        sys.executable,
        "-m",
        "deburr",
        "plot",
        "-q",
        program,
        "-o",
        out,
        "--max-steps",
        "0",
        "--max-blocks",
        "0",
    ]
    ran = subprocess.run(command, check=True, capture_output=True, text=True)
    return perf_counter() - started, f"; {ran.stderr.strip()}" if ran.stderr else ""


def _opened(window: Browser, file: Path) -> tuple[float, float]:
    """Seconds until the page is there, and until it has answered the slowest of some clicks."""
    page = window.new_page(viewport={"width": 1280, "height": 800})
    started = perf_counter()
    page.goto(file.as_uri())
    page.locator("#deburr[data-ready]").wait_for(timeout=120_000)
    loaded = perf_counter() - started
    print(f"page: loaded in {loaded:.1f} s (allowed {LOADED:.0f}); {page.locator('#facts .note').first.inner_text()}")
    moves = int(page.evaluate("deburr.path.count"))
    clicks = [_click(page, (2 * number + 1) * moves // (2 * CLICKS)) for number in range(CLICKS)]
    print(f"page: a click is answered in {min(clicks):.2f} to {max(clicks):.2f} s (allowed {ANSWERED:.0f})")
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")
    metrics = {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}
    arrays = session.send("Runtime.getHeapUsage").get("backingStorageSize", 0)
    print(f"page: {metrics['JSHeapUsedSize'] / 1e6:.0f} MB of objects, {arrays / 1e6:.0f} MB of arrays")
    return loaded, max(clicks)


def _click(page: Page, move: int) -> float:
    """Seconds from a click to what is told of a move, drawn."""
    place = page.evaluate(f"deburr.middleOf({move})")
    canvas = page.locator("#stage canvas")
    page.evaluate("document.getElementById('selected').replaceChildren()")
    started = perf_counter()
    canvas.click(position=place)
    page.locator("#selected .source").wait_for(timeout=60_000)
    page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return perf_counter() - started


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else MOVES))
