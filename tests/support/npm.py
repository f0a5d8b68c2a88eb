"""The extension's own tools, run by npm."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

EXTENSION = Path(__file__).parents[2] / "vscode-extension"


def npm(*arguments: str) -> str:
    """What an npm command prints in the extension's folder; its faults are the test's."""
    ran = subprocess.run(
        [shutil.which("npm") or "npm", *arguments], cwd=EXTENSION, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, f"npm {' '.join(arguments)}\n{ran.stdout[-4000:]}\n{ran.stderr[-4000:]}"
    return ran.stdout


def prepared() -> None:
    """Install the development packages as the lock file names them, unless that was done."""
    lock, done = EXTENSION / "package-lock.json", EXTENSION / "node_modules" / ".package-lock.json"
    if not done.exists() or done.stat().st_mtime < lock.stat().st_mtime:
        npm("ci", "--no-audit", "--no-fund")
        done.touch()
