"""The extension's own checks: types and style, units, colours, and that the package is whole and small."""

from __future__ import annotations

import json
import re
import subprocess
import zipfile
from pathlib import Path

import pytest

from deburr.cli.main import main
from deburr_grammar.dialects import NAMES, by_name
from support.npm import EXTENSION, npm

MOST = 10_000_000
"""Bytes that the package may have."""
LEAST = 40
"""Colours of a language that are told one by one."""


@pytest.mark.parametrize("script", ["check", "test", "colours"])
def test_its_own_checks_pass(extension: Path, script: str) -> None:
    npm("run", script)


@pytest.mark.parametrize("name", NAMES)
def test_colours_of_each_language_are_looked_at_closely(name: str) -> None:
    first, *lines = (EXTENSION / "test" / "colours" / f"{name}.txt").read_text(encoding="utf-8").split("\n")
    sign = re.escape(first.partition(" SYNTAX TEST ")[0])
    asserted = [line for line in lines if re.match(rf"{sign} *(?:<~*-+|\^+) [a-z]", line)]
    assert len(asserted) >= LEAST


@pytest.mark.parametrize("name", NAMES)
def test_each_language_has_an_example_with_one_mistake(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    example = EXTENSION / "walkthrough" / f"example{by_name(name).extensions[0]}"
    assert main(["check", "--output-format", "json", str(example)]) == 1
    (error,) = [each for each in json.loads(capsys.readouterr().out) if each["severity"] == "error"]
    assert "did you mean" in error["message"] and error["fix"] is not None


def test_the_package_is_small_and_holds_all_that_runs(vsix: Path) -> None:
    assert vsix.stat().st_size < MOST
    names = set(zipfile.ZipFile(vsix).namelist())
    needed = ("dist/extension.js", "bundled/serve.py", "bundled/pyodide.mjs", "bundled/libs/deburr/lsp/embedded.py")
    assert {f"extension/{each}" for each in needed} <= names
    assert not [each for each in names if each.endswith((".so", ".pyd", ".map", ".ts"))]
    assert not [each for each in names if "node_modules" in each or "__pycache__" in each]


def test_nothing_is_amiss_when_it_is_packed(vsix: Path, tmp_path: Path) -> None:
    script = json.loads((EXTENSION / "package.json").read_text(encoding="utf-8"))["scripts"]["package"]
    command = script.split(" && ")[-1].replace("deburr.vsix", str(tmp_path / "deburr.vsix"))
    ran = subprocess.run(["npx", *command.split()], cwd=EXTENSION, capture_output=True, text=True, check=True)
    assert "WARN" not in ran.stdout + ran.stderr


def test_the_viewer_in_the_python_package_is_what_its_sources_make(extension: Path, tmp_path: Path) -> None:
    made = tmp_path / "viewer.js"
    npm("run", "viewer", "--", str(made))
    assert made.read_bytes() == (extension.parent / "server" / "deburr" / "plot" / "viewer.js").read_bytes()
