"""What stands around a program: files that it names, configuration, settings, folders, the language it is taken for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from deburr.lsp.client import client_of
from support.inside import Inside

MAIN = "#FILE part\nG0 X0\n"


def uri_of(folder: Path, name: str) -> str:
    return (folder / name).as_uri()


def inside(folder: Path, capabilities: dict[str, Any] | None = None, **params: Any) -> Inside:
    """A server with a folder."""
    return Inside(capabilities, workspaceFolders=[{"uri": folder.as_uri(), "name": "here"}], **params)


def changed(server: Inside, *paths: Path) -> None:
    """What a client says that watches files."""
    server.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": path.as_uri(), "type": 2} for path in paths]})


def test_a_program_is_checked_again_when_a_file_that_it_names_comes_and_goes(tmp_path: Path) -> None:
    main = uri_of(tmp_path, "main.mgc")
    part = tmp_path / "Snippets" / "part"
    with inside(tmp_path) as server:
        server.open(main, MAIN, "metagcode")
        assert server.pushed(main) == ["metagcode.file-missing"]
        part.parent.mkdir()
        part.write_text("G1 X1\n")
        changed(server, part)
        assert server.pushed(main) == []
        part.unlink()
        changed(server, part)
        assert server.pushed(main) == ["metagcode.file-missing"]


def test_an_open_buffer_is_read_before_the_disk(tmp_path: Path) -> None:
    main, part = uri_of(tmp_path, "main.mgc"), uri_of(tmp_path, "Snippets/part")
    (tmp_path / "Snippets").mkdir()
    (tmp_path / "Snippets" / "part").write_text("G1 X1\n")
    with inside(tmp_path) as server:
        server.open(main, MAIN, "metagcode")
        assert server.pushed(main) == []
        server.open(part, "#IF1 |a| GreaterThan 0 number\n", "metagcode")
        assert server.pushed(main) != []
        server.notify("textDocument/didClose", {"textDocument": {"uri": part}})
        assert server.pushed(main) == []


def test_configuration_is_read_again_when_it_changes(tmp_path: Path) -> None:
    main, config = uri_of(tmp_path, "a.ngc"), tmp_path / "deburr.toml"
    with inside(tmp_path) as server:
        server.open(main, "G21 G90\nG1 X1 (a (b)\nM2\n", "rs274")
        assert "rs274.comment-nested" in server.pushed(main)
        config.write_text('[check]\nignore = ["rs274"]\n')
        changed(server, config)
        assert server.pushed(main) == []
        config.write_text("[check]\nignor = []\n")
        changed(server, config)
        assert "rs274.comment-nested" in server.pushed(main)
        (said,) = (each["params"] for each in server.said if each.get("method") == "window/showMessage")
        assert "unknown key `ignor`" in said["message"]
        assert f"{config}:2" in said["message"]


def test_the_editors_settings_lie_over_the_file(tmp_path: Path) -> None:
    main = uri_of(tmp_path, "a.ngc")
    (tmp_path / "deburr.toml").write_text('[check]\nselect = ["rs274.comment-nested"]\n')
    options = {"check": {"severity": {"rs274.comment-nested": "info"}}}
    with inside(tmp_path, initializationOptions=options) as server:
        server.open(main, "G21 G90\nG1 X1 (a (b)\nM2\n", "rs274")
        assert server.pushed(main) == ["rs274.comment-nested"]
        sent = [each for each in server.said if each.get("method") == "textDocument/publishDiagnostics"]
        assert sent[-1]["params"]["diagnostics"][0]["severity"] == 3
        settings = {"deburr": {"check": {"ignore": ["rs274.comment-nested"]}}}
        server.notify("workspace/didChangeConfiguration", {"settings": settings})
        assert server.pushed(main) == []
        server.notify("workspace/didChangeConfiguration", {"settings": {"check": {"selct": []}}})
        assert server.pushed(main) == ["rs274.comment-nested"]
        assert any("did you mean `select`" in str(each) for each in server.said)


@pytest.mark.parametrize(
    ("name", "language", "text", "dialect"),
    [
        ("a.ngc", "plaintext", "G1 X1 (a (b)\n", "rs274"),
        ("a.txt", "z32", "(PROGRAM)\nN10 G1 X\n", "z32"),
        ("a.nc", "gcode", "o1 sub\no1 endsub\nM2\n", "rs274"),
        ("a.nc", "gcode", "G1 X1\nM30\n", None),
        ("a.xyz", "plaintext", "(deburr: dialect=z32)\nG1\n", "z32"),
        ("a.nc", "", "(deburr: dialect=cgt)\n", "cgt"),
    ],
)
def test_which_language_a_text_is_taken_for(
    tmp_path: Path, name: str, language: str, text: str, dialect: str | None
) -> None:
    with inside(tmp_path) as server:
        server.open(uri_of(tmp_path, name), text, language)
        view = server.server.session.open[uri_of(tmp_path, name)].view
        assert (None if view is None else view.dialect.name) == dialect


def test_a_text_that_is_no_program_becomes_one_when_it_says_so(tmp_path: Path) -> None:
    main = uri_of(tmp_path, "a.nc")
    with inside(tmp_path) as server:
        server.open(main, "G1 X1 (a (b)\n", "gcode")
        assert server.pushed(main) == []
        start = {"line": 0, "character": 0}
        change = {"range": {"start": start, "end": start}, "text": "(deburr: dialect=rs274)\n"}
        server.notify(
            "textDocument/didChange", {"textDocument": {"uri": main, "version": 2}, "contentChanges": [change]}
        )
        server.notify("textDocument/didSave", {"textDocument": {"uri": main}})
        assert "rs274.comment-nested" in server.pushed(main)


def test_a_client_that_asks_is_told_when_to_ask_again(tmp_path: Path) -> None:
    asks = {"textDocument": {"diagnostic": {}}, "workspace": {"diagnostics": {"refreshSupport": True}}}
    with inside(tmp_path, asks) as server:
        server.open(uri_of(tmp_path, "main.mgc"), MAIN, "metagcode")
        server.settle()
        server.said.clear()
        (tmp_path / "Snippets").mkdir()
        (tmp_path / "Snippets" / "part").write_text("G1 X1\n")
        changed(server, tmp_path / "Snippets" / "part")
        server.settle()
        assert [each["method"] for each in server.said] == ["workspace/diagnostic/refresh"]


def test_hints_and_lenses_are_asked_for_again_when_what_they_hang_on_changes(tmp_path: Path) -> None:
    main, values = uri_of(tmp_path, "main.mgc"), tmp_path / "part.vars"
    values.write_text("Depth=10\n")
    refreshes = {"workspace": {kind: {"refreshSupport": True} for kind in ("codeLens", "inlayHint")}}
    options = {"metagcode": {"variables": str(values)}}
    ask = {
        "textDocument": {"uri": main},
        "range": {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}},
    }
    with inside(tmp_path, refreshes, initializationOptions=options) as server:
        server.open(main, "#LOOP1 |Depth| 5 c\nZ|Depth|\n#ENDLOOP1\n", "metagcode")
        server.settle()
        (hint,) = server.request("textDocument/inlayHint", ask)
        assert hint["label"] == "2 passes, step 5"
        server.said.clear()
        values.write_text("Depth=15\n")
        changed(server, values)
        server.settle()
        asked = {each["method"] for each in server.said if "id" in each}
        assert asked == {"workspace/codeLens/refresh", "workspace/inlayHint/refresh"}
        (hint,) = server.request("textDocument/inlayHint", ask)
        assert hint["label"] == "3 passes, step 5"


def test_a_workspace_of_several_folders(tmp_path: Path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "a.ngc").write_text("G1 X1 (a (b)\n")
    folders = [{"uri": (tmp_path / name).as_uri(), "name": name} for name in ("one", "two")]
    with Inside({"textDocument": {"diagnostic": {}}}, workspaceFolders=folders[:1]) as server:
        ask = {"previousResultIds": []}
        assert len(server.request("workspace/diagnostic", ask)["items"]) == 1
        server.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": folders[1:], "removed": []}})
        assert len(server.request("workspace/diagnostic", ask)["items"]) == 2
        server.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [], "removed": folders}})
        assert server.request("workspace/diagnostic", ask)["items"] == []


def test_what_a_client_says_of_itself_need_not_be_as_it_should() -> None:
    assert client_of(None) == client_of({}) == client_of({"capabilities": 7, "workspaceFolders": "x", "processId": "y"})
    odd = {"capabilities": {"general": {"positionEncodings": ["utf-7", "utf-8"]}}, "rootUri": "file:///a"}
    assert client_of(odd).encoding == "utf-8"
    assert client_of(odd).folders == ("file:///a",)
