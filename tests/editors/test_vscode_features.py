"""What else a real VS Code shows of the packaged extension: outline, lens, hints, rename, layout, calls, scrolling in step, and the committed text."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence
from pathlib import Path
from statistics import median

import pytest

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

from benchmarks import corpus
from playwright.sync_api import Browser, expect

from support import vscode
from support.keys import key_to_repaint
from support.room import Room
from support.vscode import Workbench, workbench

expect.set_options(timeout=vscode.PATIENCE_MS)
pytestmark = pytest.mark.skipif(not vscode.installed(), reason="there is no VS Code here; .ci/vscode installs one")

PROGRAM = "o<hole> sub\nG1 Z[0-#1] F100\no<hole> endsub\nG21 G90 G17\n#<deep> = 2\no1 repeat [3]\nG0 X1\no<hole> call [#<deep>]\no1 endrepeat\nM2\n"
EXAMPLES = {
    "RS274": ("cal [", (13, 11), ("hole", "repeat 100")),
    "MetaGCODE": ("#ENDLOPP1", (8, 1), ("#LOOP 1",)),
    "SmartCAM": ("SQRR", (7, 13), ("DECLARE", "#deep", "LINE", "END")),
    "Z32": ("ABSS", (8, 18), ("N10",)),
}
"""What to type for a language, where its example is wrong, and what its outline names once that is mended."""


def test_the_walkthrough_leads_to_an_example_in_each_language(room: Room) -> None:
    with room.used("walkthrough") as opened:
        (opened.files / "a.ngc").write_text("M2\n")
        opened.open("a.ngc")
        opened.command("Welcome: Open Walkthrough", asks=True)
        opened.answer("Get started with deburr")
        step = opened.page.locator(".getting-started-step", has_text="See a fault and mend it").first
        expect(step).to_be_visible()
        opened.command("Explorer: Focus on Outline View")
        for language, (wrong, place, names) in EXAMPLES.items():
            opened.command("deburr: Open an Example", asks=True)
            opened.answer(language)
            opened.line(wrong).wait_for()
            expect(opened.editor().locator(".squiggly-error")).to_have_count(1)
            opened.go_to(*place)
            opened.quick_fix("Change to")
            expect(opened.editor().locator(".squiggly-error")).to_have_count(0)
            for name in names:
                expect(opened.page.locator(".outline-pane .monaco-list-row", has_text=name).first).to_be_visible()


def test_a_program_is_named_laid_out_and_its_calls_are_shown(room: Room) -> None:
    with room.used("features") as opened:
        (opened.files / "a.ngc").write_text(PROGRAM)
        opened.open("a.ngc")
        page = opened.page
        expect(page.locator(".codelens-decoration", has_text="Expand").first).to_be_visible()
        expect(page.locator(".statusbar-item", has_text="deburr: RS274/NGC, linuxcnc").first).to_be_visible()
        page.locator(".codelens-decoration a", has_text="1 reference").click()
        expect(page.locator(".reference-zone-widget .monaco-list-row", has_text="call").first).to_be_visible()
        page.keyboard.press("Escape")

        opened.focus()
        opened.go_to(8, 4)
        expect(page.locator(".breadcrumbs-control", has_text="repeat 1").first).to_be_visible()
        opened.command("Peek Call Hierarchy")
        expect(page.locator(".call-hierarchy .monaco-list-row", has_text="hole").first).to_be_visible()
        page.keyboard.press("Escape")

        opened.focus()
        opened.go_to(5, 4)
        opened.command("Rename Symbol", asks=True)
        box = page.locator(".rename-box input")
        box.fill("depth")
        box.press("Enter")
        opened.line("#<depth> = 2").wait_for()
        # With what the name holds there, as a hint.
        opened.line("o<hole> call [#<depth>=2]").wait_for()

        opened.command("Format Document")
        # A hint may already stand behind the parameter.
        opened.line("    G1 Z[0-#1").wait_for()
        expect(page.locator(".squiggly-error")).to_have_count(0)


LIVE = "o<hole> sub\nG1 Z[0-#1] F100\no<hole> endsub\nG21 G90 G17\n#<deep> = 0\no1 repeat [3]\n#<deep> = [#<deep> + 1]\no<hole> call [#<deep>]\no1 endrepeat\nM2\n"


def flat(passes: int) -> list[str]:
    """What `LIVE` comes to: a hole in each pass, each one deeper."""
    return ["G21 G90 G17", *(f"G1 Z-{number} F100" for number in range(1, passes + 1)), "M2"]


def wait_for_flat(opened: Workbench, expected: Sequence[str]) -> None:
    """Wait until the second editor group shows these lines and no more."""
    for _ in range(200):
        if [line for line in opened.lines(1) if line] == expected:
            return
        opened.page.wait_for_timeout(100)
    raise AssertionError(opened.lines(1))


def test_the_preview_follows_typing_and_tells_where_its_lines_come_from(room: Room) -> None:
    with room.used("preview") as opened:
        (opened.files / "a.ngc").write_text(LIVE)
        page = opened.page
        opened.open("a.ngc")
        opened.command("deburr: Show Expanded Program")
        wait_for_flat(opened, flat(3))

        opened.focus()
        opened.go_to(6, 13)
        banner = opened.editor(1).locator(".codelens-decoration", has_text="last good expansion")
        page.keyboard.press("Backspace")
        expect(banner).to_be_visible()
        assert [line for line in opened.lines(1) if line] == flat(3)
        page.keyboard.type("4")
        wait_for_flat(opened, flat(4))
        expect(banner).to_have_count(0)

        opened.focus(1)
        opened.go_to(3)
        hover = opened.hover()
        for words in ("from a.ngc:2", "call at a.ngc:8", "pass 2 of the loop at a.ngc:6"):
            expect(hover).to_contain_text(words)
        page.keyboard.press("Escape")

        opened.focus()
        opened.go_to(2)
        opened.command("deburr: Show All Expansions of This Line", asks=True)
        rows = page.locator(".quick-input-list .monaco-list-row", has_text="pass")
        expect(rows).to_have_count(4)
        rows.filter(has_text="G1 Z-3 F100").click()
        expect(page.locator("#status\\.editor\\.selection")).to_have_text("Ln 4, Col 1")

        opened.focus()
        opened.command("deburr: Compare Expansion with Saved File")
        compared = page.locator(".monaco-diff-editor")
        expect(compared.locator(".editor.modified .line-insert")).to_have_count(1)
        expect(compared.locator(".editor.modified")).to_contain_text("Z-4")
        expect(page.locator(".tab.active", has_text="expansion of the saved file")).to_be_visible()


def test_the_other_side_scrolls_along(room: Room) -> None:
    lines = [f"#1=[{number}/2]\nG1 X#1 F100\n" for number in range(200)]
    with room.used("scrolling") as opened:
        (opened.files / "a.ngc").write_text(f"{''.join(lines)}M2\n")
        opened.open("a.ngc")
        opened.command("deburr: Show Expanded Program")
        opened.line("G1 X0 F100", 1).wait_for()
        scrolled(opened, 0, 4000)
        shown = first_number(opened, 0)
        opened.line(f"G1 X{shown / 2:g} F100", 1).wait_for()
        opened.focus(1)
        opened.go_to(1)
        scrolled(opened, 1, 2000)
        opened.line(f"#1=[{2 * first_number(opened, 1):g}/2]").wait_for()


def scrolled(opened: Workbench, number: int, pixels: int) -> None:
    """Turn the wheel over the n-th editor group, which has the focus."""
    opened.focus(number)
    opened.editor(number).hover()
    opened.page.mouse.wheel(0, pixels)
    opened.page.wait_for_timeout(500)


def first_number(opened: Workbench, number: int) -> float:
    """The value in the first whole line that a group shows."""
    line = next(line for line in opened.lines(number)[1:] if "X#" not in line)
    return float(line.partition("X")[2].split()[0] if "X" in line else line.partition("[")[2].partition("/")[0])


def test_the_expansion_is_compared_with_the_committed_one(window: Browser, trusted: str, tmp_path: Path) -> None:
    job = tmp_path / "job"
    (job / ".vscode").mkdir(parents=True)
    # Elsewhere it is off, so that nothing looks through the folders of the tests.
    (job / ".vscode" / "settings.json").write_text('{"git.enabled": true}')
    (job / "a.ngc").write_text(PROGRAM)
    for arguments in (
        ["init", "-q"],
        ["add", "."],
        ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "first"],
    ):
        subprocess.run(["git", *arguments], cwd=job, check=True, timeout=60)
    (job / "a.ngc").write_text(PROGRAM.replace("= 2", "= 3"))
    with workbench(window, trusted, job, "committed") as opened:
        opened.open("a.ngc")
        expect(opened.page.locator(".statusbar-item", has_text="deburr: RS274/NGC").first).to_be_visible()
        expect(opened.page.locator("[id='status.scm.0'], .statusbar-item", has_text="master").first).to_be_visible()
        opened.command("deburr: Compare Expansion with Saved File", asks=True)
        opened.answer("committed file")
        sides = opened.page.locator(".diff-editor .monaco-editor, .monaco-diff-editor .editor")
        expect(sides.first).to_contain_text("Z-2")
        expect(opened.page.locator(".monaco-diff-editor .editor.modified")).to_contain_text("Z-3")


def test_a_template_is_given_a_toolpath_which_is_remembered(window: Browser, trusted: str, tmp_path: Path) -> None:
    (tmp_path / "post.cgt").write_text("@LINE\nG1 X#XPOS\n@\n@END\nM30\n@\n")
    (tmp_path / "part.cl").write_text("GOTO/1,2,3\nFINI\n")
    with workbench(window, trusted, tmp_path, "toolpath-file") as opened:
        opened.open("post.cgt")
        expect(opened.page.locator(".statusbar-item", has_text="deburr: SmartCAM").first).to_be_visible()
        opened.command("deburr: Set Values for the Expansion", asks=True)
        opened.page.locator(".quick-input-list .monaco-list-row", has_text="Toolpath file").first.click()
        opened.page.locator(".quick-input-title", has_text="toolpath that the template is given").wait_for()
        opened.page.locator(".quick-input-list .monaco-list-row", has_text="part.cl").first.click()
        opened.page.locator(".quick-input-widget").first.wait_for(state="hidden")
        opened.command("deburr: Show Expanded Program")
        opened.line("G1 X1.0", 1).wait_for()
        assert [line for line in opened.lines(1) if line] == ["G1 X1.0", "M30"]

        opened.page.reload()
        opened.editor().locator(".view-line").first.wait_for()
        opened.focus()
        opened.command("deburr: Set Values for the Expansion", asks=True)
        expect(opened.page.locator(".quick-input-list .monaco-list-row", has_text="part.cl")).to_be_visible()


LINES = 300_000


def test_typing_in_a_large_program_stays_near_that_in_plain_text(window: Browser, trusted: str, tmp_path: Path) -> None:
    # From 10 MB on it asks before it opens a file that is not on its own machine.
    settings = {"files.associations": {"*.plain": "plaintext"}, "workbench.editorLargeFileConfirmation": 1024}
    (tmp_path / ".vscode").mkdir()
    (tmp_path / ".vscode" / "settings.json").write_text(json.dumps(settings))
    text = corpus.cam(LINES)
    taken = {}
    with workbench(window, trusted, tmp_path, "large") as opened:
        for file in ("large.plain", "large.ngc"):
            (tmp_path / file).write_text(text)
            opened.open(file)
            opened.focus()
            opened.go_to(LINES // 2)
            if file == "large.ngc":
                # So long as the file is still being read through, a key may wait for it as well.
                opened.page.keyboard.insert_text("o1 cal\n")
                opened.editor().locator(".squiggly-error").first.wait_for(state="attached")
            taken[file] = median(key_to_repaint(opened, "17"[number % 2]) for number in range(15))
            opened.close_all()
    print(f"{LINES:,} lines, key to repaint: {taken['large.ngc']:.0f} ms; as plain text: {taken['large.plain']:.0f} ms")
    # They are alike when the machine is quiet.
    assert taken["large.ngc"] < 5 * taken["large.plain"]
