"""Flat programs in the editor: the same bytes as on the command line, of what is in the buffers, and never in the way of a keystroke."""

from __future__ import annotations

import asyncio
import json
import re
import time
import tomllib
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any
from urllib.parse import quote

import pytest
from benchmarks.editor import Clock

from deburr.cli.main import main
from deburr.lsp.idle import SLICE
from deburr.lsp.previews import wanted_of
from deburr_grammar.dialects import NAMES
from support.cases import Case, cases
from support.client import PUSHED, Client, Refused, edit
from support.inside import Inside

OPTIONS = {
    "block-delete": lambda value: (
        ["--block-delete", "on" if value else "off"],
        {"blockDelete": "on" if value else "off"},
    ),
    "simulate": lambda value: (["--machine-values", "simulate"], {"machineValues": "simulate"}),
    "keep-n": lambda value: (["--keep-n"], {"keepN": True}),
    "decimals": lambda value: (["--decimals", str(value)], {"decimals": value}),
    "reached-only": lambda value: (["--reached-only"], {"reachedOnly": True}),
    "steps": lambda value: (["--max-steps", str(value)], {"maxSteps": value}),
    "blocks": lambda value: (["--max-blocks", str(value)], {"maxBlocks": value}),
    "define": lambda value: ([part for each in value.items() for part in ("-D", "=".join(each))], {"define": value}),
}
"""How the command line and the command of the editor are given an input of a case."""
FLAG = re.compile(r"(?<![\w-])(--[a-z]|-D )")
"""What only the command line has."""
CASES = [pytest.param(case, id=f"{name}-{case.name}") for name in NAMES for case in cases(name)]


def written(case: Case, folder: Path) -> list[Path]:
    """The files of a case on disk; the paths of its programs."""
    for name, text in case.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    if settings := case.parts.get("settings"):
        (folder / "deburr.toml").write_text(f"[{case.dialect}]\n{settings}")
    names = tomllib.loads(case.parts.get("inputs", "")).get("programs", [next(iter(case.files))])
    return [folder / name for name in names]


def given(case: Case) -> tuple[list[str], dict[str, Any]]:
    """The inputs of a case, for the command line and for the editor's command."""
    words: list[str] = []
    arguments: dict[str, Any] = {}
    for name, value in tomllib.loads(case.parts.get("inputs", "")).items():
        if name != "programs":
            more, argument = OPTIONS[name](value)
            words, arguments = [*words, *more], arguments | argument
    return words, arguments


def expand(inside: Inside, uri: str, **more: Any) -> Any:
    return inside.request("workspace/executeCommand", {"command": "deburr.expand", "arguments": [{"uri": uri, **more}]})


@pytest.mark.parametrize("case", CASES)
def test_one_program_one_text(case: Case, tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    """What a budget cuts is written by the command line only if a part is wanted."""
    paths = written(case, tmp_path)
    words, arguments = given(case)
    first, *others = paths
    with Inside() as inside:
        inside.open(first.as_uri(), first.read_bytes().decode(), case.dialect)
        arguments |= {"with": [path.as_uri() for path in others]} if others else {}
        answer = expand(inside, first.as_uri(), **arguments)
        assert [found for found in answer["findings"] if FLAG.search(found["message"])] == []
        partial = ["--partial"] if answer["truncated"] else []
        main(["expand", "-q", "--dialect", case.dialect, *partial, *words, *map(str, paths)])
        flat = capfdbinary.readouterr().out.decode()
        assert answer["text"] == flat
        query = f"?{quote(json.dumps(arguments))}" if arguments else ""
        content = {"uri": f"deburr-expanded:{quote(str(first))}{query}"}
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
    ("dialect", "text", "arguments", "said"),
    [
        ("cgt", "@START\n%\n@END\n%\n", {}, "name one with the command's `input` (.cl or .jsonl), or as `input` under [cgt] in deburr.toml"),
        ("z32", "G0 X<HA>\nM2\n", {}, "set it first, or say `HA=...` in the command's `define`"),
        ("z32", "G0 X<PAL[300]>\nM2\n", {}, "the setting `pal` or `PAL[300]=...` in the command's `define` gives one"),
        ("z32", "!HA=1!\nM2\n", {"define": {"HA": "x"}}, "`define`: HA=x: `x` is no number"),
        ("metagcode", "G0 X|a|\n", {}, "give it one with `a=...` in the command's `define`"),
        ("rs274", "o1 while [1]\nG4 P0\no1 endwhile\nM2\n", {"maxSteps": 9}, "the command's `maxSteps` sets another limit"),
        ("rs274", "G4 P0\nG4 P0\nM2\n", {"maxBlocks": 1}, "the command's `maxBlocks` sets another limit"),
        ("rs274", "#1=0\n/#1=1\nG0 X#1\nM2\n", {}, "say `on` or `off` in the command's `blockDelete`"),
    ],
)  # fmt: skip
def test_messages_name_what_the_editor_has(dialect: str, text: str, arguments: dict[str, Any], said: str) -> None:
    with Inside() as inside:
        inside.open("untitled:x", text, dialect)
        messages = [each["message"] for each in expand(inside, "untitled:x", **arguments)["findings"]]
        assert [message for message in messages if said in message], messages


@pytest.mark.parametrize(
    ("uri", "source"),
    [
        ("deburr-expanded:/a/b%20c.ngc", "file:///a/b%20c.ngc"),
        ("deburr-expanded:untitled:Untitled-1", "untitled:Untitled-1"),
    ],
)
def test_whose_flat_form_a_uri_means(uri: str, source: str) -> None:
    assert wanted_of(uri).uris == (source,)


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


ENDLESS = "G21 G90\n#1=0\no1 while [#1 LT 100000000]\n#1=[#1+1]\no1 endwhile\nG0 X1\nM2\n"


def test_a_keystroke_is_answered_while_an_endless_program_runs(launch: Callable[..., Client]) -> None:
    """As soon as without it, but for the slice of work that is under way: its time is that of the test below."""
    client = launch()
    client.start(PUSHED)
    endless = client.open("endless.ngc", ENDLESS, "rs274")
    uri = client.open("typed.ngc", "G21 G90 G17\nG0 X1\nM2\n", "rs274")
    client.pushed(uri)
    alone = waits(client, uri)
    argument = {"uri": endless, "maxSteps": 0}
    number = client.ask("workspace/executeCommand", {"command": "deburr.expand", "arguments": [argument]})
    client.settle()
    beside = waits(client, uri)
    assert number not in client._answers
    assert median(beside) < 5 * median(alone) + 0.025
    client.notify("$/cancelRequest", {"id": number})
    with pytest.raises(Refused) as refused:
        client.result(number)
    assert refused.value.code == -32800
    assert client.stop() == 0


def waits(client: Client, uri: str) -> list[float]:
    """Seconds of the server's processor from keystrokes to the diagnostics of the line; how long a busy machine lets it wait is not its doing."""
    found = []
    for _ in range(8):
        for text, end, wanted in (("Q", 0, bool), ("", 1, lambda items: not items)):
            time.sleep(0.05)
            clock = Clock(client)
            client.change(uri, edit(1, 0, end, text))
            client.pushed(uri, wanted)
            found.append(clock.taken().spent)
    return found


def test_a_message_waits_for_no_more_than_a_slice_of_a_run() -> None:
    """Processor time between two looks at the messages, while an endless program runs; 5 ms are the aim."""
    slices: list[float] = []

    async def looking(inside: Inside) -> None:
        for _ in range(300):
            started = time.thread_time()
            await asyncio.sleep(0)
            slices.append(time.thread_time() - started)

    with Inside() as inside:
        inside.open("untitled:x", ENDLESS, "rs274")
        number = inside.begin(
            "workspace/executeCommand",
            {"command": "deburr.expand", "arguments": [{"uri": "untitled:x", "maxSteps": 0}]},
        )
        inside.loop.run_until_complete(looking(inside))
        assert not [each for each in inside.said if each.get("id") == number]
        inside.notify("$/cancelRequest", {"id": number})
    assert median(slices) < 0.025
    # A look behind each short step would starve the thread that reads the messages.
    assert median(slices) > SLICE / 2


def refreshed(inside: Inside) -> list[str]:
    """The previews that the client is told to ask for again."""
    inside.settle()
    found = [
        each["params"]["uri"] for each in inside.said if each.get("method") == "workspace/textDocumentContent/refresh"
    ]
    inside.said.clear()
    return found


def typed(inside: Inside, uri: str, text: str, version: int) -> None:
    """The whole text is another."""
    document = {"uri": uri, "version": version}
    inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": text}]})


@pytest.mark.parametrize(
    ("language", "main_text", "name", "before", "after", "flat"),
    [
        ("metagcode", "#FILE part\nM30\n", "Snippets/part", "G1 X1\n", "G1 X{}\n", "G1 X{}\nM30\n"),
        ("rs274", "G21 G90\no<s> call\nM2\n", "s.ngc", "o<s> sub\nG0 X1\no<s> endsub\n", "o<s> sub\nG0 X{}\no<s> endsub\n", "G21 G90\nG0 X{}\nM2\n"),
        ("z32", "(P)\n!:L254-A!\nM30\n", "root/A.z32", "G1 X1\nG26\n", "G1 X{}\nG26\n", "(P)\nG1 X{}\nM30\n"),
    ],
)  # fmt: skip
def test_an_edit_that_is_not_saved_changes_the_preview_of_the_main_program(
    tmp_path: Path, language: str, main_text: str, name: str, before: str, after: str, flat: str
) -> None:
    program, part = tmp_path / f"main.{'mgc' if language == 'metagcode' else 'x'}", tmp_path / name
    part.parent.mkdir(exist_ok=True)
    part.write_text(before)
    options = {"z32": {"file-root": str(tmp_path / "root")}}
    with Inside({"workspace": {"textDocumentContent": {}}}, initializationOptions=options) as inside:
        inside.open(program.as_uri(), main_text, language)
        preview = f"deburr-expanded:{program}"
        ask = {"uri": preview}
        assert inside.request("workspace/textDocumentContent", ask)["text"] == flat.format(1)
        inside.open(part.as_uri(), before, language)
        assert refreshed(inside) == []
        typed(inside, part.as_uri(), after.format(2), 2)
        assert refreshed(inside) == [preview]
        assert inside.request("workspace/textDocumentContent", ask)["text"] == flat.format(2)
        assert expand(inside, program.as_uri())["text"] == flat.format(2)
        typed(inside, program.as_uri(), main_text + "(end)\n", 2)
        assert refreshed(inside) == [preview]
        inside.notify("textDocument/didClose", {"textDocument": {"uri": part.as_uri()}})
        assert refreshed(inside) == [preview]
        assert inside.request("workspace/textDocumentContent", ask)["text"].startswith(flat.format(1))
        inside.open("untitled:other", "G0\n", "rs274")
        assert refreshed(inside) == []


def test_a_new_snippet_that_was_never_saved_is_in_the_preview(tmp_path: Path) -> None:
    program, part = (tmp_path / "main.mgc").as_uri(), (tmp_path / "Snippets" / "part").as_uri()
    with Inside() as inside:
        inside.open(program, "#FILE part\n", "metagcode")
        assert [each["code"] for each in expand(inside, program)["findings"]] == ["metagcode.file-missing"]
        inside.open(part, "G1 X2\n", "metagcode")
        assert expand(inside, program)["text"] == "G1 X2\n"


def test_a_toolpath_can_be_given_for_one_run(tmp_path: Path) -> None:
    (tmp_path / "a.cl").write_text("GOTO/1,2,3\nFINI\n")
    template = "@START\n%\n@\n@LINE\nG1 X#XPOS\n@\n@RAP\nG0 X#XPOS\n@\n@END\nM30\n@\n@ARC\n@\n@TOOLCHG\n@\n"
    with Inside() as inside:
        main_file = (tmp_path / "main.cgt").as_uri()
        inside.open(main_file, template, "cgt")
        assert expand(inside, main_file)["text"] == ""
        assert "X1.0" in expand(inside, main_file, input=(tmp_path / "a.cl").as_uri())["text"]
        inside.open("untitled:y", "G0 X1\n", "rs274")
        refused = expand(inside, "untitled:y", input="file:///a.cl")
        assert refused["code"] == -32602
        assert "have no such input" in refused["message"]


@pytest.mark.parametrize(
    "wrong",
    [{"define": 7}, {"maxBlocks": -1}, {"maxBlocks": True}, {"blockDelete": "yes"}, {"with": [1]}, {"nonsense": 1}],
)
def test_arguments_that_cannot_be_used_are_named(wrong: dict[str, Any]) -> None:
    with Inside() as inside:
        inside.open("untitled:x", "G0 X1\n", "rs274")
        refused = expand(inside, "untitled:x", **wrong)
        assert refused["code"] == -32602
        assert f"`{next(iter(wrong))}`" in refused["message"]


def _answers(number: int, message: dict[str, Any]) -> bool:
    return message.get("id") == number and "method" not in message


def test_progress_of_a_long_run_is_shown_and_can_be_cancelled() -> None:
    """By the client's own token at once; without one the server asks for it when the run takes long."""
    with Inside({"window": {"workDoneProgress": True}}) as inside:
        inside.open("untitled:x", ENDLESS, "rs274")
        for token in ("mine", None):
            inside.said.clear()
            argument = {"uri": "untitled:x", "maxSteps": 0}
            params = {
                "command": "deburr.expand",
                "arguments": [argument],
                **({"workDoneToken": token} if token else {}),
            }
            number = inside.begin("workspace/executeCommand", params)
            if token is None:
                created = inside.wait(lambda each: each.get("method") == "window/workDoneProgress/create")
                token = created["params"]["token"]
                inside._send({"id": created["id"], "result": None})
            begin = inside.wait(lambda each: each.get("method") == "$/progress")["params"]
            assert (begin["token"], begin["value"]["kind"], begin["value"]["title"]) == (
                token,
                "begin",
                "Expanding untitled:x",
            )
            assert begin["value"]["cancellable"] is True
            reported = inside.wait(
                lambda each: "executed" in each.get("params", {}).get("value", {}).get("message", "")
            )
            assert reported["params"]["value"]["kind"] == "report"
            inside.notify("window/workDoneProgress/cancel", {"token": token})
            assert inside.wait(partial(_answers, number))["error"]["code"] == -32800
            assert inside.wait(lambda each: each.get("params", {}).get("value", {}).get("kind") == "end")


def test_an_older_text_is_expanded_as_if_it_stood_there(tmp_path: Path) -> None:
    (tmp_path / "drill.ngc").write_text("o<drill> sub\nG0 X#1\no<drill> endsub\n")
    uri = (tmp_path / "main.ngc").as_uri()
    with Inside() as inside:
        inside.open(uri, "o<drill> call [5]\nM2\n", "rs274")
        assert expand(inside, uri, text="o<drill> call [7]\nM2\n")["text"] == "G0 X7\nM2\n"
        assert expand(inside, uri)["text"] == "G0 X5\nM2\n"
