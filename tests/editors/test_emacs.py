"""Emacs with Eglot and the configuration that its README prints: what a user sees of each dialect."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from support.editors import TASKS, Task, check_seen, environment, shown, steps, written

DRIVER = Path(__file__).parent / "drive.el"


def used(task: Task, folder: Path) -> dict[str, Any]:
    """What was seen while a task was done."""
    plan, facts, init = (folder / name for name in ("plan.json", "facts.jsonl", "init.el"))
    init.write_text(shown("emacs", "elisp", "deburr"), encoding="utf-8")
    plan.write_text(json.dumps({"main": str(written(task, folder / "job")), **steps(task)}))
    (folder / "home").mkdir()
    ran = subprocess.run(
        ["emacs", "--batch", "-l", str(init), "-l", str(DRIVER)],
        env={**environment(folder / "home"), "PLAN": str(plan), "FACTS": str(facts)},
        cwd=folder,
        input=f"{task.action}\n",
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    found: dict[str, Any] = (
        dict(map(json.loads, facts.read_text(encoding="utf-8").splitlines())) if facts.exists() else {}
    )
    assert ran.returncode == 0, f"{found}\n{ran.stderr}"
    return found


def has_eglot() -> bool:
    """Whether there is an Emacs with Eglot."""
    return (
        shutil.which("emacs") is not None
        and not subprocess.run(
            ["emacs", "--batch", "--eval", "(require 'eglot)"], capture_output=True, check=False
        ).returncode
    )


@pytest.mark.skipif(not has_eglot(), reason="Emacs with Eglot is not installed")
@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.dialect)
def test_a_program_is_read_mended_renamed_and_expanded(task: Task, tmp_path: Path) -> None:
    found = used(task, tmp_path)
    assert found["filetype"] == f"deburr-{task.dialect}-mode"
    assert found["commentstring"] in ("; ", "// ")
    check_seen(task, found)
    assert found["flat line"] == task.from_to[1]
