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


LENSED = "o<s> sub\no<s> endsub\no<s> call\no<s> call\no1 repeat [2*3]\no1 endrepeat\nM2\n"


@pytest.mark.parametrize(
    ("off", "titles"),
    [
        ({}, ["Expand", "2 references", "6 passes"]),
        ({"expand": False}, ["2 references", "6 passes"]),
        ({"references": False}, ["Expand", "6 passes"]),
        ({"passes": False}, ["Expand", "2 references"]),
    ],
)
def test_lenses(off: dict[str, bool], titles: list[str]) -> None:
    with Inside(initializationOptions={"editor": {"code-lens": off}}) as inside:
        inside.open("untitled:x", LENSED, "rs274")
        found = [inside.request("codeLens/resolve", each) for each in ask(inside, "codeLens")]
        assert [each["command"]["title"] for each in found] == titles


def test_a_lens_counts_when_it_is_seen_and_shows_where_if_the_client_can() -> None:
    with Inside({"experimental": {"commands": {"commands": ["deburr.showReferences"]}}}) as inside:
        inside.open("untitled:x", LENSED, "rs274")
        (lens,) = (each for each in ask(inside, "codeLens") if "command" not in each)
        command = inside.request("codeLens/resolve", lens)["command"]
        uri, position, places = command["arguments"]
        assert (command["command"], uri, position) == (
            "deburr.showReferences",
            "untitled:x",
            {"line": 0, "character": 2},
        )
        assert [each["range"]["start"]["line"] for each in places] == [2, 3]
        assert inside.request("codeLens/resolve", {**lens, "data": 7}) == {**lens, "data": 7}


@pytest.mark.parametrize(
    ("off", "labels"),
    [
        ([], ["4 passes", "=6", "=Y", "=Z", "=G02"]),
        (["alias"], ["4 passes", "=6", "=G02"]),
        (["values"], ["4 passes", "=Y", "=Z", "=G02"]),
        (["passes"], ["=4", "=6", "=Y", "=Z", "=G02"]),
        (["rows"], ["4 passes", "=6", "=Y", "=Z"]),
    ],
)
def test_hints(off: list[str], labels: list[str]) -> None:
    options = {"editor": {"inlay-hints": dict.fromkeys(off, False)}}
    texts = {
        "rs274": "o1 repeat [2*2]\nG1 X[2*3]\no1 endrepeat\n",
        "z32": "(P)\nAA1\nG25YZX\nAA1 AB2\nM30\n",
        "cgt": "@LINE\n#EVAL(#MOV=2)\n@\n",
    }
    with Inside(initializationOptions=options) as inside:
        found = []
        for language, text in texts.items():
            inside.open(f"untitled:{language}", text, language)
            found += ask(inside, "inlayHint", f"untitled:{language}", range=ALL)
        assert [each["label"] for each in found] == labels


def test_hints_of_the_lines_that_are_seen_and_of_no_others() -> None:
    with Inside() as inside:
        inside.open("untitled:x", "(😋) X[2*3]\n" * 5, "rs274")
        seen = {"start": {"line": 1, "character": 0}, "end": {"line": 2, "character": 0}}
        found = ask(inside, "inlayHint", range=seen)
        assert [(each["position"]["line"], each["position"]["character"]) for each in found] == [(1, 11), (2, 11)]


def test_hints_and_lenses_are_switched_in_the_file_too(tmp_path: Path) -> None:
    (tmp_path / "deburr.toml").write_text("[editor.inlay-hints]\nvalues = false\n[editor.code-lens]\nexpand = false\n")
    uri = (tmp_path / "a.ngc").as_uri()
    with Inside() as inside:
        inside.open(uri, "G1 X[2*3]\n", "rs274")
        assert ask(inside, "inlayHint", uri, range=ALL) == []
        assert ask(inside, "codeLens", uri) == []


def test_who_calls_what(tmp_path: Path) -> None:
    main, other = (tmp_path / "main.ngc").as_uri(), tmp_path / "x.ngc"
    other.write_text("o<x> sub\no<x> endsub\n")
    folders = [{"uri": tmp_path.as_uri(), "name": "here"}]
    with Inside(workspaceFolders=folders) as inside:
        inside.open(main, "o<s> sub\n(😋) G0\no<x> call\no<s> endsub\no<x> call\nM2\n", "rs274")
        (item,) = ask(inside, "prepareCallHierarchy", main, position={"line": 4, "character": 3})
        assert (item["name"], item["uri"], item["range"]["end"]["line"]) == ("x", other.as_uri(), 1)
        callers = inside.request("callHierarchy/incomingCalls", {"item": item})
        found = {each["from"]["name"]: [place["start"]["line"] for place in each["fromRanges"]] for each in callers}
        assert found == {"s": [2], "main.ngc": [4]}
        whole = next(each["from"] for each in callers if each["from"]["name"] == "main.ngc")
        called = inside.request("callHierarchy/outgoingCalls", {"item": whole})
        assert [(each["to"]["name"], each["fromRanges"][0]["start"]["line"]) for each in called] == [("x", 4)]
        nowhere = {"textDocument": {"uri": "untitled:no"}, "position": {"line": 0, "character": 0}}
        assert inside.request("textDocument/prepareCallHierarchy", nowhere) is None


@pytest.mark.parametrize(
    ("language", "text", "at", "lines"),
    [
        ("rs274", "o1 if [1]\no1 else\no1 endif\n", (0, 1), [0, 1, 2]),
        ("metagcode", "#IF1 |a| EqualTo 1 n\n#IF2 |a| EqualTo 1 n\n#ENDIF2\n#ENDIF1\n", (3, 7), [0, 3]),
        ("metagcode", "#IF1 |a| EqualTo 1 n\n#ENDIF1\n", (0, 1), []),
        ("rs274", "o<a> repeat [2]\nG0\no<a> endrepeat\n", (2, 3), [0, 2]),
        ("rs274", "o<s> sub\no1 if [1]\no1 endif\no<s> endsub\no1 if [1]\no1 endif\n", (4, 2), [4, 5]),
        ("metagcode", "#LOOP7 |a| 1 c\n#ENDLOOP7\n", (0, 6), [0, 1]),
        ("metagcode", "#LOOP7 |a| 1 c\n#ENDLOOP8\n", (0, 6), []),
        ("rs274", "G1 X1\n", (0, 1), []),
    ],
)
def test_linked_labels(language: str, text: str, at: tuple[int, int], lines: list[int]) -> None:
    with Inside() as inside:
        inside.open("untitled:x", text, language)
        found = ask(inside, "linkedEditingRange", position={"line": at[0], "character": at[1]})
        assert [each["start"]["line"] for each in (found or {"ranges": []})["ranges"]] == lines


def look_up(inside: Inside, uri: str, line: int, **more: Any) -> Any:
    arguments = [{"uri": uri, "position": {"line": line, "character": 0}, **more}]
    return inside.request("workspace/executeCommand", {"command": "deburr.sourceMap", "arguments": arguments})


def whole(line: int, length: int) -> Any:
    return {"start": {"line": line, "character": 0}, "end": {"line": line, "character": length}}


def test_from_a_source_line_to_its_flat_lines_and_back(tmp_path: Path) -> None:
    main = (tmp_path / "main.ngc").as_uri()
    with Inside() as inside:
        inside.open(main, "G21 G90\no1 repeat [2]\nG0 X1\n(😋) G0 X2\no1 endrepeat\nM2\n", "rs274")
        there = look_up(inside, main, 3)
        assert there["uri"] == f"deburr-expanded:{tmp_path}/main.ngc"
        # The flat program: G21 G90, X1, X2, X1, X2, M2; the smile has two units.
        assert [each["range"] for each in there["ranges"]] == [whole(2, 10), whole(4, 10)]
        assert [[frame["number"] for frame in each["frames"]] for each in there["ranges"]] == [[1], [2]]
        back = look_up(inside, there["uri"], 4)
        assert back["uri"] == main
        (origin,) = back["ranges"]
        assert origin["range"] == whole(3, 10)
        assert [(each["kind"], each["number"], each["uri"], each["range"]) for each in origin["frames"]] == [
            ("loop", 2, main, whole(1, 13))
        ]
        assert look_up(inside, there["uri"], 999)["ranges"] == []
        assert look_up(inside, main, 4)["ranges"] == []
        bad = {"command": "deburr.sourceMap", "arguments": [{"uri": main}]}
        assert inside.request("workspace/executeCommand", bad)["code"] == -32602


@pytest.mark.parametrize(
    ("language", "name", "text", "part", "part_text", "line", "flat", "frames"),
    [
        ("metagcode", "main.mgc", "#FILE part\nG0\n#FILE part\n", "Snippets/part", "G1 X1\nG1 X2\n", 1, [1, 4], [["file"], ["file"]]),
        ("rs274", "main.ngc", "G21 G90\no<s> call\no<s> call\nM2\n", "s.ngc", "o<s> sub\nG0 X1\no<s> endsub\n", 1, [1, 2], [["call"], ["call"]]),
        ("z32", "main.z32", "(P)\n!:L254-A!\nX<PI>\nM30\n", "root/A.z32", "G1 X1\nG26\n", 0, [1], [["file"]]),
    ],
)  # fmt: skip
def test_from_a_line_of_a_snippet_or_subprogram_to_the_flat_lines_of_its_program(
    tmp_path: Path, language: str, name: str, text: str, part: str, part_text: str, line: int, flat: list[int], frames: list[list[str]]
) -> None:  # fmt: skip
    main, other = (tmp_path / name).as_uri(), tmp_path / part
    other.parent.mkdir(exist_ok=True)
    other.write_text(part_text)
    with Inside(initializationOptions={"z32": {"file-root": str(tmp_path / "root")}}) as inside:
        inside.open(main, text, language)
        asked = look_up(inside, other.as_uri(), line, program=main)
        assert asked["uri"] == f"deburr-expanded:{tmp_path}/{name}"
        assert [each["range"]["start"]["line"] for each in asked["ranges"]] == flat
        assert [[frame["kind"] for frame in each["frames"]] for each in asked["ranges"]] == frames
        assert look_up(inside, other.as_uri(), line) == asked, "it was expanded last"
        back = look_up(inside, asked["uri"], flat[0])
        assert (back["uri"], back["ranges"][0]["range"]["start"]["line"]) == (other.as_uri(), line)


def test_from_a_template_to_what_it_printed(tmp_path: Path) -> None:
    (tmp_path / "a.cl").write_text("GOTO/1,2,3\nGOTO/4,5,6\nFINI\n")
    (tmp_path / "deburr.toml").write_text('[cgt]\ninput = "a.cl"\n')
    text = "@START\n%\n@\n@LINE\nG1 X#XPOS\n@\n@RAP\nG0 X#XPOS\n@\n@END\nM30\n@\n@ARC\n@\n@TOOLCHG\n@\n"
    main = (tmp_path / "main.cgt").as_uri()
    with Inside() as inside:
        inside.open(main, text, "cgt")
        there = look_up(inside, main, 10)
        (flat,) = there["ranges"]
        assert [each["kind"] for each in flat["frames"]] == ["section"]
        back = look_up(inside, there["uri"], flat["range"]["start"]["line"])
        assert back["ranges"][0]["range"] == whole(10, 3)
