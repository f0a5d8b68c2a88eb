"""LinuxCNC's own programs as cases, and calls of the subprograms among them."""

import re
from pathlib import Path

from support.flat import Case
from support.oracle import SAMPLES


def sample(path: Path) -> Case:
    beside = {other.name: read(other) for other in path.parent.glob("*.ngc") if other != path}
    return Case(str(path.relative_to(SAMPLES)), read(path), beside, path.name, tools=THIN)


def read(path: Path) -> str:
    return path.read_bytes().decode("utf-8", "replace")


THIN = "".join(f"T{number} P{number} D0.001\n" for number in range(1, 100))
"""Tools so thin that every corner of the samples can be cut."""
_SET = re.compile(r"(?m)^[ \t]*#<[^>]*>[ \t]*=[ \t]*#(\d+)[ \t]*(?:\([ \t]*=?[ \t]*([-+]?[0-9.]+)?)?")
_HEADS = {
    "inch": "G20 G17 G40 G49 G80 G90 G94 G54 F100 S1000",
    "lathe": "G21 G18 G40 G49 G80 G90 G94 F300 S1000",
}


def drivers() -> list[Case]:
    """A call of each library subprogram with the arguments that its comments give as defaults, or ones."""
    texts = {path.stem.lower(): read(path) for path in sorted(SAMPLES.rglob("*.ngc"))}
    subs = {
        name: text
        for name, text in texts.items()
        if re.search(rf"(?im)^\s*o\s*<\s*{re.escape(name)}\s*>\s*sub\b", text)
    }
    files = {f"{name}.ngc": text for name, text in subs.items()}
    found = []
    for name, text in subs.items():
        given = {int(number): value or "1" for number, value in reversed(_SET.findall(text)) if int(number) <= 30}
        arguments = " ".join(f"[{given.get(at, '1')}]" for at in range(1, max(given, default=0) + 1))
        found += [
            Case(f"{name}/{head}", f"{words}\no<{name}> call {arguments}\nM2\n", files, tools=THIN)
            for head, words in _HEADS.items()
        ]
    return found
