"""Layout as a client asks for it: of documents, of ranges, of what is typed; in all four languages and in the client's units."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from deburr_grammar.text import Edit, Pos
from support.inside import Inside
from support.naive import edited, lines_of

SPACES = {"tabSize": 4, "insertSpaces": True}
UNITS = {"utf-8": 4, "utf-16": 2, "utf-32": 1}
TEXTS = {
    "rs274": ("(😋) o1 if[1]\n(😋)g0x1\no1 endif\nM2\n", "(😋) o1 if[1]\n(😋) g0 x1\no1 endif\nM2\n"),
    "metagcode": ("#LOOP1   |😋|  1 c\n#FILE   a\nX|😋|  \n#ENDLOOP1\n", "#LOOP1 |😋| 1 c\n    #FILE a\nX|😋|  \n#ENDLOOP1\n"),
    "cgt": ("@LINE  \n😋 #EVAL( #V1 =1 )  \n@\n", "@LINE\n😋 #EVAL(#V1 = 1)  \n@\n"),
    "z32": ("(😋)  X< HA+1 >\n!HA=1;  HB=2!;😋  \nM30\n", "(😋)  X<HA+1>\n!HA=1; HB=2! ;😋\nM30\n"),
}  # fmt: skip


def ask(inside: Inside, method: str, **more: Any) -> Any:
    params = {"textDocument": {"uri": "untitled:x"}, "options": SPACES, **more}
    return inside.request(f"textDocument/{method}", params)


def span(first: int, last: int, character: int = 0) -> dict[str, Any]:
    return {"start": {"line": first, "character": 0}, "end": {"line": last, "character": character}}


def after(text: str, edits: list[dict[str, Any]], encoding: str) -> str:
    """The text after a client's edits, each of which stands in places of the text as it was."""
    lines = lines_of(text)
    for edit in reversed(edits):
        ends = [_pos(lines, edit["range"][end], encoding) for end in ("start", "end")]
        text = edited(text, Edit(*ends, edit["newText"]))
    return text


def _pos(lines: list[str], position: dict[str, int], encoding: str) -> Pos:
    line, units, col = lines[position["line"]], position["character"], 0
    while units > 0:
        units -= UNITS[encoding] if line[col] == "😋" else 1
        col += 1
    assert units == 0
    return Pos(position["line"], col)


def opened(inside: Inside, text: str, language: str) -> None:
    inside.open("untitled:x", text, language)


@pytest.mark.parametrize("encoding", UNITS)
@pytest.mark.parametrize("language", TEXTS)
def test_documents(language: str, encoding: str) -> None:
    old, new = TEXTS[language]
    with Inside({"general": {"positionEncodings": [encoding]}}) as inside:
        opened(inside, old, language)
        edits = ask(inside, "formatting")
        assert after(old, edits, encoding) == new
        assert all(edit["range"]["start"]["line"] == edit["range"]["end"]["line"] for edit in edits)
        # Each line that differs has one edit, of what differs and no more.
        assert len(edits) == sum(one != other for one, other in zip(lines_of(old), lines_of(new), strict=True))
        ranges = [span(0, 1), span(0, 9)]
        assert after(old, ask(inside, "rangesFormatting", ranges=ranges), encoding) == new


def test_ranges() -> None:
    with Inside() as inside:
        opened(inside, "g0x1\n" * 6, "rs274")
        asked = {
            "one line": ("rangeFormatting", {"range": span(2, 2, 3)}, [2]),
            "up to the start of a line": ("rangeFormatting", {"range": span(2, 4)}, [2, 3]),
            "into a line": ("rangeFormatting", {"range": span(2, 4, 1)}, [2, 3, 4]),
            "an empty one": ("rangeFormatting", {"range": span(2, 2)}, [2]),
            "past the end": ("rangeFormatting", {"range": span(5, 99)}, [5]),
            "several": ("rangesFormatting", {"ranges": [span(4, 5), span(0, 1)]}, [0, 4]),
        }
        for name, (method, more, lines) in asked.items():
            assert [edit["range"]["start"]["line"] for edit in ask(inside, method, **more)] == lines, name


def test_typing() -> None:
    with Inside() as inside:
        opened(inside, "o1 if [1]\n\no1 endif\n", "rs274")
        here = {"line": 1, "character": 0}
        typed = ask(inside, "onTypeFormatting", position=here, ch="\n")
        assert typed == [{"range": {"start": here, "end": here}, "newText": "    "}]
        tabs = {"tabSize": 8, "insertSpaces": False}
        assert ask(inside, "onTypeFormatting", position=here, ch="\n", options=tabs)[0]["newText"] == "\t"
        assert ask(inside, "onTypeFormatting", position={"line": 2, "character": 8}, ch="f") == []


def test_a_configured_style_wins_over_the_editors(tmp_path: Path) -> None:
    uri = (tmp_path / "a.ngc").as_uri()
    text = "o1 if [1]\nG0\no1 endif\n"
    for written, lead in (("", "    "), ("case = 'keep'", "    "), ("indent = 1", " "), ("indent-style = 'tab'", "\t")):
        (tmp_path / "deburr.toml").write_text(f"[format]\n{written}\n")
        with Inside() as inside:
            inside.open(uri, text, "rs274")
            edits = inside.request("textDocument/formatting", {"textDocument": {"uri": uri}, "options": SPACES})
            assert [edit["newText"] for edit in edits] == [lead], written
    settings = {"format": {"indent": 3}}
    with Inside(initializationOptions=settings) as inside:
        inside.open("untitled:x", text, "rs274")
        assert [edit["newText"] for edit in ask(inside, "formatting")] == ["   "]


def test_what_is_no_program_has_no_layout() -> None:
    with Inside() as inside:
        opened(inside, "g0x1\n", "plaintext")
        assert ask(inside, "formatting") is None
        assert ask(inside, "onTypeFormatting", position={"line": 0, "character": 0}, ch="\n") == []


def test_an_edit_meanwhile_is_laid_out_too() -> None:
    """A long program is laid out between messages: the answer is about the version that is there when it is given."""
    with Inside() as inside:
        opened(inside, "g0x1\n" * 2_000, "rs274")
        inside._number += 1
        number = inside._number
        params = {"textDocument": {"uri": "untitled:x"}, "options": SPACES}
        inside._send({"id": number, "method": "textDocument/formatting", "params": params})
        change = {"range": span(0, 1_999), "text": ""}
        document = {"uri": "untitled:x", "version": 2}
        inside.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [change]})
        assert not any(each.get("id") == number for each in inside.said)
        for _ in range(1_000):
            inside.settle()
        (answer,) = (each for each in inside.said if each.get("id") == number)
        assert [edit["range"]["start"]["line"] for edit in answer["result"]] == [0]
