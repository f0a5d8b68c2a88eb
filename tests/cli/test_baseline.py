"""`--baseline`: what was there before is passed over, wherever it has moved; what is new is not."""

import json

import pytest

HEAD = "G21 G90 G17\n"
OLD = "G0 X[1/0]\n(drill (first) hole)\n"
TAIL = "F100\nM2\n"


def update(shell, *more: str):
    return shell.run("check", "--baseline", "known.json", "--update-baseline", *more)


def places(shell, *more: str) -> tuple[list[str], int]:
    """The places of what is reported, and the exit code."""
    ran = shell.run("check", "--baseline", "known.json", "--output-format", "concise", *more)
    assert ran.err == ""
    return [line.split(" ", 1)[0].rstrip(":") for line in ran.out.splitlines()[:-1]], ran.code


@pytest.fixture
def archive(shell):
    shell.write("old/a.ngc", HEAD + OLD + TAIL)
    shell.write("old/b.ngc", HEAD + OLD + TAIL)
    assert shell.run("check").code == 1
    assert update(shell) == (
        0,
        "All checks passed (2 checked, 4 known before)\n",
        "deburr: known.json: 4 findings known; 4 new, 0 dropped\n",
    )
    return shell


def test_what_is_known_is_passed_over(archive):
    assert places(archive) == ([], 0)
    assert archive.run("check").code == 1


def test_a_finding_that_moves_is_not_new(archive):
    archive.write("old/a.ngc", HEAD + "(more)\n" * 100 + OLD.replace("G0 X", "  G0  X") + TAIL)
    assert places(archive) == ([], 0)


def test_a_new_one_fails_the_run(archive):
    archive.write("old/a.ngc", HEAD + OLD + "G0 Y[1/0]\n" + TAIL)
    assert places(archive) == (["old/a.ngc:4:8"], 1)


def test_one_more_of_the_same_is_new(archive):
    archive.write("old/a.ngc", HEAD + OLD + OLD + TAIL)
    assert places(archive) == (["old/a.ngc:4:8", "old/a.ngc:5:8"], 1)


def test_the_same_in_another_program_is_new(archive):
    archive.write("c.ngc", HEAD + OLD + TAIL)
    assert places(archive) == (["c.ngc:2:8", "c.ngc:3:8"], 1)


def test_what_is_mended_is_dropped(archive):
    archive.write("old/a.ngc", HEAD + TAIL)
    verbose = archive.run("check", "--baseline", "known.json", "-v").err.splitlines()
    assert verbose[-1] == "deburr: known.json: 2 of its findings are no more; --update-baseline drops them"
    assert update(archive).err == "deburr: known.json: 2 findings known; 0 new, 2 dropped\n"
    assert list(json.loads((archive.folder / "known.json").read_text())["findings"]) == ["old/b.ngc"]
    archive.write("old/a.ngc", HEAD + OLD + TAIL)
    assert places(archive)[1] == 1


def test_programs_that_were_not_looked_at_keep_theirs_until_they_are_gone(archive):
    archive.write("old/a.ngc", HEAD + TAIL)
    update(archive, "old/a.ngc")
    assert places(archive) == ([], 0)
    (archive.folder / "old/b.ngc").unlink()
    update(archive, "old/a.ngc")
    assert json.loads((archive.folder / "known.json").read_text())["findings"] == {}


def test_it_holds_from_every_folder(archive, monkeypatch):
    monkeypatch.chdir(archive.folder / "old")
    assert archive.run("check", "--baseline", "../known.json").code == 0


def test_it_knows_what_sarif_says(archive):
    results = json.loads(archive.run("check", "--output-format", "sarif").out)["runs"][0]["results"]
    known = json.loads((archive.folder / "known.json").read_text())["findings"]
    marks = {mark for found in known.values() for mark in found}
    assert {each["partialFingerprints"]["deburr/v1"] for each in results} == marks


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (None, "known.json: no such file; --update-baseline writes it"),
        ("", "known.json: no baseline"),
        ("[1]", "known.json: no baseline"),
        ('{"version": 1, "findings": {"a.ngc": ["x"]}}', "known.json: no baseline"),
        ("[" * 100_000, "known.json: no baseline"),
        ('{"version": 2, "findings": {}}', "known.json: written by another version of deburr"),
    ],
)
def test_what_is_no_baseline_is_said(shell, text, message):
    shell.write("a.ngc", HEAD + TAIL)
    if text is not None:
        shell.write("known.json", text)
    ran = shell.run("check", "--baseline", "known.json")
    assert (ran.code, ran.out) == (2, "") and ran.err.startswith(f"deburr: error: {message}")


def test_options_that_say_nothing_alone(shell):
    shell.write("a.ngc", HEAD + TAIL)
    assert shell.run("check", "--update-baseline").err == (
        "deburr: error: --update-baseline: say with --baseline which file\n"
    )
    assert "give it to `deburr merge`" in update(shell, "--shard", "1/2").err
