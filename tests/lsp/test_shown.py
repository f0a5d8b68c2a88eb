"""Links, lenses, hints, linked labels, and the way between a program and its flat form."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from support.inside import Inside

ALL = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}


def ask(inside: Inside, method: str, uri: str = "untitled:x", **more: Any) -> Any:
    return inside.request(f"textDocument/{method}", {"textDocument": {"uri": uri}, **more})


def test_names_of_files_are_links(tmp_path: Path) -> None:
    main, part = (tmp_path / "main.mgc").as_uri(), tmp_path / "Snippets" / "part"
    part.parent.mkdir()
    part.write_text("G1\n")
    with Inside() as inside:
        inside.open(main, "#FILE none\n#FILE part\n", "metagcode")
        (link,) = ask(inside, "documentLink", main)
        assert link["target"] == part.as_uri()
        assert link["range"] == {"start": {"line": 1, "character": 6}, "end": {"line": 1, "character": 10}}


@pytest.mark.parametrize(
    ("settings", "titles"),
    [({}, ["Expand", "2 calls"]), ({"editor": {"code-lens": False}}, []), ({"editor": {"code-lens": {"expand": False}}}, ["2 calls"])],
)  # fmt: skip
def test_lenses(settings: dict[str, Any], titles: list[str]) -> None:
    with Inside(initializationOptions=settings) as inside:
        inside.open("untitled:x", "o<s> sub\no<s> endsub\no<s> call\no<s> call\nM2\n", "rs274")
        assert [each["command"]["title"] for each in ask(inside, "codeLens")] == titles


@pytest.mark.parametrize(
    ("settings", "labels"), [({}, ["=Y", "=Z"]), ({"editor": {"inlay-hints": {"alias": False}}}, [])]
)
def test_hints(settings: dict[str, Any], labels: list[str]) -> None:
    with Inside(initializationOptions=settings) as inside:
        inside.open("untitled:x", "(P)\nAA1\nG25YZX\nAA1 AB2\nM30\n", "z32")
        found = ask(inside, "inlayHint", range=ALL)
        assert [each["label"] for each in found] == labels
        assert [each["position"] for each in found] == [{"line": 3, "character": at} for at in (2, 6)][: len(labels)]


@pytest.mark.parametrize(
    ("language", "text", "at", "lines"),
    [
        ("rs274", "o1 if [1]\no1 else\no1 endif\n", (0, 1), [0, 1, 2]),
        ("metagcode", "#IF1 |a| EqualTo 1 n\n#IF2 |a| EqualTo 1 n\n#ENDIF2\n#ENDIF1\n", (3, 7), [0, 3]),
        ("metagcode", "#IF1 |a| EqualTo 1 n\n#ENDIF1\n", (0, 1), []),
        ("rs274", "G1 X1\n", (0, 1), []),
    ],
)
def test_linked_labels(language: str, text: str, at: tuple[int, int], lines: list[int]) -> None:
    with Inside() as inside:
        inside.open("untitled:x", text, language)
        found = ask(inside, "linkedEditingRange", position={"line": at[0], "character": at[1]})
        assert [each["start"]["line"] for each in (found or {"ranges": []})["ranges"]] == lines


def look_up(inside: Inside, uri: str, line: int) -> Any:
    arguments = [{"uri": uri, "position": {"line": line, "character": 0}}]
    return inside.request("workspace/executeCommand", {"command": "deburr.sourceMap", "arguments": arguments})


def test_from_a_source_line_to_its_flat_lines_and_back(tmp_path: Path) -> None:
    main = (tmp_path / "main.ngc").as_uri()
    with Inside() as inside:
        inside.open(main, "G21 G90\no1 repeat [2]\nG0 X1\nG0 X2\no1 endrepeat\nM2\n", "rs274")
        there = look_up(inside, main, 3)
        assert there["uri"] == f"deburr-expanded:{tmp_path}/main.ngc"
        rows = [each["range"]["start"]["line"] for each in there["ranges"]]
        assert len(rows) == 2
        back = look_up(inside, there["uri"], rows[1])
        assert back["uri"] == main
        assert back["ranges"][0]["range"]["start"]["line"] == 3
        assert [(each["kind"], each["number"], each["row"]) for each in back["ranges"][0]["frames"]] == [("loop", 2, 1)]
        assert look_up(inside, there["uri"], 999)["ranges"] == []
        bad = {"command": "deburr.sourceMap", "arguments": [{"uri": main}]}
        assert inside.request("workspace/executeCommand", bad)["code"] == -32602
