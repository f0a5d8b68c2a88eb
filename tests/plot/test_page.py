"""The page of `deburr plot` in a real browser: it is drawn, the slider runs, and moves and source lines find each other."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

from playwright.sync_api import Browser, Page, expect

from deburr.cli.main import main
from support import vscode
from support.pictures import colours, drawn, red
from support.plots import rows
from support.vscode import browser

pytestmark = pytest.mark.skipif(not Path(vscode.CHROMIUM).exists(), reason="there is no Chromium here")

MAIN = """G21 G90 G17 F300
T2 M6
G0 X0 Y0 Z5
#1 = 0
o1 while [#1 LT 3]
  o<slot> call [#1 * 25]
  #1 = [#1 + 1]
o1 endwhile
G0 X0 Y40 Z8
G1 X60
M2
"""
SLOT = """o<slot> sub
G0 X#1 Y0
G1 Z-1
G3 X#1 Y20 J10
G0 Z5
o<slot> endsub
"""
ARC, PLUNGE, LAST = 3, 2, 14
"""Moves: the first is the rapid in line 3, each pass makes four in `slot.ngc`, the last cut is line 10."""


@pytest.fixture(scope="module")
def window() -> Iterator[Browser]:
    with browser() as found:
        yield found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("page")
    (found / "main.ngc").write_text(MAIN)
    (found / "slot.ngc").write_text(SLOT)
    (found / "rows.ngc").write_text(rows(50_000))
    for name in ("main", "rows"):
        assert main(["plot", "-q", str(found / f"{name}.ngc"), "-o", str(found / f"{name}.html")]) == 0
    return found


@contextmanager
def shown(window: Browser, file: Path, name: str, script: str = "") -> Iterator[Page]:
    """A page that has drawn; it asked for nothing but itself. How it looked at the end is kept where `DEBURR_PICTURES` says."""
    page = window.new_page(viewport={"width": 1200, "height": 800})
    asked: list[str] = []
    wrong: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.add_init_script(script)
    try:
        page.goto(file.as_uri())
        page.locator("#deburr[data-ready]").wait_for(timeout=60_000)
        yield page
    finally:
        if kept := os.environ.get("DEBURR_PICTURES"):
            page.screenshot(path=f"{kept}/plot-{name}.png")
        page.close()
    assert (asked, wrong) == ([file.as_uri()], [])


def click(page: Page, move: int) -> None:
    """Click in the middle of a move."""
    place = page.evaluate(f"deburr.middleOf({move})")
    page.locator("#stage canvas").click(position=place)


def run_to(page: Page, moves: int) -> None:
    """Drag the slider."""
    page.locator("#slider").evaluate(
        f"slider => {{ slider.value = {moves}; slider.dispatchEvent(new Event('input')); }}"
    )


def until(page: Page, script: str) -> None:
    """Wait for something to be so. The page itself may not evaluate texts."""
    for _ in range(600):
        if page.evaluate(script):
            return
        page.wait_for_timeout(50)
    raise AssertionError(script)


def picture(window: Browser, page: Page) -> bytes:
    page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return page.locator("#stage canvas").screenshot()


def test_it_is_drawn_and_the_slider_runs_along_the_program(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "slider") as page:
        whole = colours(window, picture(window, page))
        assert len(whole) > 10
        assert drawn(whole) > 2_000
        expect(page.locator("#position")).to_have_text("15 of 15 moves")
        run_to(page, 5)
        expect(page.locator("#position")).to_have_text("5 of 15 moves")
        assert drawn(colours(window, picture(window, page))) < drawn(whole)


def test_a_click_on_a_move_tells_its_lines_and_all_calls_and_passes(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "click") as page:
        # The arc of the second pass; the listing goes to the line of the subprogram.
        click(page, ARC + 4)
        told = page.locator("#selected")
        expect(told.locator(".source")).to_have_text("slot.ngc:4: G3 X#1 Y20 J10")
        expect(told.locator(".flat")).to_contain_text("G3 X25 Y20 J10")
        expect(told.locator(".frame")).to_have_text(["call in main.ngc:6", "pass 2 of the loop in main.ngc:5"])
        expect(told.locator(".end")).to_have_text("arc to X25 Y20 Z-1, tool 2")
        expect(page.locator("#tabs .open")).to_have_text("slot.ngc")
        expect(page.locator("#listing .marked")).to_contain_text("G3 X#1 Y20 J10")
        assert page.evaluate("deburr.lit") == [ARC + 4]
        click(page, LAST)
        expect(told.locator(".source")).to_have_text("main.ngc:10: G1 X60")
        expect(page.locator("#listing .marked")).to_contain_text("G1 X60")


def test_a_click_on_a_source_line_lights_all_that_it_made(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "light") as page:
        assert red(colours(window, picture(window, page))) == 0
        page.locator("#tabs button", has_text="slot.ngc").click()
        page.locator("#listing .row", has_text="G3 X#1").click()
        assert page.evaluate("deburr.lit") == [ARC, ARC + 4, ARC + 8]
        expect(page.locator("#selected")).to_have_text("slot.ngc:4: 3 moves")
        assert red(colours(window, picture(window, page))) > 100
        page.locator("#listing .row", has_text="endsub").click()
        expect(page.locator("#selected")).to_have_text("slot.ngc:6: 0 moves")
        assert red(colours(window, picture(window, page))) == 0


def test_the_pointer_over_a_move_tells_of_it(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "hover") as page:
        place = page.evaluate(f"deburr.middleOf({LAST})")
        page.locator("#stage canvas").hover(position=place)
        expect(page.locator("#hover .source")).to_have_text("main.ngc:10: G1 X60")
        page.locator("#listing").hover()
        expect(page.locator("#hover")).to_be_empty()


def test_what_is_not_shown_is_not_found(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "switches") as page:
        before = drawn(colours(window, picture(window, page)))
        page.locator("#cuts").uncheck()
        assert drawn(colours(window, picture(window, page))) < before
        click(page, LAST)
        expect(page.locator("#selected")).to_be_empty()
        page.locator("#cuts").check()
        click(page, LAST)
        expect(page.locator("#selected .source")).to_have_text("main.ngc:10: G1 X60")


@pytest.mark.parametrize("view", ["top", "front", "side", "iso"])
def test_from_each_side_a_move_is_where_it_is_seen(window: Browser, folder: Path, view: str) -> None:
    with shown(window, folder / "main.html", f"view-{view}") as page:
        page.locator("#look-front" if view == "iso" else "#look-iso").click()
        page.locator(f"#look-{view}").click()
        # From the right side this line is a point, and the last plunge is hidden behind none.
        move = PLUNGE + 8 if view == "side" else LAST
        expected = "slot.ngc:3: G1 Z-1" if view == "side" else "main.ngc:10: G1 X60"
        click(page, move)
        expect(page.locator("#selected .source")).to_have_text(expected)
        assert red(colours(window, picture(window, page))) > 10


def test_turning_and_zooming_keep_the_pointer_true(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "turned") as page:
        before = page.evaluate(f"deburr.middleOf({LAST})")
        box = page.locator("#stage canvas").bounding_box()
        assert box is not None
        page.mouse.move(box["x"] + 300, box["y"] + 200)
        page.mouse.down()
        page.mouse.move(box["x"] + 340, box["y"] + 230, steps=4)
        page.mouse.up()
        page.mouse.wheel(0, -120)
        until(page, f"Math.abs(deburr.middleOf({LAST}).x - {before['x']}) > 5")
        expect(page.locator("#selected")).to_be_empty()
        click(page, LAST)
        expect(page.locator("#selected .source")).to_have_text("main.ngc:10: G1 X60")


def test_bounds_and_notes_are_said(window: Browser, folder: Path) -> None:
    with shown(window, folder / "main.html", "facts") as page:
        # The arcs swing out by their radius of 10 to the right of X 50, the last slot; the last cut goes to X 60.
        expect(page.locator("#facts .bounds")).to_have_text(
            ["all moves: X 0 to 60, Y 0 to 40, Z -1 to 8 mm", "cuts: X 0 to 60, Y 0 to 40, Z -1 to 8 mm"]
        )
        expect(page.locator("#facts")).to_contain_text("arcs are drawn in chords that leave them by at most")
        expect(page.locator("#legend .entry")).to_have_text(["tool 2"])


def test_fifty_thousand_moves_find_their_lines(window: Browser, folder: Path) -> None:
    with shown(window, folder / "rows.html", "rows") as page:
        page.locator("#look-top").click()
        # Rows are less than two pixels apart: a person would look closer, too.
        page.locator("#stage canvas").hover(position=page.evaluate("deburr.middleOf(31234)"))
        for _ in range(16):
            page.mouse.wheel(0, -240)
        until(page, "Math.abs(deburr.middleOf(31234).x - deburr.middleOf(31235).x) > 5")
        click(page, 31_234)
        # Two lines stand above the moves, and lines count from 1.
        expect(page.locator("#selected .source")).to_contain_text("rows.ngc:31237: G1 ")
        expect(page.locator("#listing .marked span")).to_have_text("31237")
        run_to(page, 10_000)
        expect(page.locator("#position")).to_have_text("10,000 of 50,000 moves")
        expect(page.locator("#facts")).not_to_contain_text("segments are drawn")


def test_without_webgl_it_says_so_and_shows_the_sources(window: Browser, folder: Path) -> None:
    script = "HTMLCanvasElement.prototype.getContext = () => null;"
    with shown(window, folder / "main.html", "no-webgl", script) as page:
        expect(page.locator("#broken")).to_contain_text("needs WebGL")
        expect(page.locator("#broken")).to_contain_text("deburr plot FILE -o plot.svg")
        expect(page.locator("#listing .row").first).to_contain_text("G21 G90")
