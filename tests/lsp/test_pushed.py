"""What is pushed of a program as it becomes known: what its text says does not wait for its values and its run."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from deburr.finding import Finding, Place, Related, Severity
from deburr.lsp.report import MOST, Written, _Report, diagnostics
from support.client import edit
from support.inside import Inside

PUSH = "textDocument/publishDiagnostics"

PROGRAM = """G21 G90 G94 F100
#<n> = 0
o1 while [#<n> LT 3]
  #<n> = [#<n> + 1]
o1 endwhile
G1 X[1 / [#<n> - 3]]
{}
"""
"""After three passes the divisor is nought, which only going through the program tells."""


@pytest.mark.parametrize(
    ("rest", "of_text"),
    [("M2\nG1 X2", ["rs274.text-after-end"]), ("G2 X1 I0 J0\nM2", ["rs274.arc-radius"]), ("M2", [])],
)
def test_findings_of_the_text_are_pushed_before_those_of_the_run(rest: str, of_text: list[str]) -> None:
    with Inside() as inside:
        inside.open("untitled:a", PROGRAM.format(rest), "rs274")
        inside.settle()
        pushed = [
            [item["code"] for item in each["params"]["diagnostics"]]
            for each in inside.said
            if each.get("method") == "textDocument/publishDiagnostics"
        ]
        assert pushed == [of_text, ["rs274.divide-by-zero", *of_text]]


def test_what_two_open_programs_find_in_a_file_that_both_call_is_pushed_once(tmp_path: Path) -> None:
    calls = "G21 G90 G17\nF100\no<shared> call [3]\nM2\n"
    (tmp_path / "shared.ngc").write_text("o<shared> sub\nG0 X[1/[#1-3]]\no<shared> endsub\nM2\n")
    shared = (tmp_path / "shared.ngc").as_uri()
    capabilities = {"textDocument": {"publishDiagnostics": {"relatedInformation": True}}}
    with Inside(capabilities, workspaceFolders=[{"uri": tmp_path.as_uri(), "name": "here"}]) as inside:
        for name in ("a.ngc", "b.ngc"):
            (tmp_path / name).write_text(calls)
            inside.open((tmp_path / name).as_uri(), calls, "rs274")
            inside.settle()
        last = [each["params"] for each in inside.said if each.get("method") == "textDocument/publishDiagnostics"]
        (found,) = next(each["diagnostics"] for each in reversed(last) if each["uri"] == shared)
        told = [(each["location"]["uri"].rpartition("/")[2], each["message"]) for each in found["relatedInformation"]]
        assert (found["code"], told) == (
            "rs274.divide-by-zero",
            [("a.ngc", "called here"), ("b.ngc", "also called here")],
        )


LABELS = 600
LINKED = ["G21 G90", *(f"o{at} if [#1 GT 1]\nG0 X1\no{at} endif" for at in (*range(LABELS), *range(LABELS))), "", "M2"]
"""Each label is used a second time, which is a finding there that points to the first."""


class Typing:
    """A program in a server, and how many diagnostics are put into words for it."""

    def __init__(self, inside: Inside, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
        self.inside = inside
        self.version = 1
        self.worded: list[Finding] = []
        text_of = _Report.text

        def text_and_count(report: _Report, finding: Finding) -> str:
            self.worded.append(finding)
            return text_of(report, finding)

        monkeypatch.setattr(_Report, "text", text_and_count)
        inside.open("untitled:a", text, "rs274")
        inside.settle()

    def key(self, line: int, start: int, end: int, text: str) -> list[Any]:
        """The diagnostics that are pushed with a key: they are those that somebody gets who is told of them for the first time."""
        self.version += 1
        self.worded.clear()
        params = self.inside.server.session
        change = {
            "textDocument": {"uri": "untitled:a", "version": self.version},
            "contentChanges": [edit(line, start, end, text)],
        }
        self.inside.notify("textDocument/didChange", change)
        pushed = next(each["params"] for each in reversed(self.inside.said) if each["method"] == PUSH)
        found = self.inside.server.checks.findings("untitled:a")
        assert pushed["version"] == self.version
        items: list[Any] = pushed["diagnostics"]
        assert items[:MOST] == diagnostics(found[:MOST], params)
        return items


def test_a_key_puts_into_words_what_has_moved_and_nothing_else(monkeypatch: pytest.MonkeyPatch) -> None:
    with Inside({"textDocument": {"publishDiagnostics": {"relatedInformation": True}}}) as inside:
        typing = Typing(inside, "\n".join(LINKED), monkeypatch)
        last = 6 * LABELS + 1
        assert len(typing.key(last, 0, 0, "G0 X2")) == MOST + 1
        assert len(typing.worded) == 0, "no finding stands behind it, and none points there"
        # The second use of label 400 stands on line 1 + 3 * 1,000, behind those of 400 others and `#1`, which nothing sets.
        assert len(typing.key(3_000, 0, 0, "\n")) == MOST + 1
        assert len(typing.worded) == MOST - 401
        typing.key(3_033, 5, 5, "7")
        assert len(typing.worded) == 0, "the line has no finding, and no other has moved"
        typing.key(1 + 3 * 20, 0, 0, "\n")
        assert len(typing.worded) == MOST - 1, "all but the first stand behind it"
        typing.key(1 + 3 * 30 + 1, 0, 0, " ")
        assert [each.place.line for each in typing.worded] == [1 + 3 * (LABELS + 30) + 1], (
            "it points to the edited line"
        )


def test_units_are_those_of_what_stands_in_front_now(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is typed has as many characters as what it takes the place of, but not as many units."""
    text = "G21 G90\nG0 (x) X#<a>\n(x) #<a>=1\nM2\n"
    with Inside({"textDocument": {"publishDiagnostics": {"relatedInformation": True}}}) as inside:
        typing = Typing(inside, text, monkeypatch)
        typing.key(1, 4, 5, "\U0001f60b")
        (item,) = typing.key(2, 1, 2, "\U0001f60b")
        (point,) = item["relatedInformation"]
        starts = [place["range"]["start"] for place in (item, point["location"])]
        assert starts == [{"line": 1, "character": 9}, {"line": 2, "character": 5}]


def test_units_are_those_of_what_stands_in_front_in_another_file_now(tmp_path: Path) -> None:
    """What a program is told of another file is not what that was when it was told first."""
    (tmp_path / "s.ngc").write_text("(x) o<s> sub\n")
    main, part = (tmp_path / "main.ngc").as_uri(), (tmp_path / "s.ngc").as_uri()
    finding = Finding("r", Severity.ERROR, "m", Place(str(tmp_path / "main.ngc"), 0, 0, 0, 1), ())
    finding = finding._replace(related=(Related(Place(str(tmp_path / "s.ngc"), 0, 4, 0, 5), "there"),))
    with Inside() as inside:
        inside.open(main, "G0\n", "rs274")
        inside.open(part, "(x) G0 X1\n", "rs274")
        written, session = Written(), inside.server.session
        before = written.capped([finding], 1, session)
        change = {"textDocument": {"uri": part, "version": 2}, "contentChanges": [edit(0, 1, 2, "\U0001f60b")]}
        inside.notify("textDocument/didChange", change)
        after = written.capped([finding], 1, session)
        assert json.loads(before) != json.loads(after) == diagnostics([finding], session)
