"""What a session says besides its answers: progress of whole-workspace checks, traces, its log; and which language a file is taken for."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from support.inside import Inside

FAULTY = "G21 G90\nG1 X1 (a (b)\nM2\n"
PULLS: dict[str, Any] = {"textDocument": {"diagnostic": {}}}


def folder_of(path: Path) -> dict[str, Any]:
    return {"workspaceFolders": [{"uri": path.as_uri(), "name": "here"}]}


def progress(inside: Inside, token: str) -> list[Any]:
    """What was said under a token, taken away."""
    found = [each["params"]["value"] for each in inside.said if each.get("params", {}).get("token") == token]
    inside.said = [each for each in inside.said if each.get("params", {}).get("token") != token]
    return found


def test_the_check_of_a_workspace_shows_how_far_it_is(tmp_path: Path) -> None:
    for number in range(3):
        (tmp_path / f"{number}.ngc").write_text(FAULTY)
    with Inside(PULLS, **folder_of(tmp_path)) as inside:
        ask = {"previousResultIds": [], "workDoneToken": "work"}
        assert len(inside.request("workspace/diagnostic", ask)["items"]) == 3
        first, *between, last = progress(inside, "work")
        assert (first["kind"], first["title"], first["cancellable"]) == ("begin", "Checking the workspace", True)
        assert last == {"kind": "end"}
        assert all(each["kind"] == "report" and "of 3" in each["message"] for each in between)
        assert inside.request("workspace/diagnostic", {"previousResultIds": []})["items"]
        assert not inside.said


def test_the_check_of_a_workspace_is_handed_over_in_parts_if_that_is_wanted(tmp_path: Path) -> None:
    for number in range(3):
        (tmp_path / f"{number}.ngc").write_text(FAULTY)
    with Inside(PULLS, **folder_of(tmp_path)) as inside:
        gone = [{"uri": (tmp_path / "gone.ngc").as_uri(), "value": "x"}]
        ask = {"previousResultIds": gone, "partialResultToken": "part"}
        rest = inside.request("workspace/diagnostic", ask)["items"]
        assert [(each["uri"], each["items"]) for each in rest] == [(gone[0]["uri"], [])]
        parts = [each["items"] for each in progress(inside, "part")]
        assert [len(each) for each in parts] == [1, 1, 1]
        assert [item["code"] for each in parts for item in each[0]["items"]] == ["rs274.comment-nested"] * 3


def test_the_check_of_a_workspace_can_be_cancelled(tmp_path: Path) -> None:
    for number in range(30):
        (tmp_path / f"{number}.ngc").write_text(FAULTY * 200)
    with Inside(PULLS, **folder_of(tmp_path)) as inside:
        number = inside.begin("workspace/diagnostic", {"previousResultIds": [], "workDoneToken": "work"})
        inside.wait(lambda each: each.get("params", {}).get("token") == "work")
        inside.notify("window/workDoneProgress/cancel", {"token": "work"})
        answer = inside.wait(lambda each: each.get("id") == number and "method" not in each)
        assert answer["error"]["code"] == -32800
        inside.wait(lambda each: each.get("params", {}).get("value") == {"kind": "end"})


@pytest.mark.parametrize(
    ("trace", "messages", "verbose"), [("off", False, False), ("messages", True, False), ("verbose", True, True)]
)
def test_what_is_done_is_traced_as_the_client_wants(trace: str, messages: bool, verbose: bool) -> None:
    ask = {"textDocument": {"uri": "untitled:x"}, "position": {"line": 0, "character": 1}}
    for start, later in ((trace, None), ("off", trace)):
        with Inside(trace=start) as inside:
            if later is not None:
                inside.notify("$/setTrace", {"value": later})
            inside.said.clear()
            inside.open("untitled:x", "G1 X1\n", "rs274")
            inside.request("textDocument/hover", ask)
            said = [each["params"] for each in inside.said if each.get("method") == "$/logTrace"]
            told = [each["message"].partition(" took ")[0] for each in said]
            assert told == (["textDocument/didOpen", "textDocument/hover"] if messages else [])
            assert all(("verbose" in each) is verbose for each in said)


def test_the_log_tells_how_the_session_began_and_what_is_no_program(tmp_path: Path) -> None:
    with Inside(**folder_of(tmp_path)) as inside:
        inside.notify("initialized", {})
        inside.open("untitled:letter", "Dear Sir,\n", "plaintext")
        said = [each["params"] for each in inside.said if each.get("method") == "window/logMessage"]
        assert [each["type"] for each in said] == [3, 4]
        assert "columns in utf-16" in said[0]["message"]
        assert str(tmp_path) in said[0]["message"]
        assert said[1]["message"].startswith("untitled:letter: ")


@pytest.mark.parametrize(
    ("name", "text", "dialect", "reason"),
    [
        ("a.ngc", "G1\n", "rs274", "the extension .ngc"),
        ("a.nc", "#IF1 |a| equalto 1 n\n#ENDIF1\n", "metagcode", "#IF"),
        ("a.nc", "(deburr: dialect=z32)\n", "z32", "modeline"),
        ("a.nc", "G1 X1\n", None, ""),
        ("a.txt", "@LINE\nX#XPOS\n@\n", "cgt", "@"),
    ],
)
def test_which_language_a_file_is_taken_for(
    tmp_path: Path, name: str, text: str, dialect: str | None, reason: str
) -> None:
    """The same for a file that is open and for one that is on disk alone."""
    path = tmp_path / name
    path.write_text(text)
    with Inside() as inside:
        closed = explained(inside, path.as_uri())
        inside.open(path.as_uri(), text, "plaintext")
        assert explained(inside, path.as_uri()) == closed
        assert closed["dialect"] == dialect
        assert reason in closed["reason"]
        assert closed["reason"]
        assert explained(inside, (tmp_path / "none").as_uri())["reason"] == "there is no such file"


def explained(inside: Inside, uri: str) -> Mapping[str, Any]:
    found: Mapping[str, Any] = inside.request(
        "workspace/executeCommand", {"command": "deburr.explainDialect", "arguments": [{"uri": uri}]}
    )
    return found
