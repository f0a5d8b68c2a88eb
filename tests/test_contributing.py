"""The walk-throughs of CONTRIBUTING.md, performed on a copy of the tree as the page says them; what they touch is counted."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
BLOCK = re.compile(
    r"(?m)(?:^`(?P<path>[^`\n]+)`:\n\n|^<!-- not-run: (?P<reason>[^>]+) -->\n)?^```(?P<kind>\w+)\n(?P<text>.*?)^```$",
    re.S,
)
NAMES = "grammar/deburr_grammar/dialects/__init__.py"
KEPT = {".venv", ".pytest_cache", ".hypothesis", ".deburr_cache", "__pycache__"}
ISO = "grammar/deburr_grammar/dialects/iso/"


class Clone:
    """A copy of what git tracks, in which a section of the page is performed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.made: set[str] = set()
        self.said: list[str] = []
        listed = subprocess.run(
            ["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True
        )
        for name in filter(None, listed.stdout.split("\n")):
            if (ROOT / name).is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / name, folder / name)
        self.before = self.files()
        # The environment of the tests, in which the copy's packages come before the installed ones.
        (folder / ".venv").symlink_to(sys.prefix)
        self.environment = os.environ | {"PYTHONPATH": f"{folder / 'grammar'}:{folder / 'server'}"}
        self.environment.pop("PYTEST_CURRENT_TEST", None)

    def files(self) -> dict[str, bytes]:
        """All files by their paths, but for what programs keep for themselves."""
        return {
            str(path.relative_to(self.folder)): path.read_bytes()
            for path in self.folder.rglob("*")
            if path.is_file() and not KEPT & set(path.relative_to(self.folder).parts)
        }

    def perform(self, title: str) -> None:
        """Everything that a section writes, changes and runs, in its order."""
        for block in blocks(title):
            path, kind, text = block["path"], block["kind"], block["text"]
            if path:
                assert not (self.folder / path).exists(), path
                (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
                (self.folder / path).write_text(text, encoding="utf-8")
            elif kind == "diff":
                subprocess.run(["git", "apply", "-"], cwd=self.folder, input=text, text=True, check=True)
            else:
                assert kind == "sh"
                for command in text.strip().split("\n"):
                    self.run(command)

    def run(self, command: str) -> str:
        """A command, which must succeed; what it printed."""
        done = subprocess.run(
            ["sh", "-c", command], cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{command}\n{done.stdout[-5000:]}\n{done.stderr[-3000:]}"
        self.made |= set(re.findall(r"(?m)^wrote (.*)$", done.stdout)) if "dev.generate" in command else set()
        self.said.append(done.stdout)
        return done.stdout

    def touched(self) -> set[str]:
        """What is other than it was, but for what is generated."""
        after = self.files()
        changed = {name for name in after.keys() | self.before.keys() if after.get(name) != self.before.get(name)}
        return {name for name in changed - self.made if not name.endswith(".tables")}

    def passed(self) -> list[int]:
        """How many tests passed, of each run of them."""
        found = (re.search(r"(?m)^(\d+) passed", each) for each in self.said)
        return [int(each[1]) for each in found if each]


def blocks(title: str) -> Iterator[re.Match[str]]:
    """The blocks of a section that are to be performed."""
    section = re.search(rf"(?ms)^## {title}\n(.*?)(?=^## |\Z)", PAGE)
    assert section is not None
    return (block for block in BLOCK.finditer(section[1]) if not block["reason"])


@pytest.fixture
def clone(tmp_path: Path) -> Clone:
    return Clone(tmp_path)


def test_a_rule_is_one_file(clone: Clone) -> None:
    clone.perform("Add a rule")
    assert clone.touched() == {"server/deburr/rules/rs274/todo_left.py"}
    assert "server/deburr/rules/rs274/_index.py" in clone.made
    (passed,) = clone.passed()
    assert passed >= 3
    assert clone.said[-1].startswith("rs274.todo-left (warning, off by default)")
    # It speaks where it is asked for, and nowhere else.
    program = clone.folder / "a.ngc"
    program.write_text("G0 Z5 (TODO: clamp)\nM2\n", encoding="utf-8")
    assert "todo-left" not in clone.run(".venv/bin/deburr check a.ngc")
    assert "--> a.ngc:1:8\n" in clone.run(".venv/bin/deburr check --extend-select rs274.todo-left a.ngc")


def test_a_dialect_is_one_folder_one_line_and_its_programs(clone: Clone) -> None:
    clone.perform("Add a dialect")
    touched = clone.touched()
    rule = "server/deburr/rules/iso/word_malformed.py"
    assert {name for name in touched if not name.startswith(ISO)} == {NAMES, "examples/iso/slot.iso", rule}
    assert {name.removeprefix(ISO) for name in touched if name.startswith(ISO)} == {
        "__init__.py",
        "codes.toml",
        "editor.toml",
        "line.lark",
        "variables.toml",
    }
    before, after = (each.split(b"\n") for each in (clone.before[NAMES], (clone.folder / NAMES).read_bytes()))
    assert len(before) == len(after) and sum(one != other for one, other in zip(before, after, strict=True)) == 1
    assert all(passed >= 3 for passed in clone.passed()) and len(clone.passed()) == 2
    assert "1 checked" in "".join(clone.said), "the program of the walk-through was looked at"
    scrap = clone.folder / "scrap.iso"
    scrap.write_text("REPEAT 3\nG1 Z F100\nEND\n", encoding="utf-8")
    assert "--> scrap.iso:2:6\n" in clone.run(".venv/bin/deburr check scrap.iso || true")


def test_a_feature_is_two_files_and_a_test(clone: Clone) -> None:
    clone.perform("Add a feature for editors")
    assert clone.touched() == {
        "server/deburr/ide/nesting.py",
        "server/deburr/lsp/features/nesting.py",
        "tests/ide/test_nesting.py",
    }
    (passed,) = clone.passed()
    assert passed > 7
