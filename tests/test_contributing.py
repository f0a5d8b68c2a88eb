"""The walk-throughs of CONTRIBUTING.md, performed on a copy of the tree as the page says them; what they touch is counted."""

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from support.clone import Clone

ROOT = Path(__file__).parent.parent
PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
BLOCK = re.compile(
    r"(?m)(?:^`(?P<path>[^`\n]+)`:\n\n|^<!-- not-run: (?P<reason>[^>]+) -->\n)?^```(?P<kind>\w+)\n(?P<text>.*?)^```$",
    re.S,
)
NAMES = "grammar/deburr_grammar/dialects/__init__.py"
ISO = "grammar/deburr_grammar/dialects/iso/"


def perform(clone: Clone, title: str) -> None:
    """Everything that a section writes, changes and runs, in its order."""
    for block in blocks(title):
        path, kind, text = block["path"], block["kind"], block["text"]
        if path:
            assert not (clone.folder / path).exists(), path
            (clone.folder / path).parent.mkdir(parents=True, exist_ok=True)
            (clone.folder / path).write_text(text, encoding="utf-8")
        elif kind == "diff":
            subprocess.run(["git", "apply", "-"], cwd=clone.folder, input=text, text=True, check=True)
        else:
            assert kind == "sh"
            for command in text.strip().split("\n"):
                clone.run(command)


def blocks(title: str) -> Iterator[re.Match[str]]:
    """The blocks of a section that are to be performed."""
    section = re.search(rf"(?ms)^## {title}\n(.*?)(?=^## |\Z)", PAGE)
    assert section is not None
    return (block for block in BLOCK.finditer(section[1]) if not block["reason"])


@pytest.fixture
def clone(tmp_path: Path) -> Clone:
    return Clone(tmp_path)


def test_a_rule_is_one_file(clone: Clone) -> None:
    perform(clone, "Add a rule")
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
    perform(clone, "Add a dialect")
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
    assert "--> scrap.iso:2:6\n" in clone.run(".venv/bin/deburr check scrap.iso", code=1)


def test_a_feature_is_two_files_and_a_test(clone: Clone) -> None:
    perform(clone, "Add a feature for editors")
    assert clone.touched() == {
        "server/deburr/ide/nesting.py",
        "server/deburr/lsp/features/nesting.py",
        "tests/ide/test_nesting.py",
    }
    (passed,) = clone.passed()
    assert passed > 7
