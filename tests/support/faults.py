"""Programs with one fault each, written as people err: where deburr must speak, which rule, and with which words."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from deburr.page import CARETS
from support.pages import Example

FOLDER = Path(__file__).parents[1] / "faults"
_HEAD = re.compile(r"^== (.+)$", re.M)
_FILE = re.compile(r"^-- (.+) --$")


@dataclass(frozen=True)
class Faulty:
    """One program: what was mistyped, its rule, words that the message must hold so that one can mend it, the program with its mark, and how it should read."""

    name: str
    rule: str
    says: tuple[str, ...]
    example: Example
    mended: str


def faults(dialect: str) -> Iterator[Faulty]:
    """The faults of a dialect's file.

    A fault is a line `== what was done`, then `rule:`, `says:` (words with `|` between), `mend:`
    (the line as it should read; it replaces the marked line, an empty one takes it away, `\\n` parts
    lines) and settings (`profile: smithy`), a blank line, and the whole program with carets below what must be marked. `-- NAME --` starts another file.
    """
    parts = _HEAD.split((FOLDER / f"{dialect}.txt").read_text(encoding="utf-8"))[1:]
    return (_fault(name, body) for name, body in zip(parts[::2], parts[1::2], strict=True))


def _fault(name: str, body: str) -> Faulty:
    head, _, program = body.strip("\n").partition("\n\n")
    said = {key: value.strip() for key, _, value in (line.partition(":") for line in head.split("\n"))}
    rule, says, mend = said.pop("rule"), said.pop("says"), said.pop("mend")
    settings: Mapping[str, object] = {key: value.split("|") if "|" in value else value for key, value in said.items()}
    files, places = _read(program)
    lines = files.pop("")
    rows = {row for row, _, _ in places}
    assert len(rows) == 1, f"{name}: one line is marked"
    mended = [part for row, line in enumerate(lines) for part in (_parts(mend) if row in rows else [line])]
    texts = {file: "\n".join(text) + "\n" for file, text in files.items()}
    example = Example(False, "\n".join(lines) + "\n", texts, settings, tuple(places))
    return Faulty(name, rule, tuple(says.split("|")), example, "\n".join(mended) + "\n")


def _parts(mend: str) -> list[str]:
    return mend.split("\\n") if mend else []


def _read(program: str) -> tuple[dict[str, list[str]], list[tuple[int, int, int]]]:
    files: dict[str, list[str]] = {"": []}
    places: list[tuple[int, int, int]] = []
    current = ""
    for line in program.split("\n"):
        if named := _FILE.match(line):
            current = named[1]
            files[current] = []
        elif CARETS.fullmatch(line):
            assert not current, "carets mark the program itself, not another file"
            places += [(len(files[""]) - 1, run.start(), run.end()) for run in re.finditer(r"\^+", line)]
        else:
            files[current].append(line)
    return files, places
