"""What several programs find at one place of a file that they share is said once, with the way to it from each, in every form of report."""

import json
from functools import reduce
from itertools import permutations

import pytest

from deburr.finding import Finding, Place, Related, Severity, joined

CALLS = "G21 G90 G17\nF100\no<shared> call [{}]\nM2\n"
SHARED = "o<shared> sub\nG0 X[1/[#1-3]]\no<shared> endsub\nM2\n"
NAMES = ("a.ngc", "b.ngc", "c.ngc")


@pytest.fixture
def archive(shell, monkeypatch):
    for name in ("GITHUB_WORKSPACE", "CI_PROJECT_DIR"):
        monkeypatch.delenv(name, raising=False)
    for name in NAMES:
        shell.write(name, CALLS.format(3))
    shell.write("right.ngc", CALLS.format(1))
    shell.write("shared.ngc", SHARED)
    return shell


def test_json(archive):
    for _ in ("anew", "known from an earlier check"):
        (found,) = json.loads(archive.run("check", "--output-format", "json").out)
        assert found["filename"].endswith("shared.ngc") and found["rule"] == "rs274.divide-by-zero"
        told = [(each["filename"].rpartition("/")[2], each["message"], each["entered"]) for each in found["related"]]
        assert told == [
            ("a.ngc", "called here", True),
            ("b.ngc", "also called here", False),
            ("c.ngc", "also called here", False),
        ]


def test_json_lines(archive):
    (line,) = archive.run("check", "--output-format", "json-lines").out.splitlines()
    assert len(json.loads(line)["related"]) == 3


def test_full_and_concise(archive):
    full = archive.run("check").out
    assert full.count("divide-by-zero") == 1 and full.endswith("Found 1 error in 1 file (5 checked)\n")
    assert [full.count(f"::: {name}:3:1") for name in NAMES] == [1, 1, 1]
    assert archive.run("check", "--output-format", "concise").out.count("divide-by-zero") == 1


def test_sarif(archive):
    (run,) = json.loads(archive.run("check", "--output-format", "sarif").out)["runs"]
    (result,) = run["results"]
    (flow,) = result["codeFlows"][0]["threadFlows"]
    assert len(flow["locations"]) == 2
    files = [each["physicalLocation"]["artifactLocation"]["uri"] for each in result["relatedLocations"]]
    assert [file.rpartition("/")[2] for file in files] == ["b.ngc", "c.ngc"]


@pytest.mark.parametrize(("form", "sign"), [("github", "::error"), ("gitlab", '"check_name"'), ("junit", "<failure")])
def test_forges(archive, form, sign):
    assert archive.run("check", "--output-format", form).out.count(sign) == 1


@pytest.mark.parametrize("count", [2, 3, 5])
def test_parts_join_as_the_whole_does(archive, count):
    names = [f"{number}.json" for number in range(1, count + 1)]
    for number, name in enumerate(names, 1):
        archive.run("check", "--shard", f"{number}/{count}", "--output-format", f"json={name}")
    whole = archive.run("check", "--output-format", "json").out
    assert archive.run("merge", *names, "--output-format", "json").out == whole


def test_one_fingerprint_and_one_line_of_a_baseline(archive):
    known = ["--baseline", "known.json"]
    said = archive.run("check", *known, "--update-baseline").err
    assert "1 findings known; 1 new" in said
    archive.write("d.ngc", CALLS.format(3))
    assert archive.run("check", *known).code == 0


def test_it_fails_if_it_fails_for_one_of_them(shell):
    shell.write("a/main.ngc", CALLS.format(3))
    shell.write(
        "a/deburr.toml",
        '[check]\nfail-on = "error"\n[check.severity]\n"rs274.divide-by-zero" = "info"\n[rs274]\nsubroutine-path = ["../lib"]\n',
    )
    shell.write("b/main.ngc", CALLS.format(3))
    shell.write("b/deburr.toml", '[rs274]\nsubroutine-path = ["../lib"]\n')
    shell.write("lib/shared.ngc", SHARED)
    ran = shell.run("check", "--output-format", "json")
    (found,) = json.loads(ran.out)
    assert (ran.code, found["severity"], len(found["related"])) == (1, "error", 2)


def way(*names: str) -> Finding:
    related = tuple(Related(Place(name, 2, 0, 2, 0), "called here", True) for name in names)
    return Finding("rs274.divide-by-zero", Severity.ERROR, "no", Place("shared.ngc", 1, 7, 1, 9), related)


def test_the_order_in_which_ways_are_joined_does_not_matter():
    one, two, three = ways = [way("a.ngc"), way("x.ngc", "b.ngc"), way("x.ngc", "c.ngc")]
    made = {reduce(joined, each) for each in permutations([*ways, two])}
    made |= {joined(joined(one, two), joined(three, two)), joined(joined(one, one), joined(three, two))}
    (found,) = made
    assert [(each.place.file, each.message, each.entered) for each in found.related] == [
        ("a.ngc", "called here", True),
        ("b.ngc", "also called here", False),
        ("c.ngc", "also called here", False),
        ("x.ngc", "also called here", False),
    ]


def test_where_a_file_alone_is_wrong_its_callers_are_no_matter():
    ways = [way("a.ngc"), way(), way("b.ngc")]
    assert {reduce(joined, each) for each in permutations(ways)} == {way()}
