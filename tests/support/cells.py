"""What an editor can show, as a table: each row a question, each column a dialect, each cell a program and the answer to the letter.

A cell is written in `tests/lsp/cells/<dialect>.txt`: `=== row`, the program with its cursor `<|>` (two of them: a selection), `-- NAME --` before
another file, `-- ask --` before more parameters as JSON, `==>`, the answer as `said` writes it. `=== row: reason` is a cell of a dialect
that has nothing of the sort; the server must then answer with nothing.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from support.views import CURSOR

FOLDER = Path(__file__).parents[1] / "lsp" / "cells"
_PART = re.compile(r"^-- (.+) --\n", re.M)

Json = dict[str, Any]


class Cell(NamedTuple):
    """A program with its cursor, the files beside it, more parameters, and what is answered. ``reason``: why there can be nothing."""

    dialect: str
    row: str
    reason: str
    program: str
    files: Mapping[str, str]
    more: Mapping[str, Any]
    answer: str

    @property
    def text(self) -> str:
        """The program without its cursor."""
        return self.program.replace(CURSOR, "")

    @property
    def places(self) -> list[Json]:
        """The start and the end of the selection; the cursor twice if there is none. Programs are ASCII, so columns are units."""
        parts = self.program.split(CURSOR)
        found = []
        for number in range(1, len(parts)):
            before = "".join(parts[:number])
            found.append({"line": before.count("\n"), "character": len(before.rpartition("\n")[2])})
        start = found[0] if found else {"line": 0, "character": 0}
        return [start, found[-1] if found else start]


def cells(dialect: str) -> Iterator[Cell]:
    """The cells of a dialect; none where nobody has written any, which the test of the table then says."""
    file = FOLDER / f"{dialect}.txt"
    for case in file.read_text(encoding="utf-8").split("=== ")[1:] if file.exists() else ():
        title, _, rest = case.partition("\n")
        given, _, answer = rest.partition("==>\n")
        program, *parts = _PART.split(given)
        files = dict(zip(parts[::2], parts[1::2], strict=True))
        more = json.loads(files.pop("ask", "{}"))
        row, _, reason = title.partition(": ")
        yield Cell(dialect, row, reason, program, files, more, answer.strip("\n"))


class Names:
    """URIs of a folder's files as their names."""

    def __init__(self, folder: Path) -> None:
        self._start = folder.as_uri() + "/"
        self._path = str(folder) + "/"

    def of(self, uri: str) -> str:
        """The name of a file, in a virtual document behind its scheme."""
        return uri.replace(self._start, "").replace(self._path, "")


def place(found: Json) -> str:
    """A range as `line:col-col` or `line:col-line:col`, counted from 0 as the protocol does."""
    start, end = found["start"], found["end"]
    last = f"{end['line']}:" if end["line"] != start["line"] else ""
    return f"{start['line']}:{start['character']}-{last}{end['character']}"


def location(found: Json, names: Names) -> str:
    """A range in a file."""
    return f"{names.of(found['uri'])} {place(found['range'])}"


def edit(found: Json) -> str:
    """What takes the place of a range."""
    return f"{place(found['range'])} {json.dumps(found['newText'])}"


def workspace_edit(found: Json, names: Names) -> Iterator[str]:
    """The edits of files, and the files that are made."""
    for change in found["documentChanges"]:
        if change.get("kind") == "create":
            yield f"create {names.of(change['uri'])}"
            continue
        for each in change["edits"]:
            yield f"{names.of(change['textDocument']['uri'])} {edit(each)}"


def diagnostic(found: Json) -> str:
    """Where it is, how bad, and which rule."""
    assert (found["source"], found["message"] != "") == ("deburr", True)
    # Clients that cannot show a page of ours are given none.
    assert found["code"] in found.get("codeDescription", {"href": found["code"]})["href"]
    return f"{place(found['range'])} {('', 'error', 'warning', 'info')[found['severity']]} {found['code']}"


def symbol(found: Json, indent: str = "") -> Iterator[str]:
    """A part of a program: name, kind, lines, place of its name; what it holds below it."""
    yield f"{indent}{found['name']} {found['kind']} {place(found['range'])} {place(found['selectionRange'])}"
    for each in found.get("children") or ():
        yield from symbol(each, indent + "  ")


def action(found: Json, names: Names) -> Iterator[str]:
    """What can be done: its kind and title, and its edits."""
    yield f"{found['kind']}{' preferred' if found.get('isPreferred') else ''}: {found['title']}"
    yield from (f"  {each}" for each in workspace_edit(found["edit"], names))


def colours(data: list[int], legend: Json) -> Iterator[str]:
    """Coloured stretches with their type and modifier."""
    line = start = 0
    for at in range(0, len(data), 5):
        down, along, length, kind, modifiers = data[at : at + 5]
        line, start = line + down, along if down else start + along
        names = [name for bit, name in enumerate(legend["tokenModifiers"]) if modifiers >> bit & 1]
        yield f"{line}:{start}-{start + length} {'.'.join([legend['tokenTypes'][kind], *names])}"


def call_item(found: Json, names: Names) -> str:
    """A routine: name, kind, file, lines, place of its name."""
    return f"{found['name']} {found['kind']} {location(found, names)} {place(found['selectionRange'])}"
