"""A copy of what git tracks, in which the commands of a page are run. The environment is that of the tests."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
_KEPT = {".venv", ".pytest_cache", ".hypothesis", ".deburr_cache", "__pycache__"}
"""What programs keep for themselves."""


class Clone:
    """A copy of the tree. ``made``: the files that `deburr.dev.generate` wrote in it; ``said``: what each command printed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.made: set[str] = set()
        self.said: list[str] = []
        copied(folder)
        self.before = self.files()
        # The copy's packages come before the installed ones.
        (folder / ".venv").symlink_to(sys.prefix)
        self._environment = os.environ | {"PYTHONPATH": f"{folder / 'grammar'}:{folder / 'server'}"}

    def files(self) -> dict[str, bytes]:
        """All files by their paths, but for what programs keep for themselves."""
        return {
            str(path.relative_to(self.folder)): path.read_bytes()
            for path in self.folder.rglob("*")
            if path.is_file() and not _KEPT & set(path.relative_to(self.folder).parts)
        }

    def run(self, command: str, code: int = 0) -> str:
        """A command, which must end with that code; what it printed."""
        done = subprocess.run(
            ["sh", "-c", command], cwd=self.folder, env=self._environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == code, f"{command}\n{done.stdout[-5000:]}\n{done.stderr[-3000:]}"
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


def copied(folder: Path) -> None:
    """Put what git tracks into a folder."""
    for name in tracked(ROOT):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)


def tracked(root: Path) -> list[str]:
    """What a fresh clone would hold: the files git tracks, as they are now."""
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], cwd=root, capture_output=True, text=True, check=True
    )
    return [name for name in filter(None, listed.stdout.split("\n")) if (root / name).is_file()]
