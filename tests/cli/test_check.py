"""`deburr check`: flags, exit codes, which files, what is said where."""

import json
import os
import pickle
import signal

import pytest

from deburr.cli.files import targets
from deburr.cli.run import Checker, Options
from deburr.configfile import Configs

CLEAN = "G21 G90 G17\nG0 X1\nF100\nM2\n"
FAULTY = "G21 G90 G17\nG0 X[1/0]\nF100\nM2\n"
ZERO = "rs274.divide-by-zero"


def lines(shell, *arguments, **more):
    """The findings as `file:row:col: severity rule`, and the exit code."""
    ran = shell.run("check", "--output-format", "concise", "-q", *arguments, **more)
    return [" ".join(line.split(" ")[:3]) for line in ran.out.splitlines()], ran.code


def test_exit_codes(shell):
    shell.write("clean.ngc", CLEAN)
    shell.write("faulty.ngc", FAULTY)
    assert lines(shell, "clean.ngc") == ([], 0)
    assert lines(shell, "faulty.ngc") == ([f"faulty.ngc:2:8: error {ZERO}"], 1)
    assert lines(shell, "faulty.ngc", "--exit-zero") == ([f"faulty.ngc:2:8: error {ZERO}"], 0)
    assert lines(shell, "nothing.ngc") == ([], 2)
    assert shell.run("check", "--nonsense").code == 2


def test_an_unreadable_path_does_not_keep_the_others_from_being_checked(shell):
    shell.write("faulty.ngc", FAULTY)
    ran = shell.run("check", "nothing.ngc", "faulty.ngc", "--output-format", "concise", "--exit-zero")
    assert ran.code == 2
    assert ran.err == "deburr: error: nothing.ngc: no such file or folder\n"
    assert ran.out.splitlines()[0].startswith("faulty.ngc:2:8: error")
    assert ran.out.splitlines()[-1] == "Found 1 error in 1 file (1 checked, 1 not checked)"


@pytest.mark.parametrize(
    ("level", "severity", "code"),
    [
        ("error", "error", 1),
        ("error", "warning", 0),
        ("warning", "warning", 1),
        ("warning", "info", 0),
        ("info", "info", 1),
    ],
)
def test_fail_on(shell, level, severity, code):
    shell.write("deburr.toml", f'[check.severity]\n"{ZERO}" = "{severity}"\n')
    shell.write("a.ngc", FAULTY)
    assert lines(shell, "a.ngc", "--fail-on", level) == ([f"a.ngc:2:8: {severity} {ZERO}"], code)


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (["--select", ZERO], True),
        (["--select", "rs274"], True),
        (["--select", "ALL"], True),
        (["--select", "rs274.divide,rs274.comment"], True),
        (["--select", "rs274.comment"], False),
        (["--select", "rs274.comment", "--extend-select", ZERO], True),
        (["--select", "rs274.comment", "--select", ZERO], True),
        (["--ignore", ZERO], False),
        (["--ignore", "rs274"], False),
        (["--ignore", "rs274", "--extend-select", ZERO], True),
        (["--select", ZERO, "--ignore", ZERO], False),
        (["--select", "ALL", "--ignore", "rs274.divide"], False),
    ],
)
def test_selection(shell, arguments, found):
    shell.write("a.ngc", FAULTY)
    assert lines(shell, "a.ngc", *arguments) == (([f"a.ngc:2:8: error {ZERO}"], 1) if found else ([], 0))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--select", "rs274.divide-by-zer"],
            "--select: `rs274.divide-by-zer` is no rule; did you mean `rs274.divide-by-zero`?",
        ),
        (["--ignore", "rs275"], "--ignore: `rs275` is no rule; did you mean `rs274`?"),
        (["--extend-select", "rs274.div"], "--extend-select: `rs274.div` is no rule"),
        (["--dialect", "rs247"], "--dialect: `rs247` is no dialect; did you mean `rs274`?"),
        (["--output-format", "jsn"], "--output-format: `jsn` is no format; did you mean `json`?"),
        (["--profile", "smity"], "--profile: no dialect has a profile `smity`; did you mean `smithy`?"),
        (["--fail-on", "fatal"], "--fail-on: `fatal` is none of error, warning, info"),
        (["-j", "0"], "-j/--jobs: `0` is no number of processes"),
        (["-q", "-v"], "-v/--verbose: not allowed with argument -q/--quiet"),
        (
            ["--output-format", "json", "--output-format", "full"],
            "--output-format: two reports go to standard output; write FORMAT=FILE",
        ),
        (["--config", "nothing.toml"], "nothing.toml: No such file or directory"),
        (["--select", ""], "--select: an empty text names no rule"),
        (["--ignore", " , "], "--ignore: an empty text names no rule"),
        (["--select", "rs274."], "--select: `rs274.` is no rule; did you mean `rs274`?"),
    ],
)
def test_usage_errors(shell, arguments, message):
    shell.write("a.ngc", CLEAN)
    ran = shell.run("check", "a.ngc", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err


def test_profile(shell):
    shell.write("a.ngc", f"G21 G90 G17\n({'x' * 252})\nF100\nM2\n")
    assert lines(shell, "a.ngc", "--select", "rs274.line-too-long") == (["a.ngc:2:253: error rs274.line-too-long"], 1)
    assert lines(shell, "a.ngc", "--select", "rs274.line-too-long", "--profile", "smithy") == ([], 0)


def test_no_run_is_accepted(shell):
    shell.write("a.ngc", CLEAN)
    assert lines(shell, "a.ngc", "--no-run") == ([], 0)


def test_folders_are_searched_by_extension_and_gitignore(shell):
    for name in (
        "a.ngc",
        "B.NGC",
        "sub/c.ngc",
        "sub/deep/d.ngc",
        "out/e.ngc",
        "node_modules/f.ngc",
        "g.py",
        "sub/h.ngc",
    ):
        shell.write(name, FAULTY)
    shell.write(".gitignore", "/out/\nh.ngc\n")
    shell.write("sub/deep/.gitignore", "!d.ngc\n")
    shell.write("sub/.gitignore", "deep/x\n")
    assert lines(shell) == (
        [f"{name}:2:8: error {ZERO}" for name in ("B.NGC", "a.ngc", "sub/c.ngc", "sub/deep/d.ngc")],
        1,
    )
    assert lines(shell, "sub/deep", "a.ngc", "./a.ngc")[0] == [
        f"{name}:2:8: error {ZERO}" for name in ("a.ngc", "sub/deep/d.ngc")
    ]
    assert lines(shell, "out/e.ngc")[0] == [f"out/e.ngc:2:8: error {ZERO}"]


def test_gitignore_above_the_folder_counts_inside_a_repository_only(shell):
    shell.write("work/.gitignore", "skipped.ngc\n")
    shell.write("work/part/skipped.ngc", FAULTY)
    assert lines(shell, "work/part")[1] == 1
    (shell.folder / "work/.git").mkdir()
    assert lines(shell, "work/part")[1] == 0


def test_no_programs_found(shell):
    ran = shell.run("check")
    assert ran == (0, "No findings (0 checked)\n", "deburr: warning: no programs found under the given paths\n")


def test_a_shared_extension_without_evidence(shell):
    shell.write("a.nc", "G21 G90\nG0 X1\nM30\n")
    shell.write("b.ngc", CLEAN)
    ran = shell.run("check", ".")
    assert ran == (0, "All checks passed (1 checked, 1 skipped: no dialect)\n", "")
    ran = shell.run("check", "a.nc", "b.ngc")
    assert (ran.code, ran.out) == (2, "No findings (1 checked, 1 not checked)\n")
    assert ran.err.startswith("deburr: error: a.nc: the extension .nc is shared by many controls")
    assert "say which with --dialect" in ran.err
    assert shell.run("check", "a.nc", "--dialect", "rs274").code == 0


def test_quiet_and_verbose(shell):
    shell.write("a.ngc", CLEAN)
    shell.write("b.nc", CLEAN)
    assert shell.run("check", "-q") == (0, "", "")
    ran = shell.run("check", "-v", "--no-cache", ".")
    assert ran.out == "All checks passed (1 checked, 1 skipped: no dialect)\n"
    first, second = ran.err.splitlines()
    assert first == "deburr: a.ngc: rs274 (the extension .ngc), no configuration"
    assert second.startswith("deburr: b.nc: skipped, the extension .nc is shared")


@pytest.mark.parametrize(
    ("name", "program", "said"),
    [
        ("p.ngc", "#1=1\nG0 X#5061\nM2\n", "run stopped at p.ngc:2: "),
        ("p.z32", "%\nG0 X<HA>\nM30\n", "run stopped at p.z32:2: `HA` has no value yet"),
    ],
)
def test_verbose_says_where_a_run_stopped(shell, name, program, said):
    shell.write(name, program)
    ran = shell.run("check", "-v", name)
    _, stopped = ran.err.splitlines()
    assert ran.code == 0 and stopped.startswith(f"deburr: {name}: {said}")
    given = ["-D", "HA=1"] if name == "p.z32" else ["--no-run"]
    assert "stopped" not in shell.run("check", "-v", name, *given).err


def test_verbose_says_which_moves_are_not_certain(shell):
    shell.write("deburr.toml", "[machine]\nlimits = { X = [0, 300] }\n")
    for name in ("a.z32", "b.z32"):
        shell.write(name, "%\nG0 X1\nG70 G0 X400\nM30\n")
    expected = [
        f"deburr: {name}: moves are not certain at {name}:3: G70 may set the unit" for name in ("a.z32", "b.z32")
    ]
    for _ in ("anew", "known from an earlier check"):
        ran = shell.run("check", "-v")
        assert ran.code == 0
        assert [line.partition(";")[0] for line in ran.err.splitlines() if "not certain" in line] == expected
    assert "not certain" not in shell.run("check").err


def test_standard_input(shell):
    assert lines(shell, "-", "--dialect", "rs274", stdin=FAULTY.encode()) == ([f"-:2:8: error {ZERO}"], 1)
    named = [f"sub/x.ngc:2:8: error {ZERO}"]
    assert lines(shell, "-", "--stdin-filename", "sub/x.ngc", stdin=FAULTY.encode()) == (named, 1)
    assert lines(shell, "--stdin-filename", "sub/x.ngc", stdin=FAULTY.encode()) == (named, 1)
    assert lines(shell, "-", stdin=b"#<x>=[1/0]\nM2\n")[0] == [f"-:1:9: error {ZERO}"]
    ran = shell.run("check", "-", stdin=b"G0 X1\n")
    assert (ran.code, ran.err.startswith("deburr: error: -: the text has no name, and nothing in it")) == (2, True)


def test_standard_input_has_the_configuration_of_its_name(shell):
    shell.write("sub/deburr.toml", f'[check]\nignore = ["{ZERO}"]\n')
    assert lines(shell, "-", "--stdin-filename", "sub/x.ngc", stdin=FAULTY.encode()) == ([], 0)
    assert lines(shell, "-", "--stdin-filename", "x.ngc", stdin=FAULTY.encode())[1] == 1


def test_statistics(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X[1/0] Y[2/0]\nG0 X1 (a (b) c)\nF100\nM2\n")
    ran = shell.run("check", "--statistics")
    rows = [line.split("\t")[:3] for line in ran.out.splitlines()[:-1]]
    assert rows == [["2", ZERO, "error"], ["1", "rs274.comment-nested", "error"]]
    assert ran.out.splitlines()[-1] == "Found 3 errors in 1 file (1 checked)"
    assert ran.code == 1
    found = json.loads(shell.run("check", "--statistics", "--output-format", "json").out)
    assert [(row["rule"], row["severity"], row["count"]) for row in found] == [
        (ZERO, "error", 2),
        ("rs274.comment-nested", "error", 1),
    ]
    assert found[0]["summary"].endswith(".")
    single = shell.run("check", "--statistics", "--output-format", "json-lines").out.splitlines()
    assert [json.loads(line) for line in single] == found


def test_outputs_into_files(shell):
    shell.write("a.ngc", FAULTY)
    ran = shell.run(
        "check",
        "--output-format",
        "json=out.json",
        "--output-format",
        "concise=out.log",
        "--output-format",
        "json-lines",
    )
    assert json.loads((shell.folder / "out.json").read_text()) == [json.loads(ran.out)]
    assert (shell.folder / "out.log").read_text().splitlines()[-1] == "Found 1 error in 1 file (1 checked)"
    ran = shell.run("check", "--output-format", "concise", "--output-file", "again.log")
    assert (ran.code, ran.out) == (1, "")
    assert (shell.folder / "again.log").read_text() == (shell.folder / "out.log").read_text()
    assert (
        shell.run("check", "--output-file", "no/such/folder").err
        == "deburr: error: no/such/folder: No such file or directory\n"
    )


@pytest.mark.parametrize(
    "arguments",
    [
        ["a.ngc", "--output-file", "a.ngc"],
        [".", "--output-file", "./sub/../a.ngc"],
        ["a.ngc", "--output-format", "json=link.json"],
        ["a.ngc", "--output-format", "full", "--output-format", "json=a.ngc"],
    ],
)
def test_a_report_is_not_written_over_a_program(shell, arguments):
    shell.write("a.ngc", FAULTY)
    shell.write("sub/b.ngc", CLEAN)
    (shell.folder / "link.json").symlink_to(shell.folder / "a.ngc")
    ran = shell.run("check", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.endswith(": the report would be written over this program\n")
    assert (shell.folder / "a.ngc").read_text() == FAULTY


def test_processes_give_the_same_in_the_same_order(shell):
    for number in range(9):
        shell.write(f"p{number}.ngc", FAULTY * (9 - number))
    one = shell.run("check", "-j", "1")
    assert one.code == 1 and one.out.count("divide-by-zero") > 0
    assert shell.run("check", "-j", "2") == one
    assert shell.run("check", "--jobs", "4") == one


def test_interrupt(shell, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    shell.write("a.ngc", CLEAN)
    monkeypatch.setattr("deburr.cli.run.Checker.outcome", interrupted)
    assert shell.run("check") == (130, "", "")


def test_colours(shell, monkeypatch):
    shell.write("a.ngc", FAULTY)
    assert "\x1b[" not in shell.run("check").out
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert "\x1b[1;31merror[rs274.divide-by-zero]\x1b[0m: \x1b[1m" in shell.run("check").out
    assert "\x1b[" not in shell.run("check", "--output-format", "json").out
    shell.run("check", "--output-file", "plain.log")
    assert "\x1b[" not in (shell.folder / "plain.log").read_text()
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[" not in shell.run("check").out


def test_a_checker_can_be_sent_to_another_process(shell):
    shell.write("deburr.toml", '[files]\n"*.x" = "rs274"\n[check.per-file-ignores]\n"b.x" = ["rs274"]\n')
    for name in ("a.x", "b.x"):
        shell.write(name, FAULTY)
    configs = Configs()
    found = targets(["."], configs)
    checker = pickle.loads(pickle.dumps(Checker(configs, Options())))
    assert [len(checker.outcome(target).findings) for target in found] == [1, 0]


def test_a_process_that_is_ended_from_outside_is_said(shell, monkeypatch):
    def killed(checker, target):
        os.kill(os.getpid(), signal.SIGKILL)

    for name in ("a.ngc", "b.ngc"):
        shell.write(name, "M2\n")
    monkeypatch.setattr("deburr.cli.run.Checker.outcome", killed)
    code, out, err = shell.run("check", "-j", "2")
    assert (code, out) == (2, "")
    assert err.startswith("deburr: error: a process that checked files was ended from outside")
