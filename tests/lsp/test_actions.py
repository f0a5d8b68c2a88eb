"""Code actions as a client asks for them: what is offered at once, what is worked out when it is chosen, and what a client without the newer abilities is given."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from support.inside import Inside, Json

RICH: Json = {
    "textDocument": {"codeAction": {"resolveSupport": {"properties": ["edit"]}, "dataSupport": True}, "diagnostic": {}},
    "workspace": {"workspaceEdit": {"documentChanges": True, "resourceOperations": ["create", "rename"]}},
}
PLAIN: Json = {"textDocument": {}, "workspace": {"workspaceEdit": {"documentChanges": True}}}
URI = "untitled:one"


def asked(inside: Inside, place: tuple[int, int, int, int], *only: str, uri: str = URI) -> list[Json]:
    """The actions for a place."""
    start, end = ({"line": line, "character": col} for line, col in (place[:2], place[2:]))
    context = {"diagnostics": [], **({"only": list(only)} if only else {})}
    params = {"textDocument": {"uri": uri}, "range": {"start": start, "end": end}, "context": context}
    found: list[Json] = inside.request("textDocument/codeAction", params)
    return found


def opened(inside: Inside, text: str, language: str) -> None:
    inside.open(URI, text, language)
    inside.settle()


def edits(action: Json) -> list[tuple[int, int, int, int, str]]:
    """The edits of an action of one document."""
    (change,) = action["edit"]["documentChanges"]
    return [(*_ends(each["range"]), each["newText"]) for each in change["edits"]]


def _ends(place: Json) -> tuple[int, int, int, int]:
    start, end = place["start"], place["end"]
    return start["line"], start["character"], end["line"], end["character"]


@pytest.mark.parametrize(
    ("language", "text", "place", "title", "expected"),
    [
        ("rs274", "N5 G21 (😋) #<a>=[1+2\nM2\n", (0, 0, 0, 0), "Insert `]`", (0, 21, 0, 21, "]")),
        ("metagcode", "#IF1 |a| = 1 n\n#ENDIF1\n", (0, 0, 0, 0), "Change to `equalto`", (0, 9, 0, 10, "equalto")),
        ("cgt", "@LINE\n<X#XPSO>\n@\n", (1, 0, 1, 0), "Change to `#XPOS`", (1, 2, 1, 7, "#XPOS")),
        ("z32", "(P)\nHA<SIN(30)>\nM30\n", (1, 0, 1, 0), "Change to `SN`", (1, 3, 1, 6, "SN")),
    ],
)
def test_a_fix_of_each_language(language: str, text: str, place: Any, title: str, expected: Any) -> None:
    with Inside(RICH) as inside:
        opened(inside, text, language)
        first = next(each for each in asked(inside, place, "quickfix") if each["title"] == title)
        assert edits(first) == [expected]
        assert first["isPreferred"] is True and first["diagnostics"][0]["source"] == "deburr"


def test_what_costs_more_than_a_line_is_worked_out_when_it_is_chosen() -> None:
    with Inside(RICH) as inside:
        opened(inside, "(P)\nN5 G0 X1\nN7 G0\n!IF X>5; GON7!\nM30\n", "z32")
        (offer,) = asked(inside, (1, 0, 1, 0), "refactor")
        assert (offer["title"], offer["kind"], "edit" in offer) == ("Renumber all lines", "refactor.rewrite", False)
        chosen = inside.request("codeAction/resolve", offer)
        assert edits(chosen) == [(1, 1, 1, 2, "10"), (2, 1, 2, 2, "20"), (3, 12, 3, 13, "20")]


def test_what_cannot_be_done_says_why() -> None:
    with Inside(RICH) as inside:
        opened(inside, "(P)\nN5 G0 X1\n!GON<HA>!\nM30\n", "z32")
        (offer,) = asked(inside, (1, 0, 1, 0), "refactor.rewrite")
        refused = inside.request("codeAction/resolve", offer)
        assert refused["code"] == -32803
        assert refused["message"] == "not done: the jump in line 3 goes to a number that is computed"


def test_what_was_offered_for_another_text_is_not_done() -> None:
    with Inside(RICH) as inside:
        opened(inside, "G21 G90 G17\nN5 G0 X1\nM2\n", "rs274")
        (offer,) = asked(inside, (1, 0, 1, 0), "refactor.rewrite")
        change = {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": "N1 M2\n"}]}
        inside.notify("textDocument/didChange", change)
        assert inside.request("codeAction/resolve", offer)["code"] == -32801


def test_what_is_no_offer_of_ours_comes_back_as_it_is() -> None:
    with Inside(RICH) as inside:
        opened(inside, "M2\n", "rs274")
        for data in (None, 7, {"uri": URI}, {"uri": URI, "range": [0, "x", 0, 0]}, {"uri": 5, "range": [0, 0, 0, 0]}):
            sent = {"title": "other", **({} if data is None else {"data": data})}
            assert inside.request("codeAction/resolve", sent) == sent


@pytest.mark.parametrize("kind", ["source.fixAll.deburr", "source.fixAll", "source"])
@pytest.mark.parametrize("client", [RICH, PLAIN], ids=["resolves", "does not"])
def test_all_safe_fixes_in_one_edit(kind: str, client: Json) -> None:
    with Inside(client) as inside:
        opened(inside, "(P)\ng0 x1\nG0 X(1\n!;HA=2;!\nM30\n", "z32")
        (action,) = asked(inside, (0, 0, 0, 0), kind)
        assert action["kind"] == "source.fixAll.deburr"
        action = action if "edit" in action else inside.request("codeAction/resolve", action)
        assert edits(action) == [(1, 0, 1, 5, "G0 X1"), (3, 0, 3, 8, "!HA=2!")]


def test_a_client_that_cannot_ask_later_is_given_what_can_be_done() -> None:
    with Inside(PLAIN) as inside:
        opened(inside, "G21 G90 G17\n#1=2\nN5 G0 X#1\nM2\n", "rs274")
        found = asked(inside, (2, 7, 2, 7))
        assert [each["title"] for each in found] == ["Renumber all lines", "Put the value of `#1` in its place"]
        assert edits(found[1]) == [(1, 0, 2, 0, ""), (2, 7, 2, 9, "2")]
        opened(inside, "(P)\nN5 G0 X1\n!GON<HA>!\nM30\n", "z32")
        assert [each for each in asked(inside, (1, 0, 1, 0)) if each["kind"] != "quickfix"] == []


def test_a_missing_subprogram_and_a_snippet_are_made(tmp_path: Path) -> None:
    with Inside(RICH) as inside:
        uri = (tmp_path / "main.ngc").as_uri()
        inside.open(uri, "G21 G90 G17\no<deep> call [1]\nM2\n", "rs274")
        inside.settle()
        titles = {each["title"]: each for each in asked(inside, (1, 0, 1, 0), "quickfix", uri=uri)}
        made, text = titles["Create `deep.ngc`"]["edit"]["documentChanges"]
        assert (made["kind"], made["uri"]) == ("create", (tmp_path / "deep.ngc").as_uri())
        assert text["edits"][0]["newText"] == "o<deep> sub\n\no<deep> endsub\nM2\n"
        uri = (tmp_path / "main.mgc").as_uri()
        inside.open(uri, "G0 X1\nG0 X2\nG0 X3\n", "metagcode")
        inside.settle()
        (offer,) = asked(inside, (1, 0, 2, 0), "refactor.extract", uri=uri)
        made, text, own = inside.request("codeAction/resolve", offer)["edit"]["documentChanges"]
        assert made["uri"] == (tmp_path / "Snippets" / "part.txt").as_uri()
        assert text["edits"][0]["newText"] == "G0 X2\n"
        assert [(*_ends(each["range"]), each["newText"]) for each in own["edits"]] == [(1, 0, 1, 5, "#FILE part.txt")]


def test_a_client_that_makes_no_files_is_not_asked_to(tmp_path: Path) -> None:
    with Inside(PLAIN) as inside:
        uri = (tmp_path / "main.ngc").as_uri()
        inside.open(uri, "G21 G90 G17\no<deep> call [1]\nM2\n", "rs274")
        inside.settle()
        assert not [each for each in asked(inside, (1, 0, 1, 0)) if each["title"].startswith("Create")]
        uri = (tmp_path / "main.mgc").as_uri()
        inside.open(uri, "G0 X1\nG0 X2\n", "metagcode")
        inside.settle()
        assert asked(inside, (0, 0, 1, 0), "refactor.extract", uri=uri) == []
        inside.settle()
    later = {**RICH, "workspace": PLAIN["workspace"]}
    with Inside(later) as inside:
        inside.open(uri, "G0 X1\nG0 X2\n", "metagcode")
        inside.settle()
        (offer,) = asked(inside, (0, 0, 1, 0), "refactor.extract", uri=uri)
        assert inside.request("codeAction/resolve", offer)["message"].endswith("cannot make the file that it needs")


def test_an_edit_ends_what_is_being_worked_out() -> None:
    with Inside(RICH) as inside:
        opened(inside, "G21 G90 G17\n" + "N1 G0 X1\n" * 20_000 + "M2\n", "rs274")
        (offer,) = asked(inside, (1, 0, 1, 0), "refactor.rewrite")
        inside.loop.call_soon(_typed, inside)
        assert inside.request("codeAction/resolve", offer)["code"] == -32801


def _typed(inside: Inside) -> None:
    """An edit that comes in while the server is at work."""
    change = {"range": {"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}}, "text": " "}
    params = {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [change]}
    message = {"jsonrpc": "2.0", "method": "textDocument/didChange", "params": params}
    inside.server.receive(json.dumps(message).encode())
