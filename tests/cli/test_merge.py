"""`--shard` and `deburr merge`: the parts together say what one check says."""

import json

import pytest

from deburr.catalogue import rule_names

CALLS = "G21 G90 G17\nF100\no<shared> call [{}]\nM2\n"
SHARED = "o<shared> sub\nG0 X[1/[#1-3]] (a (b) c)\no<shared> endsub\nM2\n"
FORMS = ("json", "json-lines", "full", "concise", "github", "gitlab", "sarif", "junit")


@pytest.fixture
def archive(shell):
    for number in range(5):
        shell.write(f"p{number}.ngc", CALLS.format(number))
        shell.write(f"q{number}.z32", "(P)\ng0 X1\nG0 Y<SIN(30)>\nM30\n"[: 12 + 4 * number])
    shell.write("shared.ngc", SHARED)
    return shell


def parts(shell, count: int, form: str = "json") -> list[str]:
    names = [f"{number}.{form}" for number in range(1, count + 1)]
    for number, name in enumerate(names, 1):
        shell.run("check", "--shard", f"{number}/{count}", "--output-format", f"{form}={name}")
    return names


@pytest.mark.parametrize("count", [1, 4, 20])
def test_the_parts_are_the_whole(archive, count):
    whole = archive.run("check", "--output-format", "json")
    assert len(json.loads(whole.out)) > 8
    merged = archive.run("merge", *parts(archive, count), "--output-format", "json")
    assert (merged.code, merged.out) == (whole.code, whole.out)


def test_every_program_is_in_one_part(archive):
    files = [archive.run("check", "--shard", f"{number}/3", "-v").err.splitlines() for number in (1, 2, 3)]
    assert sorted(line.split(":")[1] for part in files for line in part if "run stopped" not in line) == sorted(
        f" {path.name}" for path in archive.folder.iterdir()
    )
    assert [len({line.split(":")[1] for line in part}) for part in files] == [4, 4, 3]


@pytest.mark.parametrize("form", FORMS)
def test_every_form_can_be_made_of_parts(archive, form):
    whole = archive.run("check", "--output-format", form).out
    merged = archive.run("merge", *parts(archive, 3, "json-lines"), "--output-format", form).out
    if form in ("full", "concise"):
        assert merged == whole.replace("(11 checked)", "(3 reports)")
    elif form == "junit":
        assert merged.count("<failure") == whole.count("<failure") > 0
    else:
        assert merged == whole


def test_a_baseline_of_all_parts(archive):
    names = parts(archive, 2)
    known = ["--baseline", "known.json"]
    assert archive.run("merge", *names, *known, "--update-baseline").code == 0
    assert archive.run("merge", *names, *known).code == 0
    assert archive.run("check", *known).code == 0
    assert archive.run("check", *known, "--shard", "2/2").code == 0


def test_the_exit_code_is_that_of_one_check(shell):
    shell.write("a.z32", "(P)\ng0 X1\nM30\n")
    names = parts(shell, 2)
    assert shell.run("merge", *names).code == 0
    assert shell.run("merge", *names, "--fail-on", "info").code == 1
    assert shell.run("merge", *names, "--fail-on", "info", "--exit-zero").code == 0


@pytest.mark.parametrize("form", ["json", "json-lines"])
def test_a_missing_part_is_named(archive, form):
    first, second, third = parts(archive, 3, form)
    ran = archive.run("merge", first, third)
    assert (ran.code, ran.out) == (2, "") and "the report of part 2/3 is missing; `deburr check --shard 2/3`" in ran.err
    assert "part 1/3" not in ran.err and "--incomplete merges what there is" in ran.err
    assert archive.run("merge", first, third, "--incomplete").out.endswith("(2 reports)\n")
    assert archive.run("merge", third, first, second).code == archive.run("check").code == 1


def test_a_part_in_which_nothing_is_found_is_missed_too(shell):
    shell.write("a.ngc", "M2\n")
    names = parts(shell, 2)
    assert shell.run("merge", *names) == (0, "No findings (2 reports)\n", "")
    for number, name in enumerate(names, 1):
        ran = shell.run("merge", name)
        assert ran.code == 2 and f"the report of part {3 - number}/2 is missing" in ran.err


@pytest.mark.parametrize("form", ["json", "json-lines"])
def test_a_part_that_could_not_be_checked_is_named(shell, form):
    shell.write("a.ngc", "M2\n")
    shell.write("b.ngc", "M2\n\0M2\n")
    names = parts(shell, 2, form)
    ran = shell.run("merge", *names)
    assert (ran.code, ran.out) == (2, "")
    assert "part 2/2 could not check" in ran.err and "b.ngc: " in ran.err and "a.ngc" not in ran.err
    assert shell.run("merge", *names, "--incomplete").code == 0


def test_parts_of_different_checks_do_not_fit(archive):
    two, three = parts(archive, 2)[0], parts(archive, 3, "json-lines")[1]
    ran = archive.run("merge", two, three)
    assert ran.code == 2 and "of different checks: of 2 parts and of 3 parts" in ran.err


def test_a_report_of_a_part_says_which_one_it_is(archive):
    (name,) = parts(archive, 3)[1:2]
    said = json.loads((archive.folder / name).read_text())
    assert said["shard"] == {"number": 2, "of": 3} and said["failed"] == []
    assert {each["filename"].rpartition("/")[2] for each in said["findings"]} <= {
        "p1.ngc",
        "p4.ngc",
        "q2.z32",
        "shared.ngc",
    }
    assert said["programs"] == 4


@pytest.mark.parametrize("again", ["1.json", "./1.json", "same.json"])
def test_a_report_is_given_once(shell, again):
    shell.write("1.json", "[]")
    shell.write("2.json", "[]")
    (shell.folder / "same.json").symlink_to("1.json")
    assert shell.run("merge", "1.json", "2.json", again) == (
        2,
        "",
        f"deburr: error: {again}: this report is given twice\n",
    )
    assert shell.run("merge", "1.json", "2.json") == (0, "No findings (2 reports)\n", "")


def finding(**changed):
    place = {"row": 1, "column": 1}
    rule = rule_names("rs274")[0]
    said = {"filename": "a.ngc", "dialect": "rs274", "rule": rule, "severity": "error", "message": "no"}
    return {
        **said,
        "location": place,
        "end_location": place,
        "related": [],
        "fingerprint": "0:1",
        "fix": None,
        **changed,
    }


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (None, "1.json: No such file or directory"),
        ("", None),
        ("{", "1.json: no report of"),
        ("[1]", "1.json: no report of"),
        ("[" * 100_000, "1.json: no report of"),
        (json.dumps([finding(severity="fatal")]), "1.json: no report of"),
        (json.dumps([finding(location={"row": 0, "column": 1})]), "1.json: no report of"),
        (json.dumps([finding(related=[{"filename": "b"}])]), "1.json: no report of"),
        (json.dumps([finding(fix={"message": 1, "edits": 2})]), "1.json: no report of"),
        (json.dumps([finding(rule="rs274.nothing")]), "1.json: `rs274.nothing` is no rule of this version"),
        (json.dumps([finding(dialect="klingon")]), "is no rule of this version"),
        ('{"shard": {"number": 3, "of": 2}, "failed": [], "findings": []}', "1.json: no report of"),
        ('{"shard": {"number": true, "of": 2}, "failed": [], "findings": []}', "1.json: no report of"),
        ('{"shard": {"number": 1, "of": 2}, "failed": [], "findings": 5}', "1.json: no report of"),
        ('{"shard": 1, "failed": [], "findings": []}', "1.json: no report of"),
    ],
)
def test_what_is_no_report_is_said(shell, text, message):
    if text is not None:
        shell.write("1.json", text)
    ran = shell.run("merge", "1.json")
    if message is None:
        assert ran == (0, "No findings (1 report)\n", "")
    else:
        assert (ran.code, ran.out) == (2, "") and message in ran.err


@pytest.mark.parametrize("said", ["0/2", "3/2", "1", "a/b", "1/2/3", "-1/2", "1/"])
def test_a_part_that_there_is_not(shell, said):
    ran = shell.run("check", f"--shard={said}")
    assert ran.code == 2 and f"`{said}` is no part of several" in ran.err
