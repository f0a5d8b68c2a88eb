"""How long a key takes in a real VS Code: from its press to the repaint that shows it."""

from __future__ import annotations

from support.vscode import Workbench

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


def key_to_repaint(opened: Workbench, key: str) -> float:
    """Milliseconds from a key to its repaint in the first editor group."""
    opened.page.evaluate(_WAIT_FOR_PAINT)
    opened.page.keyboard.press(key)
    return float(opened.page.evaluate("() => window.painted"))
