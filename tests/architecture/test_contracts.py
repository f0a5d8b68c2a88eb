"""The arrows between modules, as import-linter reads them from pyproject.toml; and the proof that it would speak."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from support.code import PACKAGES, ROOT

LINT = "import sys; from importlinter.cli import lint_imports_command; sys.exit(lint_imports_command())"


def lint(root: Path) -> subprocess.CompletedProcess[str]:
    """Run the contracts over a tree that looks like this repository."""
    path = os.pathsep.join(str(root / package.relative_to(ROOT).parent) for package in PACKAGES)
    environment = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-c", LINT, "--no-cache", "--config", str(root / "pyproject.toml")]
    return subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)


def test_the_contracts_hold() -> None:
    done = lint(ROOT)
    assert done.returncode == 0, done.stdout + done.stderr
    assert " 0 broken" in done.stdout


PLANTED = {
    "the grammar imports deburr": (
        "grammar/deburr_grammar/text.py",
        "from deburr.finding import Severity",
        "knows nothing of deburr",
    ),
    "the grammar imports the protocol": (
        "grammar/deburr_grammar/codes.py",
        "import lsprotocol",
        "knows nothing of deburr",
    ),
    "the server's core imports pygls": ("server/deburr/finding.py", "import pygls", "may know the protocol"),
    "text looks at documents": (
        "grammar/deburr_grammar/text.py",
        "from deburr_grammar.document import Document",
        "The parser's layers",
    ),
    "a line looks at chunks": (
        "grammar/deburr_grammar/line.py",
        "from deburr_grammar.chunk import Chunk",
        "The parser's layers",
    ),
    "a finding looks at the analysis": (
        "server/deburr/finding.py",
        "from deburr.analysis import Analysis",
        "Arrows of the server",
    ),
    "a run looks at moves": ("server/deburr/expand/job.py", "from deburr.motion import Path", "Arrows of the server"),
    "moves look at rules": ("server/deburr/motion/path.py", "import deburr.rules.common", "Arrows of the server"),
}


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("copy")
    shutil.copy(ROOT / "pyproject.toml", root)
    for package in PACKAGES:
        shutil.copytree(
            package,
            root / package.relative_to(ROOT),
            ignore=shutil.ignore_patterns("__pycache__", "*.toml", "*.tables"),
        )
    return root


@pytest.mark.parametrize("name", sorted(PLANTED))
def test_a_planted_import_is_reported(name: str, copy: Path) -> None:
    file, line, contract = PLANTED[name]
    path = copy / file
    before = path.read_text(encoding="utf-8")
    try:
        path.write_text(f"{before}\n{line}\n", encoding="utf-8")
        done = lint(copy)
    finally:
        path.write_text(before, encoding="utf-8")
    assert done.returncode != 0, done.stdout
    assert any(contract in said and "BROKEN" in said for said in done.stdout.splitlines()), done.stdout
