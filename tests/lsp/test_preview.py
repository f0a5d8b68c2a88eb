"""Flat programs in the editor: the same bytes as on the command line, of what is in the buffers, and never in the way of a keystroke."""

from __future__ import annotations

import asyncio
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

from deburr.cli.main import main
from deburr.lsp.features.expansion import source_of
from deburr_grammar.dialects import NAMES
from support.cases import Case, cases
from support.client import PUSHED, Client, edit
from support.inside import Inside

PLAIN = {"define"}
"""Inputs that the command has as well; cases with others are the command line's."""


def usable(case: Case) -> bool:
    return set(tomllib.loads(case.parts.get("inputs", ""))) <= PLAIN


CASES = [pytest.param(case, id=f"{name}-{case.name}") for name in NAMES for case in cases(name) if usable(case)]


def written(case: Case, folder: Path) -> Path:
    """The files of a case on disk; the path of its program."""
    for name, text in case.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    if settings := case.parts.get("settings"):
        (folder / "deburr.toml").write_text(f"[{case.dialect}]\n{settings}")
    return folder / next(iter(case.files))


def expand(inside: Inside, uri: str, **more: Any) -> Any:
    return inside.request("workspace/executeCommand", {"command": "deburr.expand", "arguments": [{"uri": uri, **more}]})


@pytest.mark.parametrize("case", CASES)
def test_one_program_one_text(case: Case, tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    path = written(case, tmp_path)
    define = tomllib.loads(case.parts.get("inputs", "")).get("define", {})
    given = [argument for name, value in define.items() for argument in ("-D", f"{name}={value}")]
    main(["expand", "-q", "--dialect", case.dialect, *given, str(path)])
    flat = capfdbinary.readouterr().out.decode()
    with Inside() as inside:
        inside.open(path.as_uri(), path.read_bytes().decode(), case.dialect)
        assert expand(inside, path.as_uri(), define=define)["text"] == flat
        if not define:
            content = {"uri": f"deburr-expanded:{quote(str(path))}"}
            assert inside.request("workspace/textDocumentContent", content)["text"] == flat


def test_a_snippet_that_is_not_saved_yet_is_in_the_preview(tmp_path: Path) -> None:
    main_file, part = (tmp_path / "main.mgc").as_uri(), (tmp_path / "Snippets" / "part").as_uri()
    (tmp_path / "Snippets").mkdir()
    (tmp_path / "Snippets" / "part").write_text("G1 X1\n")
    with Inside() as inside:
        inside.open(main_file, "#FILE part\nM30\n", "metagcode")
        assert expand(inside, main_file)["text"] == "G1 X1\nM30\n"
        inside.open(part, "G1 X2\n", "metagcode")
        found = expand(inside, main_file)
        assert found["text"] == "G1 X2\nM30\n"
        assert found["sourceMap"]["sources"] == [part, main_file]
        assert (found["findings"], found["truncated"]) == ([], False)


def test_what_is_wrong_is_said_instead() -> None:
    with Inside() as inside:
        inside.open("untitled:x", "#LOOP1 |a| 5 c\nG1 X|a|\n", "metagcode")
        found = expand(inside, "untitled:x")
        assert found["text"] == ""
        assert found["findings"]
        assert expand(inside, "untitled:none") is None


def test_a_limit_cuts_and_says_so() -> None:
    with Inside() as inside:
        inside.open("untitled:x", "#1=0\no1 while [#1 LT 100]\nG0 X#1\n#1=[#1+1]\no1 endwhile\nM2\n", "rs274")
        found = expand(inside, "untitled:x", maxBlocks=3)
        assert found["truncated"] is True
        assert found["text"].count("\n") == 3


@pytest.mark.parametrize(
    ("uri", "source"),
    [
        ("deburr-expanded:/a/b%20c.ngc", "file:///a/b%20c.ngc"),
        ("deburr-expanded:untitled:Untitled-1", "untitled:Untitled-1"),
    ],
)
def test_whose_flat_form_a_uri_means(uri: str, source: str) -> None:
    assert source_of(uri) == source


def test_an_edit_while_it_runs_makes_the_preview_that_of_the_new_text() -> None:
    loop = "#1=0\no1 while [#1 LT 3000]\n#1=[#1+1]\no1 endwhile\nG0 X1\nM2\n"
    with Inside() as inside:
        inside.open("untitled:x", loop, "rs274")
        inside._number += 1
        inside._send({
            "id": inside._number,
            "method": "workspace/executeCommand",
            "params": {"command": "deburr.expand", "arguments": [{"uri": "untitled:x"}]},
        })  # fmt: skip
        change = edit(4, 0, 5, "G0 X2")
        said = {"textDocument": {"uri": "untitled:x", "version": 2}, "contentChanges": [change]}
        inside.notify("textDocument/didChange", said)
        while not (found := [each for each in inside.said if each.get("id") == inside._number]):
            inside.loop.run_until_complete(asyncio.sleep(0.01))
        assert "G0 X2" in found[0]["result"]["text"]


def test_a_keystroke_is_answered_while_an_endless_program_runs(launch: Callable[..., Client]) -> None:
    client = launch()
    client.start(PUSHED)
    endless = client.open(
        "endless.ngc", "G21 G90\n#1=0\no1 while [#1 LT 100000000]\n#1=[#1+1]\no1 endwhile\nG0 X1\nM2\n", "rs274"
    )
    uri = client.open("typed.ngc", "G21 G90 G17\nG0 X1\nM2\n", "rs274")
    number = client.ask("workspace/executeCommand", {"command": "deburr.expand", "arguments": [{"uri": endless}]})
    client.settle()
    for _ in range(5):
        client.change(uri, edit(1, 0, 0, "Q"))
        assert client.pushed(uri, bool)
        client.change(uri, edit(1, 0, 1, ""))
        assert client.pushed(uri, lambda found: not found) == []
    assert number not in client._answers
    client.notify("$/cancelRequest", {"id": number})
    assert client.stop() == 0
