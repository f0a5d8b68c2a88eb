"""A real VS Code without a screen: code-server's workbench in Debian's Chromium, driven as a user would. Knows nothing of deburr's languages."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
import time
import urllib.request
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from playwright.sync_api import Browser, Locator, Page, expect, sync_playwright
from playwright.sync_api import TimeoutError as PlaywrightTimeout

HOME = Path(os.environ.get("DEBURR_EDITORS", Path.home() / ".cache" / "deburr-editors"))
NODE = Path(os.environ.get("DEBURR_CODE_NODE", HOME / "node24" / "bin"))
CODE = HOME / os.environ.get("DEBURR_CODE", "code-server") / "node_modules" / "code-server"
"""Another release than the newest is named by its folder; `.ci/vscode VERSION` makes it."""
CHROMIUM = os.environ.get("CHROMIUM", "/usr/bin/chromium")

QUIET = {
    "telemetry.telemetryLevel": "off",
    # Extensions that would run inside the page: there are none.
    "extensions.webWorker": False,
    "update.mode": "none",
    "extensions.autoUpdate": False,
    "extensions.autoCheckUpdates": False,
    "extensions.ignoreRecommendations": True,
    "workbench.startupEditor": "none",
    "workbench.tips.enabled": False,
    "workbench.enableExperiments": False,
    "workbench.secondarySideBar.defaultVisibility": "hidden",
    "chat.disableAIFeatures": True,
    "git.enabled": False,
    "typescript.disableAutomaticTypeAcquisition": True,
    "editor.hover.delay": 100,
    "files.autoSave": "off",
    "window.restoreWindows": "none",
}
_BROWSER = (
    "--no-sandbox",
    "--disable-gpu",
    # Pictures in three dimensions are drawn by the processor.
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
)
PATIENCE_MS = 60_000
RESTART = "ctrl+alt+f9"
"""The keys that start the language server again: from the palette nobody does it twice at once."""


def installed() -> bool:
    """Whether there is a VS Code and a browser to show it."""
    return CODE.is_dir() and Path(CHROMIUM).exists()


@contextlib.contextmanager
def code_server(
    home: Path, vsix: Path, settings: Mapping[str, Any] = {}, *, trust: bool = True, path: str = ""
) -> Iterator[str]:
    """The address of a running workbench in which an extension is installed.

    ``trust``: all folders are trusted without a question. ``path``: the PATH of its extensions, if not that of the tests.
    """
    for place in ("User", "Machine"):
        (home / "user" / place).mkdir(parents=True, exist_ok=True)
        (home / "user" / place / "settings.json").write_text(json.dumps({**QUIET, **settings}))
    (home / "user" / "User" / "keybindings.json").write_text(
        json.dumps([{"key": RESTART, "command": "deburr.restart"}])
    )
    (home / "config.yaml").write_text("auth: none\ncert: false\n")
    base = [str(NODE / "node"), str(CODE), "--config", str(home / "config.yaml")]
    base += ["--user-data-dir", str(home / "user"), "--extensions-dir", str(home / "extensions")]
    env = {name: value for name, value in os.environ.items() if not name.startswith("VSCODE_")}
    # The gallery is off: nothing is looked up outside of this machine.
    env |= {"PATH": path or f"{NODE}:{env['PATH']}", "EXTENSIONS_GALLERY": json.dumps({"serviceUrl": ""})}
    if path:
        # Otherwise the PATH of a login shell would be taken; this one says nothing.
        env["SHELL"] = "/bin/true"
    _install(vsix, home / "extensions", base, env)
    port = _free_port()
    flags = ["--bind-addr", f"127.0.0.1:{port}", "--auth", "none", "--disable-telemetry", "--disable-update-check"]
    flags += ["--disable-proxy", "--disable-getting-started-override", "--ignore-last-opened"]
    flags += ["--disable-workspace-trust"] if trust else []
    with (home / "server.log").open("wb") as log:
        server = subprocess.Popen([*base, *flags], env=env, stdout=log, stderr=log, start_new_session=True)
    try:
        _wait_for(f"http://127.0.0.1:{port}/healthz", server, home / "server.log")
        yield f"http://127.0.0.1:{port}"
    finally:
        _stop_group(server)


_installed: dict[Path, Path] = {}
"""Where a package was installed first."""


def _install(vsix: Path, place: Path, base: Sequence[str], env: Mapping[str, str]) -> None:
    """As a user does; later ones get what that left, which takes a tenth of the time."""
    first = _installed.setdefault(vsix, place)
    if first == place or not first.exists():
        subprocess.run([*base, "--install-extension", str(vsix), "--force"], env=env, check=True, capture_output=True)
        return
    shutil.copytree(first, place)
    listed = place / "extensions.json"
    listed.write_text(listed.read_text().replace(str(first), str(place)))


@contextlib.contextmanager
def browser() -> Iterator[Browser]:
    """A browser without a screen."""
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=CHROMIUM, args=_BROWSER)
        yield found
        found.close()


class Workbench:
    """One window of VS Code."""

    def __init__(self, page: Page, address: str, folder: Path) -> None:
        self.page = page
        self.outside: list[str] = []
        """Requests that would leave this machine."""
        self.files = folder
        """Where the files are that a test opens: the folder of the window, or one below it."""
        self._address = address
        self._folder = folder
        self._there = False
        page.set_default_timeout(PATIENCE_MS)
        page.on("request", lambda request: self._asked(request.url))

    def open(self, file: str) -> None:
        """Open a file in the editor; for the first one, the window too."""
        if self._there:
            # By its whole path: a file of that name in another folder may be what the dialog still offers.
            path = self.files / file
            self._until(
                f".tab.active [aria-label$='{path.relative_to(self._folder.parent)}']", lambda: self._named(path)
            )
        else:
            host = self._address.removeprefix("http://")
            payload = json.dumps([["openFile", f"vscode-remote://{host}{self.files}/{file}"]])
            self.page.goto(f"{self._address}/?folder={quote(str(self._folder))}&payload={quote(payload)}")
            self.page.locator(".monaco-workbench").wait_for()
        self._there = True
        self.editor().locator(".view-line").first.wait_for()

    def _named(self, path: Path) -> None:
        """Name a file to the editor's own dialog."""
        self.page.keyboard.press("Control+o")
        field = self.page.locator(".quick-input-widget input").first
        field.fill(str(path))
        field.press("Enter")

    def close_all(self) -> None:
        """Close everything, and keep nothing of it."""
        self.page.keyboard.press("Escape")
        self.command("View: Close All Editors")
        tabs, asked = self.page.locator(".tab"), self.page.get_by_role("button", name="Don't Save")
        self.page.add_locator_handler(asked, lambda button: button.click(), times=1)
        expect(tabs).to_have_count(0)

    def editor(self, number: int = 0) -> Locator:
        """The text of the n-th editor group, from the left."""
        return self.page.locator(".editor-group-container").nth(number).locator(".editor-instance .monaco-editor").first

    def line(self, text: str, number: int = 0) -> Locator:
        """The first line with a text in the n-th editor group."""
        # The workbench shows blanks as no-break spaces.
        return self.editor(number).locator(".view-line", has_text=text.replace(" ", "\u00a0")).first

    def lines(self, number: int = 0) -> list[str]:
        """The lines that the n-th editor group shows, from above."""
        found = (
            self.editor(number)
            .locator(".view-line")
            .evaluate_all("lines => lines.map(each => [parseFloat(each.style.top), each.textContent])")
        )
        return [str(text).replace("\u00a0", " ") for _, text in sorted(found)]

    def command(self, title: str, *, asks: bool = False) -> None:
        """Run a command of the palette; ``asks``: it goes on with a question there. The row is clicked: Enter could still take one of the list before."""
        self._until(".quick-input-list .monaco-list-row", lambda: self._palette(title), title).click()
        if not asks:
            self.page.locator(".quick-input-widget").first.wait_for(state="hidden")

    def _palette(self, title: str) -> None:
        """Type a command into the palette, which lists what there is when it opens."""
        self.page.keyboard.press("F1")
        self.page.locator(".quick-input-widget input").first.fill(f">{title}", timeout=PATIENCE_MS / 10)

    def hover(self) -> Locator:
        """What is said of the word under the cursor."""
        return self._until(".monaco-hover:visible", lambda: self.command("Show or Focus Hover"))

    def quick_fix(self, title: str) -> None:
        """Choose a quick fix of what stands under the cursor."""
        self._until(".action-widget .monaco-list-row", lambda: self.page.keyboard.press("Control+."), title)
        # Older releases cover the row with a block for the pointer.
        self.page.keyboard.press("Enter")

    def _until(self, place: str, asked: Callable[[], object], text: str = "") -> Locator:
        """Ask until it is there: a busy editor answers with what it has, or takes the box away again."""
        found = self.page.locator(place, has_text=text).first
        for _ in range(10):
            with contextlib.suppress(PlaywrightTimeout):
                asked()
                found.wait_for(timeout=PATIENCE_MS / 10)
                break
            self.page.keyboard.press("Escape")
        return found

    def answer(self, text: str) -> None:
        """Answer the question that a command asks at the top of the window."""
        box = self.page.locator(".quick-input-widget").first
        field = box.locator("input").first
        field.fill(text)
        field.press("Enter")
        box.wait_for(state="hidden")

    def go_to(self, line: int, column: int = 1) -> None:
        """Put the cursor into the editor that has the focus; 1-based."""
        self.page.keyboard.press("Control+g")
        self.answer(f":{line}:{column}")

    def focus(self, number: int = 0) -> None:
        """Put the focus into the n-th editor group."""
        self.page.keyboard.press(f"Control+{number + 1}")

    def until(self, script: str, argument: Any = None) -> None:
        """Wait until a function in the page says yes."""
        self.page.wait_for_function(script, arg=argument)

    def _asked(self, url: str) -> None:
        # What stands under the second name is answered within the page, from the extension's files: no such server is asked.
        within = ("//127.0.0.1", ".vscode-resource.vscode-cdn.net/")
        if url.startswith(("http:", "https:", "ws:", "wss:")) and not any(name in url for name in within):
            self.outside.append(url)


@contextlib.contextmanager
def workbench(window: Browser, address: str, folder: Path, name: str) -> Iterator[Workbench]:
    """A window of VS Code; how it looked at the end is kept where `DEBURR_PICTURES` says."""
    page = new_page(window)
    try:
        yield Workbench(page, address, folder)
    finally:
        kept(page, name)
        page.close()


def new_page(window: Browser) -> Page:
    """A page as large as the window of somebody who works in it."""
    return window.new_page(viewport={"width": 1400, "height": 850})


def kept(page: Page, name: str) -> None:
    """Keep how a page looks, if somebody wants to see it."""
    if folder := os.environ.get("DEBURR_PICTURES"):
        page.screenshot(path=f"{folder}/{name}.png")


def colours(line: Locator) -> Sequence[tuple[str, str]]:
    """The stretches of a line and their colour classes, as soon as it is coloured: that comes after the text."""
    line.locator("span > span:not(.mtk1)").first.wait_for()
    return [
        (str(text).replace("\u00a0", " "), str(name))
        for text, name in line.locator("span > span").evaluate_all(
            "all => all.map(each => [each.textContent, each.className])"
        )
    ]


def _free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return int(found.getsockname()[1])


def _wait_for(url: str, server: subprocess.Popen[bytes], log: Path) -> None:
    for _ in range(300):
        with contextlib.suppress(OSError), urllib.request.urlopen(url, timeout=1):
            return
        if server.poll() is not None:
            break
        time.sleep(0.2)
    raise RuntimeError(log.read_text(errors="replace"))


def _stop_group(server: subprocess.Popen[bytes]) -> None:
    """End the server and all that it started: the extension host outlives its parent otherwise."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(server.pid, number)
            with contextlib.suppress(subprocess.TimeoutExpired):
                server.wait(8)
