"""The extension's own checks: types and style, units, colours, and that the package is whole and small."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from support.npm import npm

MOST = 10_000_000
"""Bytes that the package may have."""


@pytest.mark.parametrize("script", ["check", "test", "colours"])
def test_its_own_checks_pass(extension: Path, script: str) -> None:
    npm("run", script)


def test_the_package_is_small_and_holds_all_that_runs(vsix: Path) -> None:
    assert vsix.stat().st_size < MOST
    names = set(zipfile.ZipFile(vsix).namelist())
    needed = ("dist/extension.js", "bundled/serve.py", "bundled/pyodide.mjs", "bundled/libs/deburr/lsp/embedded.py")
    assert {f"extension/{each}" for each in needed} <= names
    assert not [each for each in names if each.endswith((".so", ".pyd", ".map", ".ts"))]
    assert not [each for each in names if "node_modules" in each or "__pycache__" in each]
