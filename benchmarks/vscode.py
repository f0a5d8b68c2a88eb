"""`python -m benchmarks.vscode`: from a key to its repaint in a real VS Code with a large program, beside the same text as plain text."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from benchmarks import corpus
from support.vscode import Workbench, browser, code_server, installed

LINES = 300_000
KEYS = 30
_WAIT_FOR_PAINT = """() => {
    window.painted = new Promise(resolve => {
        const lines = document.querySelector('.editor-instance .view-lines');
        const started = { at: 0 };
        document.addEventListener('keydown', () => { started.at = performance.now(); }, { capture: true, once: true });
        const seen = new MutationObserver(() => {
            if (!started.at) return;
            seen.disconnect();
            requestAnimationFrame(() => resolve(performance.now() - started.at));
        });
        seen.observe(lines, { childList: true, subtree: true, characterData: true });
    });
}"""


def main() -> int:
    """Measure and print; 1 if there is nothing to measure with."""
    vsix = Path(__file__).parents[1] / "vscode-extension" / "deburr.vsix"
    if not installed() or not vsix.exists():
        print(
            "a VS Code (.ci/vscode) and the package (npm run package in vscode-extension) are needed", file=sys.stderr
        )
        return 1
    with TemporaryDirectory() as folder:
        found = {name: _typed(Path(folder) / name, vsix, f"large.{name}") for name in ("ngc", "plain")}
    for name, times in found.items():
        print(f"{LINES:,} lines, .{name}: key to repaint {median(times):.1f} ms, slowest {max(times):.1f} ms")
    return 0


def _typed(home: Path, vsix: Path, file: str) -> Sequence[float]:
    """Milliseconds from each of some keys to its repaint."""
    job = home / "job"
    job.mkdir(parents=True)
    (job / file).write_text(corpus.cam(LINES))
    with (
        code_server(home / "code", vsix, {"files.associations": {"*.plain": "plaintext"}}) as address,
        browser() as used,
    ):
        opened = Workbench(used.new_page(viewport={"width": 1400, "height": 850}), address, job)
        opened.open(file)
        opened.page.wait_for_timeout(20_000)
        opened.focus()
        opened.go_to(LINES // 2)
        return [_key(opened, "17"[number % 2]) for number in range(KEYS)]


def _key(opened: Workbench, key: str) -> float:
    opened.page.evaluate(_WAIT_FOR_PAINT)
    opened.page.keyboard.press(key)
    return float(opened.page.evaluate("() => window.painted"))


if __name__ == "__main__":
    sys.exit(main())
