"""`deburr expand`: its options in every language, budgets, interrupts, and what stands behind each hunk of a comparison."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from time import sleep

import pytest

METAGCODE = "#LOOP1 |z| 2 c\nG1 Z|z|\n#ENDLOOP1\nM30\n"
Z32 = "HA0\nN10 G1 X<HA/3>\n!HA=HA+1; IF HA<5; GON10!\nM30\n"
CGT = "@LINE\n#REPEAT(#V1)<\nX#XPOS\n>\n@\n@END\nM30\n@\n"


def write(shell, **more: str) -> None:
    """One program of each language with what it needs."""
    programs = {"p.mgc": METAGCODE, "p.z32": Z32, "p.cgt": CGT, "p.cl": "GOTO/1,0,0\nFINI\n", **more}
    for name, text in programs.items():
        shell.write(name, text)


@pytest.mark.parametrize(
    ("arguments", "where"),
    [
        (("p.mgc", "-D", "z=10"), "pass 3 of 5 of `#LOOP1` with `|z|` = `6`"),
        (("p.z32",), "pass 3 of the loop from line 2 to `!HA=HA+1; IF HA<5; GON10!` of line 3 with `HA` = 2"),
        (("p.cgt", "--input", "p.cl", "-D", "V1=5"), "pass 3 of 5 of `#REPEAT(#V1)` in line 2"),
    ],
)
def test_a_budget_of_flat_lines_names_the_loop_and_its_last_values(shell, arguments, where):
    write(shell)
    ran = shell.run("expand", *arguments, "--max-blocks", "2", "-o", "flat")
    assert ran.code == 1 and not (shell.folder / "flat").exists()
    said = f"the flat program has more than 2 lines, last in {where}; --max-blocks sets another limit"
    assert said in ran.err and ran.err.endswith("deburr: nothing was written: 1 error\n")
    ran = shell.run("expand", *arguments, "--max-blocks", "2", "--partial")
    assert len(ran.out.splitlines()) == 2 and ran.code == 1
    assert ran.err.endswith("deburr: only 2 lines were written: 1 error\n")
    assert shell.run("expand", *arguments, "--max-blocks", "0").code == 0
    assert shell.run("expand", *arguments, "--max-blocks", "6").code == 0


@pytest.mark.parametrize(
    ("arguments", "where"),
    [
        (("p.mgc", "-D", "z=10"), "pass 4 of 5 of `#LOOP1` with `|z|` = `8`"),
        (("p.z32",), "pass 3 of the loop from line 2 to `!HA=HA+1; IF HA<5; GON10!` of line 3 with `HA` = 3"),
        (("p.cgt", "--input", "p.cl", "-D", "V1=5"), "pass 3 of 5 of `#REPEAT(#V1)` in line 2"),
    ],
)
def test_a_budget_of_executed_lines_names_the_loop_and_its_last_values(shell, arguments, where):
    write(shell)
    ran = shell.run("expand", *arguments, "--max-steps", "7")
    assert (ran.code, ran.out) == (1, "")
    assert f"more than 7 lines were executed, last in {where}; --max-steps sets another limit" in ran.err
    assert shell.run("expand", *arguments, "--max-steps", "0").code == 0


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (("p.mgc", "--block-delete", "on"), "--block-delete"),
        (("p.mgc", "--keep-n"), "--keep-n"),
        (("p.mgc", "--machine-values", "simulate"), "--machine-values"),
        (("p.z32", "--machine-values", "simulate"), "--machine-values"),
        (("p.cgt", "--input", "p.cl", "--decimals", "2"), "--decimals"),
        (("p.cgt", "--input", "p.cl", "--block-delete", "off"), "--block-delete"),
        (("p.mgc", "--input", "p.cl"), "--input"),
        (("p.mgc", "--parameters", "p.cl"), "--parameters"),
        (("p.z32", "--tool-table", "p.cl"), "--tool-table"),
    ],
)
def test_an_option_that_the_language_does_not_follow_is_refused(shell, arguments, option):
    write(shell)
    ran = shell.run("expand", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"deburr: error: {option}: ") and ran.err.count("\n") == 1


@pytest.mark.parametrize("text", ["# values\nHA=1.5\nPAR[2] = 7\n", '{"HA": 1.5, "PAR[2]": "7"}'])
def test_a_file_of_values_serves_every_language(shell, text):
    shell.write("p.z32", "X<HA> Y<PAR[2]>\nM30\n")
    shell.write("v", text)
    assert shell.run("expand", "p.z32", "--variables", "v") == (0, "X1.5 Y7\nM30\n", "")
    assert shell.run("expand", "p.z32", "--variables", "v", "-D", "HA=2").out == "X2 Y7\nM30\n"
    shell.write("q.z32", "X<1/(HA-1.5)>\nM30\n")
    assert shell.run("check", "q.z32").code == 0
    assert "z32.divide-by-zero" in shell.run("check", "q.z32", "--variables", "v").out


def test_a_line_of_values_that_cannot_be_used_is_named(shell):
    shell.write("p.z32", "X<HA>\nM30\n")
    shell.write("v", "HA=1\n\n  HB 2\nHA=3\n")
    said = "deburr: error: v:3:3: `HB 2` has no `=`\ndeburr: error: v:4:1: `HA` has another value on line 1\n"
    for command in ("expand", "check"):
        assert shell.run(command, "p.z32", "--variables", "v") == (2, "", said)


def test_decimals(shell):
    write(shell)
    assert shell.run("expand", "p.z32", "--decimals", "2").out.splitlines()[1] == "G1 X0.33"
    assert shell.run("expand", "p.z32").out.splitlines()[1] == "G1 X0.333333"
    # The control takes no more than nine digits.
    assert shell.run("expand", "p.z32", "--decimals", "exact").out.splitlines()[1] == "G1 X0.333333333"
    loop = ("expand", "p.mgc", "-D", "z=10", "-D", "s=3.5")
    shell.write("p.mgc", METAGCODE.replace("2 c", "|s| c"))
    assert shell.run(*loop).out.splitlines()[0] == "G1 Z3.3333"
    assert shell.run(*loop, "--decimals", "1").out.splitlines()[:2] == ["G1 Z3.3", "G1 Z6.7"]
    assert shell.run(*loop, "--decimals", "0").out.splitlines()[:2] == ["G1 Z3", "G1 Z7"]


@pytest.mark.parametrize(("eol", "end"), [("lf", b"\n"), ("crlf", b"\r\n"), ("source", b"\r\n")])
def test_line_ends(shell, eol, end):
    shell.write("p.mgc", METAGCODE.replace("\n", "\r\n"))
    assert shell.run("expand", "p.mgc", "-D", "z=4", "--eol", eol, "-o", "flat").code == 0
    assert (shell.folder / "flat").read_bytes() == end.join((b"G1 Z2", b"G1 Z4", b"M30", b""))


def test_the_switch_for_optional_lines(shell):
    shell.write("p.z32", "G0 X1\n/!HA=1!\n/N5 G0 Y2\nM30\n")
    assert shell.run("expand", "p.z32", "--block-delete", "on").out == "G0 X1\nM30\n"
    assert shell.run("expand", "p.z32", "--block-delete", "off", "--keep-n").out == "G0 X1\nN5 G0 Y2\nM30\n"
    ran = shell.run("expand", "p.z32")
    assert ran.code == 1 and "z32.optional-state" in ran.err and "--> p.z32:2:1" in ran.err


@pytest.mark.parametrize(
    ("name", "text", "place"),
    [
        ("part.jsonl", '{"section": "LINE"}\n{"section": 5}\n', "part.jsonl:2:13"),
        ("part.jsonl", '{"section": "LINE", "set": {"NOPE": 1}}\n', "part.jsonl:1:29"),
        ("part.jsonl", '{"section": "LINE"\n', "part.jsonl:1:"),
        ("part.jsonl", "[]\n", "part.jsonl:1:1"),
        ("part.cl", "GOTO/1,2\n", "part.cl:1:1"),
        ("part.cl", "GOTO/1,2,3\nCIRCLE/0,0,0,1,1,0,2\n", "part.cl:2:14"),
    ],
)
def test_what_is_wrong_with_a_toolpath_is_said_there(shell, name, text, place):
    shell.write("p.cgt", "@LINE\nG1\n@\n@END\nM30\n@\n")
    shell.write(name, text)
    ran = shell.run("expand", "p.cgt", "--input", name, "-o", "flat")
    assert (ran.code, ran.out) == (1, "") and not (shell.folder / "flat").exists()
    assert "error[cgt.cl-syntax]" in ran.err and f"--> {place}" in ran.err


def test_statements_that_are_not_read_are_a_warning(shell):
    shell.write("p.cgt", "@LINE\nX#XPOS\n@\n@END\nM30\n@\n")
    shell.write("part.cl", "GOTO/1,2,3\nMULTAX/ON\nTLAXIS/0,0,1\nGOTO/2,2,3\nMULTAX/OFF\nFINI\n")
    ran = shell.run("expand", "p.cgt", "--input", "part.cl")
    assert (ran.code, ran.out) == (0, "X1.0\nX2.0\nM30\n")
    assert ran.err.count("warning[cgt.cl-unknown]") == 2
    assert "`MULTAX` is no statement that is read, so it is ignored (also on 1 more line)" in ran.err
    assert shell.run("expand", "p.cgt", "--input", "part.cl", "-q").err == ""


@pytest.mark.parametrize("output", ["no/flat", "folder", "shut/flat"])
def test_what_cannot_be_written_leaves_nothing_behind(shell, output):
    write(shell)
    (shell.folder / "folder").mkdir()
    (shell.folder / "shut").write_text("no folder")
    before = sorted(shell.folder.rglob("*"))
    for option in ("-o", "--source-map"):
        ran = shell.run("expand", "p.z32", option, output)
        assert ran.code == 2 and ran.err.startswith("deburr: error: ") and output in ran.err
        assert ran.err.count("\n") == 1
    assert sorted(shell.folder.rglob("*")) == before


def test_an_interrupt_leaves_nothing_behind(shell, monkeypatch):
    write(shell)
    shell.write("flat", "as it was\n")

    def interrupted(job):
        job.emit("G1 X0", "p.z32", 0, None)
        yield
        raise KeyboardInterrupt

    monkeypatch.setattr("deburr.cli.flat.drive", interrupted)
    arguments = ("expand", "p.z32", "-o", "flat", "--source-map", "map", "--partial")
    assert shell.run(*arguments) == (130, "", "")
    assert (shell.folder / "flat").read_text() == "as it was\n"
    assert sorted(path.name for path in shell.folder.iterdir()) == ["flat", "p.cgt", "p.cl", "p.mgc", "p.z32"]


def test_a_signal_ends_an_endless_run(shell):
    shell.write("p.z32", "N5\nN10 G1 X1\n!GON10!\n")
    command = [sys.executable, "-m", "deburr", "expand", "p.z32", "--max-steps", "0", "--max-blocks", "0", "-o", "flat"]
    with subprocess.Popen(
        command,
        cwd=shell.folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        # A shell that puts the tests into the background lets all that they start ignore it.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as running:
        # Once its temporary file is open, the run is under way.
        held = Path(f"/proc/{running.pid}/fd")
        while running.poll() is None and not any(_is_nameless(each) for each in held.iterdir()):
            sleep(0.01)
        running.send_signal(signal.SIGINT)
        assert running.stderr is not None
        assert (running.stderr.read(), running.wait()) == (b"", 130)
    assert sorted(path.name for path in shell.folder.iterdir()) == ["p.z32"]


def _is_nameless(descriptor: Path) -> bool:
    try:
        return "(deleted)" in os.readlink(descriptor)  # noqa: PTH115  It leads to no path.
    except OSError:
        return False


@pytest.mark.parametrize("terminal", [True, False])
def test_only_a_terminal_sees_a_long_run(shell, monkeypatch, terminal):
    shell.write("p.z32", "HA0\nN10 G1 X<HA>\n!HA=HA+1; IF HA<5000; GON10!\nM30\n")
    monkeypatch.setattr("deburr.cli.flat._PATIENCE", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal, raising=False)
    ran = shell.run("expand", "p.z32")
    assert ran.code == 0 and len(ran.out.splitlines()) == 5001
    assert ("\rdeburr: 10,000 lines run, 5,000 written" in ran.err) is terminal is bool(ran.err)


def test_each_hunk_says_where_its_first_difference_comes_from(shell):
    lines = [f"G0 X{at}" for at in range(20)]
    shell.write("a.mgc", "\n".join([*lines, "#LOOP1 |z| 2 c", "G1 Z|z|", "#ENDLOOP1", ""]))
    shell.write("b.mgc", "\n".join(["G0 Y1", *lines, "#LOOP1 |z| 3 c", "G1 Z|z|", "#ENDLOOP1", ""]))
    ran = shell.run("expand", "a.mgc", "--diff", "b.mgc", "-D", "z=6")
    assert (ran.code, ran.err) == (1, "")
    hunks = [line for line in ran.out.splitlines() if line.startswith("@@")]
    assert hunks == [
        "@@ -1,3 +1,4 @@ a.mgc:1 | b.mgc:1",
        "@@ -18,6 +19,5 @@ a.mgc:22 <- a.mgc:21 (loop 1) | b.mgc:23 <- b.mgc:22 (loop 1)",
    ]
    changes = [line for line in ran.out.splitlines() if line[0] in "+-" and line[:3] not in ("+++", "---")]
    assert changes == ["+G0 Y1", "-G1 Z2", "-G1 Z4", "+G1 Z3"]


def test_test_steps_are_joined_in_the_order_of_the_command_line(shell):
    shell.write("1.mgc", "G0 X0\n#LOOP1 |z| 2 c\n")
    shell.write("2.mgc", "G1 Z|z|\n#ENDLOOP1")
    shell.write("3.mgc", "M30\n")
    ran = shell.run("expand", "1.mgc", "2.mgc", "3.mgc", "-D", "z=4", "--source-map", "m", "-o", "flat")
    assert ran.code == 0 and "metagcode.block-crosses-file" in ran.err
    assert (shell.folder / "flat").read_text() == "G0 X0\nG1 Z2\nG1 Z4\nM30\n"
    document = json.loads((shell.folder / "m").read_text())
    assert document["sources"] == ["1.mgc", "2.mgc", "3.mgc"] and len(document["x_deburr_lines"]) == 4
