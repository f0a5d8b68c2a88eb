"""Hovers as data: programs with a cursor `<|>`, the files beside them, and what is said, to the letter."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

FOLDER = Path(__file__).parents[1] / "ide" / "hovers"
_PART = re.compile(r"^-- (.+) --\n", re.M)


class Hovered(NamedTuple):
    """A case: its title, the program with its cursor, files beside it by name, settings of the dialect, the Markdown."""

    title: str
    dialect: str
    program: str
    files: Mapping[str, str]
    settings: Mapping[str, Any]
    said: str


def hovers(dialect: str) -> Iterator[Hovered]:
    """The cases of a dialect: `=== title`, the program, `-- NAME --` before a file or `-- settings --` before TOML, `==>`, the Markdown."""
    text = (FOLDER / f"{dialect}.txt").read_text(encoding="utf-8")
    for case in text.split("=== ")[1:]:
        title, _, rest = case.partition("\n")
        given, _, said = rest.partition("==>\n")
        program, *parts = _PART.split(given)
        files = dict(zip(parts[::2], parts[1::2], strict=True))
        settings = tomllib.loads(files.pop("settings", ""))
        yield Hovered(title, dialect, program, files, settings, said.strip("\n"))
