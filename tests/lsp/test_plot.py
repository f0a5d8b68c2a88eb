"""Toolpaths in the editor: the moves of the page, in chunks, of what is in the buffers, and never in the way of a keystroke."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

import pytest

from deburr.cli.main import main
from deburr.plot import columns
from support.client import Client
from support.inside import Inside
from support.plots import data_of, rows, unpacked, unpacked_text

EXAMPLES = Path(__file__).parents[2] / "examples"
VARIABLES = dict(
    line.split("=", 1)
    for line in (EXAMPLES / "metagcode" / "pocket.vars").read_text().splitlines()
    if "=" in line and not line.startswith("#")
)
PROGRAMS = {
    "rs274": ("bolt_circle.ngc", {}),
    "metagcode": ("pocket.mgc", {"define": VARIABLES}),
    "cgt": ("mill.cgt", {"input": EXAMPLES / "cgt" / "mill.cl", "define": {"DATE": "1/6", "SYSTIME": "9:30"}}),
    "z32": ("pocket.z32", {}),
}
LOOP = "G21 G90 F100\n#<n> = 0\no1 while [#<n> LT 3]\n  G1 X[#<n> * 10 + 1]\n  #<n> = [#<n> + 1]\no1 endwhile\nM2\n"


def plot(inside: Inside, uri: str, **more: Any) -> Any:
    return inside.request("workspace/executeCommand", {"command": "deburr.plot", "arguments": [{"uri": uri, **more}]})


@pytest.mark.parametrize("dialect", PROGRAMS)
def test_the_editor_and_the_page_are_given_the_same(dialect: str, tmp_path: Path) -> None:
    name, given = PROGRAMS[dialect]
    program = EXAMPLES / dialect / name
    words: list[str] = []
    arguments: dict[str, Any] = {}
    if "input" in given:
        words += ["--input", str(given["input"])]
        arguments["input"] = given["input"].as_uri()
    for key, value in given.get("define", {}).items():
        words += ["-D", f"{key}={value}"]
        arguments.setdefault("define", {})[key] = value
    assert main(["plot", "-q", str(program), *words, "-o", str(tmp_path / "page.html")]) == 0
    page = data_of((tmp_path / "page.html").read_text())
    with Inside() as inside:
        inside.open(program.as_uri(), program.read_text(), dialect)
        answer = plot(inside, program.as_uri(), **arguments)
    assert len(unpacked(answer["segments"]["columns"]["kind"])) == answer["header"]["moves"] > 5
    assert answer["segments"] == page["deburr-chunk-0"]
    assert (answer["chunk"], answer["chunks"], answer["truncated"]) == (0, 1, False)
    said, read = answer["header"], page["deburr-header"]
    assert [each["name"] for each in said.pop("sources")] == [each["name"] for each in read.pop("sources")]
    assert said == read


def test_moves_tell_the_line_and_the_pass_that_made_them() -> None:
    with Inside() as inside:
        inside.open("untitled:loop", LOOP, "rs274")
        answer = plot(inside, "untitled:loop")
        held = answer["segments"]["columns"]
        assert unpacked(held["line"]) == [3, 3, 3]
        assert [unpacked(held["frameNumber"])[frame] for frame in unpacked(held["frame"])] == [1, 2, 3]
        assert answer["header"]["sources"] == [{"name": "untitled:loop", "uri": "untitled:loop"}]


def test_chunks_of_one_stamp_are_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(columns, "CHUNK", 16)
    with Inside() as inside:
        inside.open("untitled:rows", rows(100), "rs274")
        first = plot(inside, "untitled:rows")
        assert first["chunks"] == 7
        answers = [
            first,
            *(plot(inside, "untitled:rows", chunk=number, stamp=first["stamp"]) for number in range(1, 7)),
        ]
        assert {each["stamp"] for each in answers} == {first["stamp"]}
        assert sum(len(unpacked(each["segments"]["columns"]["kind"])) for each in answers) == 100
        text = "".join(unpacked_text(each["segments"]["text"]) for each in answers)
        assert text == rows(100)
        assert "header" not in answers[1]


def test_behind_an_edit_the_chunks_of_before_are_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(columns, "CHUNK", 16)
    with Inside() as inside:
        inside.open("untitled:rows", rows(100), "rs274")
        first = plot(inside, "untitled:rows")
        document = {"uri": "untitled:rows", "version": 2}
        inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": rows(20)}]})
        later = plot(inside, "untitled:rows", chunk=6, stamp=first["stamp"])
        assert later["segments"] is None and later["stamp"] != first["stamp"] and later["chunks"] == 2


def test_a_faulty_program_has_findings_and_no_segments() -> None:
    with Inside() as inside:
        inside.open("untitled:bad", "G21 G0 X1\n#1 = [2 - 2]\nG0 X[5 / #1]\nM2\n", "rs274")
        answer = plot(inside, "untitled:bad")
        assert answer["segments"] is None
        assert [each["code"] for each in answer["findings"]] == ["rs274.divide-by-zero"]


@pytest.mark.parametrize("wrong", [{"chunk": -1}, {"chunk": "1"}, {"chunk": 1}, {"stamp": True}, {"nonsense": 1}])
def test_arguments_that_mean_nothing_are_refused(wrong: dict[str, Any]) -> None:
    with Inside() as inside:
        inside.open("untitled:loop", LOOP, "rs274")
        assert plot(inside, "untitled:loop", **wrong)["code"] == -32602


def test_the_configured_machine_is_followed(tmp_path: Path) -> None:
    (tmp_path / "deburr.toml").write_text('[machine]\nunit = "inch"\n')
    uri = (tmp_path / "inch.ngc").as_uri()
    with Inside() as inside:
        inside.open(uri, "G90 F10\nG0 X2\nM2\n", "rs274")
        assert plot(inside, uri)["header"]["bounds"]["all moves"][1] == [50.8, 0, 0]


def test_what_is_no_program_has_no_toolpath() -> None:
    with Inside() as inside:
        assert plot(inside, "untitled:none") is None


def test_a_message_waits_for_no_more_than_a_slice() -> None:
    """As for flat programs: while a long one is followed and told in chunks, the loop looks at messages between."""
    slices: list[float] = []

    async def looking(inside: Inside, number: int) -> None:
        while not [each for each in inside.said if each.get("id") == number]:
            started = time.thread_time()
            await asyncio.sleep(0)
            slices.append(time.thread_time() - started)

    with Inside() as inside:
        inside.open("untitled:rows", rows(30_000), "rs274")
        argument = {"uri": "untitled:rows"}
        number = inside.begin("workspace/executeCommand", {"command": "deburr.plot", "arguments": [argument]})
        inside.loop.run_until_complete(looking(inside, number))
    assert len(slices) > 20
    assert median(slices) < 0.025


def test_it_is_a_command_of_the_server_in_a_process_of_its_own(launch: Callable[..., Client]) -> None:
    client = launch()
    answer = client.start({})
    assert "deburr.plot" in answer["capabilities"]["executeCommandProvider"]["commands"]
    uri = client.open("loop.ngc", LOOP, "rs274")
    number = client.ask("workspace/executeCommand", {"command": "deburr.plot", "arguments": [{"uri": uri}]})
    assert client.result(number)["header"]["moves"] == 3
    assert client.stop() == 0
