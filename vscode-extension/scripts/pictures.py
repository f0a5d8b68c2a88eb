"""Makes the README's pictures, in a real VS Code with the packaged extension: `.venv/bin/python vscode-extension/scripts/pictures.py`.

`.ci/vscode` and `npm run package` come first.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

EXTENSION = Path(__file__).parents[1]
ROOT = EXTENSION.parent
sys.path.insert(0, str(ROOT / "tests"))

from support.vscode import Workbench, browser, code_server  # noqa: E402

SIZE = {"width": 1280, "height": 720}
SETTINGS = {"editor.minimap.enabled": False, "remote.autoForwardPorts": False}


def problems(opened: Workbench) -> None:
    """A program that is meant to be wrong, with all that is said of it."""
    opened.open("scrap.ngc")
    opened.editor().locator(".squiggly-error").first.wait_for(state="attached")
    opened.command("Problems: Focus on Problems View")
    opened.page.locator(".markers-panel .monaco-list-row", has_text="o100").first.wait_for()


def preview(opened: Workbench) -> None:
    """A subprogram with the cursor on a cut, and the flat program beside it."""
    opened.open("peck_drill.ngc")
    opened.command("View: Toggle Primary Side Bar Visibility")
    opened.command("deburr: Show Expanded Program")
    opened.line("G1 Z-3 F120", 1).wait_for()
    opened.focus()
    opened.go_to(26, 5)
    opened.editor(1).locator("[class*='ced-']").first.wait_for(state="attached")


def toolpath(opened: Workbench) -> None:
    """A program and where its tool goes, with the moves of one line lit."""
    opened.open("facing.ngc")
    opened.command("View: Toggle Primary Side Bar Visibility")
    opened.command("deburr: Show Toolpath")
    view = opened.page.frame_locator("iframe.webview").frame_locator("#active-frame")
    view.locator("#deburr[data-ready]").wait_for()
    opened.focus()
    opened.go_to(25)
    view.locator("#selected", has_text="facing.ngc:25").wait_for()


PICTURES: dict[str, Callable[[Workbench], None]] = {"problems": problems, "preview": preview, "toolpath": toolpath}


def main() -> None:
    """Make them all."""
    with TemporaryDirectory() as home:
        parts = Path(home) / "parts"
        shutil.copytree(ROOT / "examples" / "rs274", parts)
        with code_server(Path(home) / "code", EXTENSION / "deburr.vsix", SETTINGS) as address, browser() as used:
            for name, shown in PICTURES.items():
                page = used.new_page(viewport=SIZE)
                opened = Workbench(page, address, parts)
                shown(opened)
                page.locator(".statusbar-item", has_text="deburr: RS274").first.wait_for()
                page.mouse.move(400, 712)
                page.wait_for_timeout(3000)
                page.screenshot(path=EXTENSION / "pictures" / f"{name}.png")
                page.close()


if __name__ == "__main__":
    main()
