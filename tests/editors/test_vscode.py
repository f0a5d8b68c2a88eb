"""A real VS Code with the packaged extension: what a user sees of each dialect, and what happens when something is missing or breaks."""

from __future__ import annotations

import os
import re
import signal
import subprocess
from pathlib import Path

import pytest

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

from playwright.sync_api import Browser, expect

from support import pictures, vscode
from support.editors import TASKS, Task, written
from support.room import Room
from support.vscode import Workbench, code_server, colours, workbench

expect.set_options(timeout=vscode.PATIENCE_MS)
pytestmark = pytest.mark.skipif(not vscode.installed(), reason="there is no VS Code here; .ci/vscode installs one")


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.dialect)
def test_a_program_is_read_mended_and_expanded(task: Task, room: Room) -> None:
    with room.used(task.dialect) as opened:
        written(task, opened.files)
        page = opened.page
        opened.open(task.main)
        row = int(task.error[0].partition(":")[0])
        faulty = task.files[task.main].split("\n")[row - 1]

        # Up to the fault: behind it, hints may already stand between the words.
        start = faulty[: faulty.index(task.fault) + len(task.fault)]
        assert len({name for _, name in colours(opened.line(start))}) > 1, "the line is coloured"
        expect(opened.editor().locator(".squiggly-error").first).to_be_attached()

        opened.command("Problems: Focus on Problems View")
        expect(page.locator(".markers-panel .monaco-list-row", has_text=task.error[1])).to_be_visible()

        opened.focus()
        opened.go_to(*place(task, task.fault))
        opened.quick_fix(task.action)
        # Up to the sign behind the word that was changed: further on, hints may already stand between the words.
        word = task.action.split("`")[1]
        opened.line(task.mended[: task.mended.index(word) + len(word) + 1]).wait_for()
        expect(opened.editor().locator(".squiggly-error")).to_have_count(0)

        opened.go_to(*place(task, task.hover[0], task.mended))
        hover = opened.hover()
        for word in task.hover[1]:
            expect(hover).to_contain_text(word)
        page.keyboard.press("Escape")

        if task.define:
            opened.command("deburr: Set Values for the Expansion", asks=True)
            page.locator(".quick-input-widget", has_text="As on the command line").wait_for()
            opened.answer(task.define.replace("Hand", "Side"))
        opened.command("deburr: Show Expanded Program")
        for line in task.flat:
            opened.line(line, 1).wait_for()
        assert [line for line in opened.lines(1) if line] == task.flat

        opened.focus()
        opened.go_to(*place(task, task.from_to[0], task.mended))
        wait_for_mark(opened, 1, task.from_to[1])

        opened.focus(1)
        opened.go_to(task.back[0])
        opened.command("deburr: Go to Source of This Line")
        file, _, line = task.back[1].partition(":")
        expect(page.locator(".tab.active", has_text=file).first).to_be_visible()
        expect(page.locator("#status\\.editor\\.selection")).to_have_text(re.compile(rf"Ln {line}, "))
        wait_for_mark(opened, 1, task.back[0])


def place(task: Task, text: str, mended: str = "") -> tuple[int, int]:
    """Where a text first stands in the program of a task, or in the mended one; 1-based."""
    lines = task.files[task.main].split("\n")
    if mended:
        lines[int(task.error[0].partition(":")[0]) - 1] = mended
    row = next(number for number, line in enumerate(lines) if text in line)
    return row + 1, lines[row].index(text) + 1


def marked_rows(opened: Workbench, number: int) -> list[int]:
    """The rows of an editor group that are marked as belonging to the cursor on the other side; 1-based."""
    tops = opened.editor(number).evaluate(
        """editor => {
            const marked = [...editor.querySelectorAll('.view-overlays > div')].filter(each => each.querySelector("[class*='ced-']"));
            const lines = [...editor.querySelectorAll('.view-line')].map(each => parseFloat(each.style.top)).sort((a, b) => a - b);
            return marked.map(each => lines.indexOf(parseFloat(each.style.top)) + 1);
        }"""
    )
    return [int(row) for row in tops]


def wait_for_mark(opened: Workbench, number: int, row: int) -> None:
    """Wait until a row of an editor group is marked."""
    for _ in range(200):
        if row in marked_rows(opened, number):
            return
        opened.page.wait_for_timeout(100)
    raise AssertionError(f"row {row} is not marked, but {marked_rows(opened, number)}")


def test_the_server_is_started_again_with_the_text_as_it_is(room: Room) -> None:
    with room.used("restart") as opened:
        (opened.files / "a.ngc").write_text("G21 G90\nM2\n")
        opened.open("a.ngc")
        expect(opened.page.locator(".statusbar-item", has_text="deburr: RS274/NGC").first).to_be_visible()
        opened.focus()
        # In one piece: Enter could take a suggestion that comes late.
        opened.page.keyboard.insert_text("o1 cal\n")
        opened.editor().locator(".squiggly-error").first.wait_for(state="attached")
        # That of `trusted` stands beside the tests' own folders; those of other workers are left alone.
        running = servers(opened.files.parents[1])
        assert running
        for server in running:
            os.kill(server, signal.SIGKILL)
        opened.page.wait_for_timeout(1500)
        opened.page.keyboard.insert_text("o2 cal\n")
        opened.line("o2 cal").wait_for()
        expect(opened.editor().locator(".squiggly-error")).to_have_count(2)

        (before,) = servers(opened.files.parents[1])
        for _ in range(3):
            opened.page.keyboard.press("Control+Alt+F9")
        opened.page.keyboard.insert_text("o3 cal\n")
        expect(opened.editor().locator(".squiggly-error")).to_have_count(3)
        (after,) = servers(opened.files.parents[1])
        assert after != before


def servers(folder: Path) -> list[int]:
    """The language servers that are running from an extension within a folder, on either runtime."""
    said = subprocess.run(["ps", "-ww", "-eo", "pid,args"], capture_output=True, text=True, check=True).stdout
    ours = re.compile(rf" *(\d+) .*{re.escape(str(folder))}/\S*/bundled/(?:serve\.py|pyodide\.mjs)")
    return [int(found[1]) for found in map(ours.match, said.split("\n")) if found]


def test_without_trust_there_are_colours_only_and_then_without_python_the_bundled_runtime_serves(
    vsix: Path, window: Browser, tmp_path: Path
) -> None:
    (tmp_path / "job").mkdir()
    (tmp_path / "job" / "a.ngc").write_text("#1=0\no1 repeat [2]\n  #1=[#1+5]\n  G0 X#1\no1 endrepeat\no1 cal\nM2\n")
    settings = {"security.workspace.trust.startupPrompt": "never"}
    with (
        code_server(tmp_path / "code", vsix, settings, trust=False, path=without_python(tmp_path / "bin")) as address,
        workbench(window, address, tmp_path / "job", "no-trust-no-python") as opened,
    ):
        page = opened.page
        opened.open("a.ngc")
        assert colours(opened.line("o1 cal"))
        expect(page.locator(".statusbar-item", has_text="Restricted Mode").first).to_be_visible()
        page.wait_for_timeout(3000)
        assert opened.editor().locator(".squiggly-error").count() == 0
        assert servers(tmp_path) == []

        opened.command("Workspaces: Manage Workspace Trust")
        page.locator(".workspace-trust-editor").get_by_role("button", name="Trust", exact=True).click()
        opened.open("a.ngc")
        opened.editor().locator(".squiggly-error").first.wait_for(state="attached")
        (server,) = servers(tmp_path)
        assert "pyodide" in Path(f"/proc/{server}/cmdline").read_text()

        opened.go_to(6)
        page.keyboard.press("Control+Shift+K")
        expect(opened.editor().locator(".squiggly-error")).to_have_count(0)
        opened.go_to(4, 8)
        expect(opened.hover()).to_contain_text("#1")
        page.keyboard.press("Escape")
        opened.command("deburr: Show Expanded Program")
        opened.line("G0 X10", 1).wait_for()
        assert [line.strip() for line in opened.lines(1) if line] == ["G0 X5", "G0 X10", "M2"]
        opened.command("deburr: Show Version")
        opened.command("Notifications: Show Notifications")
        expect(page.locator(".notification-list-item-message", has_text="the bundled runtime").first).to_be_visible()
        assert opened.outside == []


def without_python(folder: Path) -> str:
    """A PATH on which there is a shell, Node and no Python, which may stand beside that Node."""
    folder.mkdir()
    (folder / "node").symlink_to(vscode.NODE / "node")
    for name in ("sh", "bash", "env", "uname", "ps", "cat", "getconf", "sed", "which", "dirname"):
        found = next((each for each in (Path("/bin") / name, Path("/usr/bin") / name) if each.exists()), None)
        if found:
            (folder / name).symlink_to(found)
    return str(folder)


def test_a_broken_setting_is_said_with_a_way_out(window: Browser, trusted: str, tmp_path: Path) -> None:
    (tmp_path / ".vscode").mkdir()
    (tmp_path / ".vscode" / "settings.json").write_text('{"deburr.interpreter": ["/no/such/python"]}')
    (tmp_path / "a.ngc").write_text("o1 cal\nM2\n")
    with workbench(window, trusted, tmp_path, "broken-setting") as opened:
        opened.open("a.ngc")
        said = "`/no/such/python` in deburr.interpreter is not there"
        toast = opened.page.locator(".notification-toast", has_text=said)
        expect(toast).to_be_visible()
        (tmp_path / ".vscode" / "settings.json").write_text("{}")
        expect(toast.get_by_role("button", name="Open Settings")).to_be_visible()
        toast.get_by_role("button", name="Try Again").click()
        opened.editor().locator(".squiggly-error").first.wait_for(state="attached")


ROUND = """G21 G90 G17 F300
G0 X0 Y0 Z5
#1 = 0
o1 while [#1 LT 3]
  G0 X[#1 * 25] Y0
  G1 Z-1
  G3 X[#1 * 25] Y20 J10
  G0 Z5
  #1 = [#1 + 1]
o1 endwhile
M2
"""
ARCS = [3, 7, 11]
"""Moves that line 7 makes: behind the first rapid each pass makes four, the third of them is the arc."""


def test_the_toolpath_is_drawn_and_moves_and_lines_find_each_other(window: Browser, room: Room) -> None:
    with room.used("toolpath") as opened:
        (opened.files / "round.ngc").write_text(ROUND)
        page = opened.page
        opened.open("round.ngc")
        opened.command("deburr: Show Toolpath")
        view = page.frame_locator("iframe.webview").frame_locator("#active-frame")
        view.locator("#deburr[data-ready='13']").wait_for()
        canvas = view.locator("#stage canvas")
        whole = pictures.colours(window, canvas.screenshot())
        assert pictures.drawn(whole) > 500, "the view is not blank"
        expect(view.locator("#facts .bounds").first).to_have_text("all moves: X 0 to 60, Y 0 to 20, Z -1 to 5 mm")

        frame = next(each for each in page.frames if each.locator("#deburr").count())
        canvas.click(position=frame.evaluate(f"deburr.middleOf({ARCS[1]})"))
        expect(view.locator("#selected .frame")).to_have_text("pass 2 of the loop in round.ngc:4")
        expect(page.locator(".statusbar-item", has_text="Ln 7, Col 1")).to_be_visible()

        opened.go_to(6)
        expect(view.locator("#selected")).to_have_text("round.ngc:6: 3 moves")
        opened.go_to(7)
        expect(view.locator("#selected")).to_have_text("round.ngc:7: 3 moves")
        assert frame.evaluate("deburr.lit") == ARCS
        page.wait_for_timeout(300)
        assert pictures.red(pictures.colours(window, canvas.screenshot())) > 50

        opened.go_to(4, 17)
        page.keyboard.type("1")
        view.locator("#deburr[data-ready='53']").wait_for()
