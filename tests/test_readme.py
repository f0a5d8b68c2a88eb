"""Every command that the README prints is run as printed, in a copy of the tree with a virtual environment of its own."""

import re
import subprocess
from pathlib import Path

import pytest

from support.clone import copied

ROOT = Path(__file__).parent.parent
BLOCK = re.compile(r"(?:<!-- not-run: (?P<reason>[^>]+) -->\n)?```sh\n(?P<commands>.*?)```", re.S)
FINDS_SOMETHING = (
    "deburr check examples",
    "deburr check --output-format",
    "deburr check --select",
    "&& .venv/bin/deburr check",
)


def blocks(document: Path) -> list[tuple[str | None, list[str]]]:
    found = BLOCK.finditer(document.read_text(encoding="utf-8"))
    return [(match["reason"], match["commands"].strip().split("\n")) for match in found]


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a fresh clone would hold: the files git tracks, as they are now."""
    target = tmp_path_factory.mktemp("clone")
    copied(target)
    return target


def test_only_the_test_run_itself_is_not_run() -> None:
    assert [reason for reason, _ in blocks(ROOT / "README.md") if reason] == ["this is the test run itself"]


def test_commands_do_what_the_readme_says(copy: Path) -> None:
    for reason, commands in blocks(ROOT / "README.md"):
        for command in () if reason else commands:
            done = subprocess.run(["sh", "-c", command], cwd=copy, capture_output=True, text=True, check=False)
            expected = 1 if any(said in command for said in FINDS_SOMETHING) else 0
            assert done.returncode == expected, (command, done.stdout, done.stderr)
            # The first command's promise in the README; checked here because only here its environment is sure to exist.
            assert "pip install -q ." not in command or "Found 5 errors" in done.stdout
    made = [name for name in ("docs", "grammar", "server") if _changed(copy / name, ROOT / name)]
    assert made == [], "what is generated was not fresh"


def test_ci_runs_exactly_the_test_command() -> None:
    (command,) = [commands for reason, commands in blocks(ROOT / "README.md") if reason]
    pattern = re.search(r"sed -n '/(.*)/p' README.md", (ROOT / ".ci/run").read_text(encoding="utf-8"))
    assert pattern is not None
    shown = [
        line for line in (ROOT / "README.md").read_text(encoding="utf-8").split("\n") if re.search(pattern[1], line)
    ]
    assert shown == command


def _changed(one: Path, other: Path) -> bool:
    paths = [
        path
        for path in one.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and path.suffix != ".tables"
    ]
    return any(path.read_bytes() != (other / path.relative_to(one)).read_bytes() for path in paths)
