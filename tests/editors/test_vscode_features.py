"""What else a real VS Code shows of the packaged extension: outline, lens, hints, rename, layout, calls, scrolling in step, and the committed text."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

from playwright.sync_api import Browser, expect

from support import vscode
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


def test_the_walkthrough_leads_to_an_example_in_each_language(window: Browser, trusted: str, tmp_path: Path) -> None:
    (tmp_path / "a.ngc").write_text("M2\n")
    with workbench(window, trusted, tmp_path, "walkthrough") as opened:
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


def test_a_program_is_named_laid_out_and_its_calls_are_shown(window: Browser, trusted: str, tmp_path: Path) -> None:
    (tmp_path / "a.ngc").write_text(PROGRAM)
    with workbench(window, trusted, tmp_path, "features") as opened:
        opened.open("a.ngc")
        page = opened.page
        expect(page.locator(".codelens-decoration", has_text="Expand").first).to_be_visible()
        expect(page.locator(".statusbar-item", has_text="deburr: RS274/NGC, linuxcnc").first).to_be_visible()

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


def test_the_other_side_scrolls_along(window: Browser, trusted: str, tmp_path: Path) -> None:
    lines = [f"#1=[{number}/2]\nG1 X#1 F100\n" for number in range(200)]
    (tmp_path / "a.ngc").write_text(f"{''.join(lines)}M2\n")
    with workbench(window, trusted, tmp_path, "scrolling") as opened:
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


def test_a_template_is_given_a_toolpath(window: Browser, trusted: str, tmp_path: Path) -> None:
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
