"""LinuxCNC's interpreter as judge: runs a program and says whether it was accepted, and what it said."""

import os
import re
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

SAMPLES = Path("/usr/share/linuxcnc/ncfiles")
SECONDS = 5


@dataclass(frozen=True)
class Verdict:
    """Whether the interpreter ran the program to its end, its message if not, and the line it then echoed."""

    accepted: bool
    message: str
    echo: str


def complaints(program: str, folder: Path, *options: str) -> list[str]:
    """What the interpreter says of all lines of a program: with `-n 0` it goes on behind each that it refuses, so that one run judges many."""
    (folder / "p.ngc").write_text(program)
    (folder / "p.var").touch()
    done = subprocess.run(
        ["rs274", "-g", "-n", "0", *options, "-v", "p.var", "p.ngc"],
        cwd=folder,
        env={**os.environ, "HOME": str(folder)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    return done.stderr.split("\n")


def judged(program: str, folder: Path, files: Mapping[str, str] | None = None) -> Verdict:
    """Run a program in a scratch folder with a home of its own: the interpreter truncates files in both."""
    for name, text in {"p.ngc": program, "p.var": "", **(files or {})}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "tools.tbl").write_text("".join(f"T{n} P{n} D0.001\n" for n in range(1, 100)))
    command = ["rs274", "-g", "-n", "2", "-t", "tools.tbl", "-v", "p.var", "p.ngc"]
    environment = {**os.environ, "HOME": str(folder)}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=SECONDS, check=False)
    said = [line for line in done.stderr.decode("utf-8", "replace").split("\n") if line and line != "executing"]
    # Errors of O-words carry a line number of their own kind in front.
    message = re.sub(r"^\d+: ", "", said[0]) if said else ""
    return Verdict(done.returncode == 0, message, said[1] if len(said) > 1 else "")
