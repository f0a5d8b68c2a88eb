"""Programs with one fault each, written as people err: where deburr must speak, which rule, and with which words."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from deburr.page import CARETS
from support.pages import BYTES, Example

FOLDER = Path(__file__).parents[1] / "faults"
_HEAD = re.compile(r"^== (.+)$", re.M)
_FILE = re.compile(r"^-- (.+) --$")


@dataclass(frozen=True)
class Faulty:
    """One program: what was mistyped, its rule, words that the message must hold so that one can mend it, the program with its mark, and how it should read.

    ``runs``: the control runs it none the less, and the rule speaks because the reference decides so.
    """

    name: str
    rule: str
    says: tuple[str, ...]
    example: Example
    mended: str
    runs: bool = False


def faults(dialect: str, folder: Path = FOLDER) -> Iterator[Faulty]:
    """The faults of a dialect's file in a folder.

    A fault is a line `== what was done`, then `rule:`, `says:` (words with `|` between), `mend:`
    (the line as it should read; it replaces the marked line, an empty one takes it away, `\\n` parts
    lines), where the end lacks a line `add:` with it, where a name must change from the
    marked line on `rename: OLD => NEW`, `oracle: runs` where the control runs the
    faulty program, and settings (`profile: smithy`), a blank line, and the whole program with carets below what must be marked;
    what cannot be seen is drawn as in rule pages. `-- NAME --` starts another file.
    """
    parts = _HEAD.split((folder / f"{dialect}.txt").read_text(encoding="utf-8"))[1:]
    return (_fault(name, body) for name, body in zip(parts[::2], parts[1::2], strict=True))


def _fault(name: str, body: str) -> Faulty:
    head, _, program = body.strip("\n").partition("\n\n")
    said = {key: value.strip() for key, _, value in (line.partition(":") for line in head.split("\n"))}
    rule, says, mend = said.pop("rule"), said.pop("says"), said.pop("mend")
    added, runs = _parts(said.pop("add", "")), said.pop("oracle", "") == "runs"
    old, _, new = said.pop("rename", "").partition(" => ")
    settings: Mapping[str, object] = {key: value.split("|") if "|" in value else value for key, value in said.items()}
    files, places = _read(program)
    lines = files.pop("")
    rows = {row for row, _, _ in places}
    assert len(rows) == 1, f"{name}: one line is marked"
    first = min(rows)
    below = [line.replace(old, "\n".join(_parts(new))) if old else line for line in lines[first + 1 :]]
    mended = [*lines[:first], *_parts(mend), *below, *added]
    texts = {file: "\n".join(text) + "\n" for file, text in files.items()}
    text = "\n".join(lines).translate(BYTES) + "\n"
    example = Example(False, text, texts, settings, tuple(places))
    return Faulty(name, rule, tuple(says.split("|")), example, "\n".join(mended) + "\n", runs)


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
