"""Hovers as a client sees them: the same Markdown in every encoding, behind characters of several units, files read from disk."""

from __future__ import annotations

from pathlib import Path

import pytest

from deburr_grammar.dialects import NAMES, by_name
from support.hovers import Hovered, hovers
from support.inside import Inside
from support.views import CURSOR

WIRE = {"utf-8": ("utf-8", 1), "utf-16": ("utf-16-le", 2)}


def named(case: Hovered) -> object:
    return pytest.param(case, id=f"{case.dialect}-{case.title}")


def written(case: Hovered, folder: Path) -> None:
    """The files of a case on disk."""
    for name, text in case.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


@pytest.mark.parametrize("encoding", WIRE)
@pytest.mark.parametrize("case", [named(case) for dialect in NAMES for case in hovers(dialect)])
def test_hover(case: Hovered, encoding: str, tmp_path: Path) -> None:
    written(case, tmp_path)
    before = case.program.partition(CURSOR)[0]
    line = before.count("\n")
    codec, unit = WIRE[encoding]
    col = len(before.rpartition("\n")[2].encode(codec)) // unit
    options = {case.dialect: dict(case.settings)}
    folders = [{"uri": tmp_path.as_uri(), "name": "here"}]
    offered = {"general": {"positionEncodings": [encoding]}}
    with Inside(offered, workspaceFolders=folders, initializationOptions=options) as inside:
        uri = (tmp_path / f"main{by_name(case.dialect).extensions[0]}").as_uri()
        inside.open(uri, case.program.replace(CURSOR, ""), case.dialect)
        at = {"textDocument": {"uri": uri}, "position": {"line": line, "character": col}}
        found = inside.request("textDocument/hover", at)
    assert found["contents"] == {"kind": "markdown", "value": case.said}
    text = case.program.replace(CURSOR, "").split("\n")[line].encode(codec)
    start, end = (found["range"][which]["character"] * unit for which in ("start", "end"))
    assert text[start:end].decode(codec).strip("#|<>@ ") != ""
    assert start <= col * unit <= end
