"""The packaged extension, made once for all tests that install it."""

from __future__ import annotations

import fcntl
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from support.npm import EXTENSION, npm, prepared

if TYPE_CHECKING:
    from playwright.sync_api import Browser

    from support.room import Room


@pytest.fixture(scope="session")
def extension() -> Path:
    """The extension's folder with its development packages installed."""
    if shutil.which("npm") is None:
        pytest.skip("npm is not installed")
    with (EXTENSION / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        prepared()
    return EXTENSION


@pytest.fixture(scope="session")
def vsix(extension: Path) -> Path:
    """The extension as users get it."""
    made = extension / "deburr.vsix"
    with (extension / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        newest = max(each.stat().st_mtime for each in sources(extension))
        if not made.exists() or made.stat().st_mtime < newest:
            npm("run", "package")
    return made


@pytest.fixture(scope="module")
def window() -> Iterator[Browser]:
    """A browser without a screen, for the tests of one file: what drives it keeps an event loop running, in which no other test could run its own."""
    from support.vscode import browser

    with browser() as found:
        yield found


@pytest.fixture(scope="session")
def trusted(vsix: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a VS Code with the extension, in which every folder is trusted."""
    from support.vscode import code_server

    with code_server(tmp_path_factory.mktemp("code"), vsix) as address:
        yield address


@pytest.fixture(scope="module")
def room(window: Browser, trusted: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Room]:
    """A window for all tests that need none of their own."""
    from support.room import Room

    found = Room(window, trusted, tmp_path_factory.mktemp("room"))
    yield found
    found.close()


def sources(extension: Path) -> list[Path]:
    """What the package is made from."""
    root = extension.parent
    folders = [
        extension / "src",
        extension / "scripts",
        extension / "syntaxes",
        extension / "walkthrough",
        extension / "icons",
        extension / "pictures",
        root / "server",
        root / "grammar",
    ]
    files = [
        each
        for folder in folders
        for each in folder.rglob("*")
        if each.suffix in (".ts", ".mjs", ".js", ".json", ".md", ".py", ".tables")
        or each.parent.name in ("walkthrough", "icons", "pictures")
    ]
    own = [each for pattern in ("*.json", "*.md", "bundled/*.*") for each in extension.glob(pattern)]
    return [*files, *own]
