"""`deburr expand` of Z32 programs: given values, switches, settings, and what is refused."""

import json

import pytest

PROGRAM = "%\nN10 HA<HB*2>\nN20 G0 X<HA> ;to\n/N30 G0 Y<PAL[300]>\n!IF HA>4; GON40!\nX<1/0>\nN40 M30\n"


def test_values_are_given_on_the_command_line_and_in_the_configuration(shell):
    shell.write("a.z32", PROGRAM)
    shell.write("deburr.toml", "[z32]\npal = { 300 = 7 }\n")
    assert shell.run("expand", "a.z32", "-D", "HB=3") == (0, "G0 X6\n/G0 Y7\nM30\n", "")
    assert shell.run("expand", "a.z32", "-D", "HB=3", "-D", "PAL[300]=5", "--keep-n") == (
        0,
        "N20 G0 X6\n/N30 G0 Y5\nN40 M30\n",
        "",
    )
    assert shell.run("expand", "a.z32", "-D", "hb=3", "--block-delete", "on").out == "G0 X6\nM30\n"
    assert shell.run("expand", "a.z32", "-D", "HB=3", "--block-delete", "off").out == "G0 X6\nG0 Y7\nM30\n"
    assert shell.run("expand", "a.z32", "-D", "HB=2.12345678", "--decimals", "2").out == "G0 X4.25\n/G0 Y7\nM30\n"


def test_a_value_that_was_not_given_is_refused_by_expand_and_passed_over_by_check(shell):
    shell.write("a.z32", PROGRAM)
    ran = shell.run("expand", "a.z32")
    assert (ran.code, ran.out) == (1, "")
    assert "error[z32.read-before-set]: `HB` has no value yet" in ran.err and "-D HB=" in ran.err
    assert "a.z32:2:8" in ran.err
    shell.write("b.z32", PROGRAM.replace("X<1/0>", "X1"))
    assert shell.run("check", "b.z32").code == 0


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("HB=x", "`x` is no number"),
        ("PI=3", "`PI` is no parameter"),
        ("HBB=3", "`HBB` is no parameter"),
        ("PAL[513]=3", "the index goes from 0 to 512"),
        ("PAL[3]=1.5", "PAL holds integers"),
        ("AA=3", "`AA` is no parameter"),
    ],
)
def test_a_value_that_cannot_be_given_is_said(shell, option, words):
    shell.write("a.z32", PROGRAM)
    ran = shell.run("expand", "a.z32", "-D", "HB=3", "-D", option)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"deburr: error: -D {option}: ") and words in ran.err


def test_only_the_form_of_lines_that_never_run_is_judged(shell):
    shell.write("a.z32", "G0 X1\nM30\nX<1/0>\n!GON99!\n")
    assert shell.run("expand", "a.z32") == (0, "G0 X1\nM30\n", "")
    assert shell.run("check", "a.z32").code == 1
    shell.write("b.z32", "G0 X1\nM30\nX<1/>\n")
    ran = shell.run("expand", "b.z32", "--partial")
    assert (ran.code, ran.out) == (1, "") and "z32.expression-syntax" in ran.err


def test_a_warning_of_check_and_run_is_shown_once(shell):
    shell.write("a.z32", "N1 G0 X0\nN2 !GON3!\nN3 PAL[1]2.5\nM30\n")
    ran = shell.run("expand", "a.z32")
    assert ran.code == 0 and ran.err.count("z32.pal-rounded") == 1


def test_programs_of_the_folders_are_called_and_named_in_the_map(shell):
    shell.write("deburr.toml", '[z32]\ncmos-dir = "cmos"\nfile-root = "root"\n')
    shell.write("cmos/7.z32", "G1 Z<HA> F100\nG26\n")
    shell.write("cmos-temp/7.z32", "G0 Z5\nG26\n")
    shell.write("root/SUBS/DRILL", "!GOP7!\n!GOS7!\nG26\n")
    shell.write("a.z32", "HA-3\nN10 !:L254-SUBS\\DRILL!\n!HA=HA-1; IF HA>-5; GON10!\nM30\n")
    assert shell.run("expand", "a.z32", "-o", "flat.z32", "--source-map", "flat.map") == (0, "", "")
    flat = (shell.folder / "flat.z32").read_text().split("\n")
    assert flat == ["G1 Z-3 F100", "G0 Z5", "G1 Z-4 F100", "G0 Z5", "M30", ""]
    found = json.loads((shell.folder / "flat.map").read_text())
    source, row, frame = found["x_deburr_lines"][2]
    assert (found["sources"][source], row) == ("cmos/7.z32", 0)
    frames = []
    while frame >= 0:
        frame, source, row, kind, number = found["x_deburr_frames"][frame]
        frames.append((found["sources"][source], row, kind, number))
    assert frames == [("root/SUBS/DRILL", 0, "call", 0), ("a.z32", 1, "file", 0), ("a.z32", 1, "loop", 2)]


def test_a_program_without_end_names_its_loop(shell):
    shell.write("a.z32", "(P)\nHA1\nN10 X<HA>\n!IF HA<2; GON10!\n")
    ran = shell.run("expand", "a.z32", "--max-steps", "3000")
    assert (ran.code, ran.out) == (1, "")
    assert "z32.limit" in ran.err and "of the loop from line 3 to `!IF HA<2; GON10!` of line 4 with `HA` = 1" in ran.err
    assert shell.run("check", "a.z32").code == 0
