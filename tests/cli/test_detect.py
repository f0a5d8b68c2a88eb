"""Which dialect: the order of those who answer, and programs of controls that are none of ours."""

import pytest

from deburr.detect import SHARED, Answer, Hints, detect
from deburr_grammar.dialects import NAMES, by_name

RS274 = "o<peck> sub\nG0 X#1\no<peck> endsub\nM2\n"
FANUC = """%
O0001 (POCKET)
N10 #101=1 (DIA | D=10 | L=5)
IF[#1EQ2]GOTO10
WHILE[#101LT10]DO1
#101=#101+1
G65 P9010 A1. B2.
M98 P1000 L2
END1
N20 IF [#500 NE #0] THEN #3000=1 (NO TOOL!)
G04 X0.5
M30
%
"""
HAAS = """%
O1234 (BRACKET - OP1!!)
(T1 = 1/2" END MILL)
T1 M06
G00 G90 G54 X-1. Y-1. S5000 M03
G43 H01 Z.1 M08
G83 Z-0.62 F15. R0.1 Q0.175
M97 P100 L3
G103 P1
#100= ABS[#5041]
IF [#100 GT 2] GOTO 5
M30
N100 G91 X.5
M99
%
"""
MARLIN = """;FLAVOR:Marlin
;TIME:1234
; start_gcode = G28 ; {if x}|y|
M104 S200 ; G28
M117 Printing! Hello!
G28 ; home
G92 E0
G1 X10.1 Y20.2 E.035 F1800
M140 S0
"""
SINUMERIK = """N10 G17 G54 ; #<x>
R1=5 R2=R1*2
IF R1<10 GOTOF LABEL1
MSG("Tool change!!")
LABEL1: G1 X=R2 F=R3
CYCLE81(10,0,2,-5)
M30
"""
OKUMA = "OSUB1\nG15 H1\nVC1=5\nIF [VC1 EQ 5] N100\nCALL O1000 LA=1\nN100 M02\n"
HEIDENHAIN = "0 BEGIN PGM TEST MM\n1 L X+10 Y+5 R0 FMAX M3\n2 FN 9: IF +Q1 EQU +3 GOTO LBL 5\n3 END PGM TEST MM\n"
GRBL = "(Header)\nG17 G21 G90\nM3 S1000\n$H\n!\n~\nG1 X1 F100\n"
KLIPPER = "; klipper\nSET_VELOCITY_LIMIT ACCEL=3000\nG1 X1 ; {if foo}\nSTART_PRINT BED_TEMP=60|EXT=200\n"
MANY = "G0 X1\n" * 5
OTHERS = {
    "fanuc": FANUC,
    "haas": HAAS,
    "marlin": MARLIN,
    "sinumerik": SINUMERIK,
    "okuma": OKUMA,
    "heidenhain": HEIDENHAIN,
    "grbl": GRBL,
    "klipper": KLIPPER,
}


@pytest.mark.parametrize("extension", SHARED)
@pytest.mark.parametrize("name", OTHERS)
def test_programs_of_other_controls_are_no_dialect(name, extension):
    assert detect(f"/w/a{extension}", OTHERS[name]).dialect is None


@pytest.mark.parametrize("name", NAMES)
def test_each_dialect_by_its_extension(name):
    for extension in by_name(name).extensions:
        assert detect(f"/w/A{extension.upper()}", "") == Answer(name, f"the extension {extension}")


@pytest.mark.parametrize(
    ("text", "name", "reason"),
    [
        (RS274, "rs274", "an O-word with a flow command in line 1"),
        ("G21\n\n  o100 while [#1 LT 3]\n", "rs274", "an O-word with a flow command in line 3"),
        ("G21\r\n#<depth>=3\r\n", "rs274", "a named parameter `#<name>` in line 2"),
        ("G21\r#<depth>=3\r", "rs274", "a named parameter `#<name>` in line 2"),
        ("G0 X1\n#IF1 |Part|=2\nG0 X|Depth|\n#ENDIF1\n", "metagcode", None),
        ("G0 X1\n!X=Y+2! ;set\nM30\n", "z32", None),
        ("@START\nG0 X#XPOS Y#YPOS\n@\n@LINE\nG1 X#XPOS\n@\n", "cgt", None),
    ],
)
def test_content(text, name, reason):
    for extension in SHARED:
        answer = detect(f"/w/a{extension}", text)
        assert answer.dialect == name and (reason is None or answer.reason == reason), answer
    assert detect("", text).dialect == name
    assert detect("/w/a.foo", text) == Answer(None, "no dialect has the extension .foo")
    assert detect("/w/O1234", text) == Answer(None, "the file has no extension")


def test_comments_are_no_evidence():
    assert detect("/w/a.nc", "(call o100 sub, see #<x>)\nG0 X1 ; #<x>\n").dialect is None
    assert detect("/w/a.nc", "(a) #<x>=1 (b)\n").dialect == "rs274"


def test_evidence_of_two_is_no_answer():
    answer = detect("/w/a.nc", "#<x>=1\n!X=Y+2! ;set\n")
    assert answer.dialect is None
    assert "(rs274)" in answer.reason and "(z32)" in answer.reason


@pytest.mark.parametrize(
    "line",
    ["(deburr: dialect=z32)", "; deburr: dialect=z32", "// deburr: dialect=z32", "G0 X1 (x deburr:dialect = z32 y) Y1"],
)
def test_modeline(line):
    for text, where in ((f"G21\n{line}\n", "line 2"), (f"{MANY}{line}\nM2\n", "the last lines")):
        assert detect("/w/a.ngc", text) == Answer("z32", f"the modeline in {where}")
    for text in (f"{MANY}{line}\n{MANY}", "deburr: dialect=z32\n", "(nodeburr: dialekt=z32)\n"):
        assert detect("/w/a.ngc", text).dialect == "rs274"


def test_a_modeline_that_names_no_dialect_answers_nothing():
    answer = detect("/w/a.ngc", "(deburr: dialect=rs247)\n")
    assert answer == Answer(None, "the modeline in line 1 names `rs247`, which is no dialect; did you mean `rs274`?")


def test_the_first_answers():
    text = "(deburr: dialect=z32)\n#<x>=1\n"
    configured = Answer("cgt", "[files]")
    assert detect("/w/a.ngc", text, Hints("rs274", "metagcode", configured)).dialect == "rs274"
    assert detect("/w/a.ngc", text, Hints(None, "metagcode", configured)) == Answer(
        "metagcode", "the editor's language"
    )
    assert detect("/w/a.ngc", text, Hints(None, "gcode", configured)) == configured
    assert detect("/w/a.ngc", text).dialect == "z32"
    assert detect("/w/a.ngc", "G0\n").reason == "the extension .ngc"


def test_explain_dialect(shell):
    shell.write("a.ngc", "M2\n")
    shell.write("b.nc", "G0 X1\n")
    shell.write("c.nc", b"G0\x00X1\n")
    assert shell.run("explain-dialect", "a.ngc") == (0, "a.ngc: rs274 (the extension .ngc)\n", "")
    ran = shell.run("explain-dialect", "b.nc")
    assert (ran.code, ran.err) == (1, "")
    assert ran.out.startswith(
        "b.nc: no dialect (the extension .nc is shared by many controls, and nothing in it is proper to one of "
    )
    assert shell.run("explain-dialect", "b.nc", "--dialect", "rs274") == (
        0,
        "b.nc: rs274 (asked for with --dialect)\n",
        "",
    )
    assert shell.run("explain-dialect", "-", stdin=b"#<x>=1\n") == (
        0,
        "-: rs274 (a named parameter `#<name>` in line 1)\n",
        "",
    )
    assert shell.run("explain-dialect", "c.nc").code == 2
    assert shell.run("explain-dialect", "nothing.nc").err == "deburr: error: nothing.nc: No such file or directory\n"


def test_a_fanuc_program_is_an_error_that_names_the_flag(shell):
    shell.write("a.nc", FANUC)
    ran = shell.run("check", "a.nc")
    assert (ran.code, ran.out) == (2, "No findings (0 checked, 1 not checked)\n")
    assert "--dialect" in ran.err
