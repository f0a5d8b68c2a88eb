"""`deburr expand --stats`: bounds, lengths, times and tools, as text and as JSON."""

import json
import math

import pytest

SQUARE = """G21 G90 T2 M6
S1000 M3
#1=30
o1 repeat [2]
G0 X[#1+0.5] Y40
#1=[#1-30]
o1 endrepeat
G1 Z-10 F100
G4 P1.5
G2 X0.5 Y20 I0 J-10 F600
HELLO
M2
"""
RIGHT = SQUARE.replace("HELLO\n", "")


def test_json(shell):
    shell.write("a.ngc", RIGHT)
    shell.write("deburr.toml", "[machine]\nrapid = { X = 3000, Y = 2400 }\n")
    ran = shell.run("expand", "--stats", "json", "a.ngc")
    assert (ran.code, ran.err) == (0, "")
    found = json.loads(ran.out)
    # X goes 30.5 mm and Y 40, one second at its rate; then X goes 30 mm at 3000 mm/min.
    assert found["length"] == {"rapid": round(math.hypot(30.5, 40) + 30, 6), "cut": 41.415927}
    assert found["time"] == {"rapid": 1.6, "cut": 9.141593, "dwell": 1.5, "total": 12.241593}
    assert found["bounds"] == {"X": [0, 30.5], "Y": [0, 40], "Z": [-10, 0]}
    assert found["cut_bounds"] == {"X": [0.5, 10.5], "Y": [20, 40], "Z": [-10, 0]}
    assert (found["lines"], found["moves"], found["arcs"], found["untimed"]) == (8, 4, 1, 0)
    assert found["tools"] == [{"number": 2, "moves": 4, "cut": 41.415927, "time": 10.741593}]
    assert (found["rapid_rates"], found["notes"]) == ({"X": 3000, "Y": 2400}, [])


def test_text(shell):
    shell.write("a.ngc", RIGHT)
    assert shell.run("expand", "--stats", "text", "a.ngc").out.split("\n") == [
        "lines   8",
        "moves   4, arcs among them 1",
        "X       0 to 30.5 mm, cuts 0.5 to 10.5",
        "Y       0 to 40 mm, cuts 20 to 40",
        "Z       -10 to 0 mm, cuts -10 to 0",
        "rapid   80.302 mm in 0:00:01",
        "cut     41.416 mm in 0:00:09",
        "dwell   0:00:02",
        "time    0:00:12, without acceleration; rapids at 5,000 mm/min",
        "tool 2  4 moves, 41.416 mm cut, 0:00:10",
        "",
    ]


def test_the_program_is_written_too_where_it_has_a_file(shell):
    shell.write("a.ngc", RIGHT)
    flat = shell.run("expand", "a.ngc").out
    ran = shell.run("expand", "--stats", "json", "-o", "flat.ngc", "a.ngc")
    assert json.loads(ran.out)["moves"] == 4
    assert (shell.folder / "flat.ngc").read_text() == flat


def test_a_faulty_program_has_none(shell):
    shell.write("a.ngc", SQUARE)
    ran = shell.run("expand", "--stats", "json", "a.ngc")
    assert (ran.code, ran.out) == (1, "")


def test_what_is_passed_over_is_noted(shell):
    shell.write("a.mgc", "G0 X1 Y1\nG117 X5\nM30\n")
    assert shell.run("expand", "--stats", "text", "a.mgc").out.split("\n")[-2:] == [
        "note    line 2: G117 is not followed",
        "",
    ]
    assert json.loads(shell.run("expand", "--stats", "json", "a.mgc").out)["notes"] == [
        {"line": 2, "message": "G117 is not followed"}
    ]


def test_cutter_compensation_is_noted(shell):
    shell.write("a.ngc", "G21 G90 G17 F100\nG42.1 D2\nG1 X20 Y0\nY50\nG40\nM2\n")
    notes = json.loads(shell.run("expand", "--stats", "json", "a.ngc").out)["notes"]
    assert [(note["line"], note["message"].partition(":")[0]) for note in notes] == [
        (2, "cutter compensation is not applied")
    ]


@pytest.mark.parametrize("options", [("--stats",), ("--stats", "xml"), ("--stats", "json", "--diff", "a.ngc")])
def test_what_is_refused(shell, options):
    shell.write("a.ngc", RIGHT)
    ran = shell.run("expand", "a.ngc", *options)
    assert (ran.code, ran.out) == (2, "")


def test_the_help_says_what_becomes_of_the_program(shell):
    said = " ".join(shell.run("expand", "--help").out.split())
    assert (
        "print bounds, lengths, estimated times and tools of the flat program in its place; with -o it is written, too"
        in said
    )


@pytest.mark.parametrize("dialect", ["rs274", "metagcode", "z32"])
def test_an_empty_program_has_no_lines(shell, dialect):
    shell.write("a.txt", "")
    ran = shell.run("expand", "--dialect", dialect, "--stats", "text", "a.txt")
    assert (ran.code, ran.out.splitlines()[:2]) == (0, ["lines   0", "moves   0, arcs among them 0"])


@pytest.mark.parametrize("dialect", ["rs274", "metagcode"])
@pytest.mark.parametrize("text", ["\n", "\n\n", "\r\n \r\n"])
def test_blank_lines_expand_to_themselves(shell, dialect, text):
    path = shell.write("a.txt", text)
    assert shell.run("expand", "--dialect", dialect, "a.txt", "-o", "flat").code == 0
    assert (shell.folder / "flat").read_bytes() == path.read_bytes()
