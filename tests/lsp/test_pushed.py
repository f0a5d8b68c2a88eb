"""What is pushed of a program as it becomes known: what its text says does not wait for its values and its run."""

from __future__ import annotations

from pathlib import Path

import pytest

from support.inside import Inside

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
