"""The packaged extension, made once for all tests that install it."""

from __future__ import annotations

import fcntl
import shutil
from pathlib import Path

import pytest

from support.npm import EXTENSION, npm, prepared


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


def sources(extension: Path) -> list[Path]:
    """What the package is made from."""
    root = extension.parent
    folders = [extension / "src", extension / "scripts", extension / "syntaxes", root / "server", root / "grammar"]
    files = [
        each
        for folder in folders
        for each in folder.rglob("*")
        if each.suffix in (".ts", ".mjs", ".json", ".py", ".tables")
    ]
    return [*files, *extension.glob("*.json"), *(extension / "bundled").glob("*.*")]
