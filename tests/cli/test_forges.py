"""What forges and their build servers are told of one folder of faulty programs: each form as its reader takes it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import jsonschema
import junitparser
import pytest
from sarif.loader import load_sarif_file

SCHEMAS = Path(__file__).parent / "schemas"
CALLED = """\
G21 G90 G17
o<peck> sub
  #<n> = [5 - #1]
  o10 while [#<n> GT 0]
    G0 X[1/[#<n>-2]]
    #<n> = [#<n> - 1]
  o10 endwhile
o<peck> endsub
F100
o<peck> call [1]
M2
"""
PROGRAMS = {
    "a, 50%:b.ngc": "G21 G90 G17\nG0 X1 (drill (first) hole)\nG0 X[1/0]\nF100\nM2\n",
    "calls.ngc": CALLED,
    "sub/lower.z32": "(P)\ng0 X1\nM30\n",
    "right.ngc": "G21\nM2\n",
}


@pytest.fixture
def folder(shell, monkeypatch):
    for name in ("GITHUB_WORKSPACE", "CI_PROJECT_DIR"):
        monkeypatch.delenv(name, raising=False)
    for name, text in PROGRAMS.items():
        shell.write(name, text)
    return shell


def reported(shell, form: str, code: int = 1) -> str:
    ran = shell.run("check", "--output-format", form)
    assert (ran.code, ran.err) == (code, "")
    return ran.out


def check_against(schema: str, said: object) -> None:
    rules = json.loads((SCHEMAS / schema).read_text(encoding="utf-8"))
    validator = jsonschema.validators.validator_for(rules)
    validator.check_schema(rules)
    validator(rules, format_checker=validator.FORMAT_CHECKER).validate(said)


def test_the_schemas_refuse_what_is_wrong(folder):
    sarif, gitlab = json.loads(reported(folder, "sarif")), json.loads(reported(folder, "gitlab"))
    sarif["runs"][0]["results"][0]["level"] = "fatal"
    with pytest.raises(jsonschema.ValidationError, match="fatal"):
        check_against("sarif-2.1.0.json", sarif)
    gitlab[0]["severity"] = "error"
    with pytest.raises(jsonschema.ValidationError, match="error"):
        check_against("gitlab-code-quality.json", gitlab)


# As `@actions/core` undoes it: properties first, then the colon and the comma in them.
def commands(out: str) -> Iterator[tuple[str, dict[str, str], str]]:
    for line in out.splitlines():
        match = re.fullmatch(r"::(error|warning|notice) (.*?)::(.*)", line)
        assert match is not None, line
        properties = dict(part.split("=", 1) for part in match[2].split(","))
        yield match[1], {name: unescaped(value) for name, value in properties.items()}, unescaped(match[3])


def unescaped(text: str) -> str:
    for sign, code in ((":", "%3A"), (",", "%2C"), ("\r", "%0D"), ("\n", "%0A"), ("%", "%25")):
        text = text.replace(code, sign)
    return text


def test_github(folder):
    found = list(commands(reported(folder, "github")))
    assert [(kind, said["file"], said["line"], said["col"], said["endColumn"]) for kind, said, _ in found] == [
        ("error", "a, 50%:b.ngc", "2", "14", "21"),
        ("error", "a, 50%:b.ngc", "3", "8", "9"),
        ("error", "calls.ngc", "5", "12", "20"),
        ("notice", "sub/lower.z32", "2", "1", "2"),
    ]
    assert found[0][1]["title"] == "deburr (rs274.comment-nested)"
    # The argument is 1, so the loop counts 4, 3, 2.
    assert found[2][2].split("\n")[1:] == [
        "calls.ngc:4:1: in pass 3 of the loop that starts here",
        "calls.ngc:10:1: called here",
    ]


def test_github_is_told_the_columns_of_one_line_only(shell, monkeypatch):
    from io import StringIO

    from deburr.cli.reporters import github
    from deburr.cli.result import Result
    from deburr.cli.run import Outcome
    from deburr.cli.style import Style
    from deburr.finding import Finding, Place, Severity

    monkeypatch.setenv("GITHUB_WORKSPACE", str(shell.folder.parent))
    file = f"{shell.folder.as_posix()}/a.ngc"
    finding = Finding("rs274.x-y", Severity.WARNING, "no\x1b[2J", Place(file, 1, 2, 3, 4))
    out = StringIO()
    github.report(Result((Outcome(file, "rs274", "", (finding,)),)), out, Style())
    assert out.getvalue() == (
        f"::warning title=deburr (rs274.x-y),file={shell.folder.name}/a.ngc,line=2,endLine=4::no\u241b[2J\n"
    )


def test_gitlab(folder):
    found = json.loads(reported(folder, "gitlab"))
    check_against("gitlab-code-quality.json", found)
    assert [(each["check_name"], each["severity"], each["location"]["path"]) for each in found] == [
        ("rs274.comment-nested", "major", "a, 50%:b.ngc"),
        ("rs274.divide-by-zero", "major", "a, 50%:b.ngc"),
        ("rs274.divide-by-zero", "major", "calls.ngc"),
        ("z32.lower-case", "info", "sub/lower.z32"),
    ]
    assert found[1]["location"]["positions"] == {"begin": {"line": 3, "column": 8}, "end": {"line": 3, "column": 9}}
    assert len({each["fingerprint"] for each in found}) == 4


def test_gitlab_names_files_from_the_top_of_the_repository(folder, monkeypatch):
    monkeypatch.setenv("CI_PROJECT_DIR", str(folder.folder))
    monkeypatch.chdir(folder.folder / "sub")
    assert [each["location"]["path"] for each in json.loads(reported(folder, "gitlab", 0))] == ["sub/lower.z32"]


def test_sarif(folder):
    said = json.loads(reported(folder, "sarif"))
    check_against("sarif-2.1.0.json", said)
    run = said["runs"][0]
    rules = {rule["id"]: rule for rule in run["tool"]["driver"]["rules"]}
    assert sorted(rules) == ["rs274.comment-nested", "rs274.divide-by-zero", "z32.lower-case"]
    assert "Bad:" in rules["rs274.divide-by-zero"]["help"]["markdown"]
    assert rules["z32.lower-case"]["defaultConfiguration"]["level"] == "note"
    names = [run["tool"]["driver"]["rules"][each["ruleIndex"]]["id"] for each in run["results"]]
    assert names == [each["ruleId"] for each in run["results"]]
    first, _, called, lower = run["results"]
    assert first["locations"][0]["physicalLocation"] == {
        "artifactLocation": {"uri": "a%2C%2050%25%3Ab.ngc", "uriBaseId": "%SRCROOT%"},
        "region": {"startLine": 2, "startColumn": 14, "endLine": 2, "endColumn": 21},
    }
    # From the outside in: the call, the pass of the loop, the fault.
    (flow,) = called["codeFlows"][0]["threadFlows"]
    places = [each["location"]["physicalLocation"]["region"]["startLine"] for each in flow["locations"]]
    assert (places, [each["nestingLevel"] for each in flow["locations"]]) == ([10, 4, 5], [0, 1, 2])
    assert "relatedLocations" not in called and "codeFlows" not in first
    (change,) = lower["fixes"][0]["artifactChanges"]
    assert change["replacements"] == [
        {
            "deletedRegion": {"startLine": 2, "startColumn": 1, "endLine": 2, "endColumn": 2},
            "insertedContent": {"text": "G"},
        }
    ]


def test_sarif_as_a_library_reads_it(folder):
    path = folder.write("out.sarif", reported(folder, "sarif"))
    read = load_sarif_file(str(path))
    assert read.get_distinct_tool_names() == ["deburr"]
    assert {each["Location"] for each in read.get_records()} >= {"calls.ngc", "sub/lower.z32"}
    assert [each["Line"] for each in read.get_records() if each["Location"] == "calls.ngc"] == [5]


def marks(shell) -> dict[str, list[str]]:
    """The fingerprints in SARIF, by file."""
    found: dict[str, list[str]] = {}
    for each in json.loads(shell.run("check", "--output-format", "sarif").out)["runs"][0]["results"]:
        uri = each["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        found.setdefault(uri, []).append(each["partialFingerprints"]["deburr/v1"])
    return found


def test_fingerprints_survive_that_lines_move(folder):
    before = marks(folder)
    for name in ("calls.ngc", "sub/lower.z32"):
        head, _, rest = PROGRAMS[name].partition("\n")
        folder.write(name, head + "\n" + "(one more)\n" * 100 + rest.replace("    ", "  "))
    assert marks(folder) == before


def test_fingerprints_tell_equal_lines_and_rules_apart(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X[1/0] Y[1/0]\nG0 X[1/0]\nG0  X[1/0]\n(a (b) c)\nF100\nM2\n")
    (found,) = marks(shell).values()
    assert len(set(found)) == 5
    first, second, third, fourth, fifth = found
    assert [each.partition(":")[2] for each in found] == ["1", "2", "1", "2", "1"]
    assert first.partition(":")[0] == second.partition(":")[0] != third.partition(":")[0] == fourth.partition(":")[0]
    assert fifth.partition(":")[0] not in (first.partition(":")[0], third.partition(":")[0])


def test_sarif_says_what_could_not_be_checked(shell):
    shell.write("a.ngc", "G21\0G90\nM2\n")
    ran = shell.run("check", "--output-format", "sarif")
    said = json.loads(ran.out)
    check_against("sarif-2.1.0.json", said)
    (invocation,) = said["runs"][0]["invocations"]
    assert ran.code == 2 and not invocation["executionSuccessful"]
    assert "NUL" in invocation["toolExecutionNotifications"][0]["message"]["text"]


def test_junit(folder):
    folder.write("out.xml", reported(folder, "junit"))
    read = junitparser.JUnitXml.fromfile(str(folder.folder / "out.xml"))
    suites = {suite.name: suite for suite in read}
    assert (read.tests, read.failures, read.errors) == (5, 3, 0)
    assert [suite.failures for suite in suites.values()] == [2, 1, 0, 0]
    assert [case.is_passed for case in suites["right.ngc"]] == [True]
    (lower,) = suites["sub/lower.z32"]
    assert lower.is_passed and "z32" in lower.name and "lower.z32:2:1: info" in lower.system_out
    (called,) = suites["calls.ngc"]
    assert called.result[0].type == "rs274.divide-by-zero"
    assert called.result[0].text.split("\n")[2] == "calls.ngc:10: called here"


def test_junit_counts_as_the_exit_code_does(folder):
    ran = folder.run("check", "--output-format", "junit", "--fail-on", "info")
    assert junitparser.JUnitXml.fromstring(ran.out.encode()).failures == 4


def test_junit_holds_what_xml_cannot(shell):
    shell.write("a.ngc", "G21 \ufffe\x01\nM2\n")
    shell.write("b.ngc", "G21\0G90\nM2\n")
    ran = shell.run("check", "--output-format", "junit")
    read = junitparser.JUnitXml.fromstring(ran.out.encode())
    assert (ran.code, read.errors) == (2, 1) and read.failures >= 1


def test_several_forms_at_once(folder):
    forms = {"sarif": "o.sarif", "gitlab": "o.json", "junit": "o.xml"}
    asked = [word for form, file in forms.items() for word in ("--output-format", f"{form}={file}")]
    ran = folder.run("check", *asked, "--output-format", "github")
    assert ran.out == reported(folder, "github")
    for form, file in forms.items():
        assert (folder.folder / file).read_text(encoding="utf-8") == reported(folder, form)
    assert folder.run("check", "--output-format", "gitlab", "--output-file", "again.json").out == ""
    assert (folder.folder / "again.json").read_bytes() == (folder.folder / "o.json").read_bytes()


@pytest.mark.parametrize("form", ["github", "gitlab", "sarif", "junit"])
def test_nothing_found_is_a_whole_report(shell, form):
    shell.write("a.ngc", "G21\nM2\n")
    out = reported(shell, form, 0)
    if form == "sarif":
        check_against("sarif-2.1.0.json", json.loads(out))
    assert {"github": "", "gitlab": "[]\n"}.get(form, out) == out
