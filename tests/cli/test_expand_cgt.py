"""`deburr expand` of a template: its toolpath, its machine file, values for words that nothing declares."""

from pathlib import Path

import pytest

TEMPLATE = "@START\n%\nO#number\n@\n@LINE\n<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>\n@\n@END\nM30\n@\n"
TOOLPATH = "GOTO/1,2,3\nGOTO/1,5,3\nFINI\n"
FLAT = "%\nO12.0\nG01 X1.0 Y2.0 Z3.0\n Y5.0\nM30\n"


def test_a_toolpath_and_a_value_are_named_on_the_command_line(shell):
    shell.write("part.cgt", TEMPLATE)
    shell.write("part.cl", TOOLPATH)
    assert shell.run("expand", "part.cgt", "--input", "part.cl", "-D", "number=12") == (0, FLAT, "")


def test_a_toolpath_is_named_in_the_configuration(shell):
    shell.write("deburr.toml", '[cgt]\ninput = "part.cl"\nmachine = "mill.toml"\n')
    shell.write("mill.toml", '[tables]\nMOV = ["G0", "G1"]\n')
    shell.write("part.cgt", TEMPLATE.replace("O#number\n", ""))
    shell.write("part.cl", TOOLPATH)
    flat = FLAT.replace("O12.0\n", "").replace("G01", "G1")
    assert shell.run("expand", "part.cgt") == (0, flat, "")


def test_a_value_that_is_not_given_is_an_undeclared_word(shell):
    shell.write("part.cgt", TEMPLATE)
    shell.write("part.cl", TOOLPATH)
    code, flat, said = shell.run("expand", "part.cgt", "--input", "part.cl")
    assert (code, flat) == (1, "") and "cgt.word-undeclared" in said


def test_without_a_toolpath_nothing_is_expanded(shell):
    shell.write("part.cgt", "@START\n%\n@\n@END\nM30\n@\n")
    code, flat, said = shell.run("expand", "part.cgt", "-o", "flat.nc")
    assert (code, flat) == (1, "") and "cgt.input-missing" in said and "--input FILE" in said
    assert not (shell.folder / "flat.nc").exists()
    assert shell.run("check", "part.cgt")[0] == 0


def test_an_unknown_word_is_a_warning_in_check_and_refused_in_expand(shell):
    shell.write("part.cgt", TEMPLATE.replace("#number", "#NUMBR"))
    shell.write("part.cl", TOOLPATH)
    assert shell.run("check", "part.cgt")[0] == 0
    code, flat, said = shell.run("expand", "part.cgt", "--input", "part.cl")
    assert (code, flat) == (1, "") and "error[cgt.word-unknown]" in said and said.count("cgt.word-unknown") == 1


@pytest.mark.parametrize(
    ("statement", "code", "said"),
    [
        ("PAINT/COLOR,3", 0, "warning[cgt.cl-unknown]"),
        ("GOTO/1,2", 1, "error[cgt.cl-syntax]"),
        ("DELAY/1", 0, "warning[cgt.event-lost]"),
    ],
)
def test_what_is_wrong_with_the_toolpath_is_said_there(shell, statement, code, said):
    shell.write("part.cgt", TEMPLATE.replace("O#number\n", ""))
    shell.write("part.cl", f"GOTO/1,2,3\n{statement}\nFINI\n")
    found, flat, message = shell.run("expand", "part.cgt", "--input", "part.cl")
    assert found == code and said in message and "part.cl:2:1" in message
    assert flat == ("" if code else "%\nG01 X1.0 Y2.0 Z3.0\nM30\n")


def test_a_run_is_checked_with_the_configured_toolpath(shell):
    shell.write("part.cgt", TEMPLATE.replace("O#number", "#EVAL(#V1=1/#V2)"))
    shell.write("part.cl", TOOLPATH)
    code, said, _ = shell.run("check", "part.cgt", "--input", "part.cl")
    assert code == 1 and "cgt.divide-by-zero" in said
    assert shell.run("check", "part.cgt", "--input", "part.cl", "-D", "V2=4")[0] == 0
    assert shell.run("check", "part.cgt")[0] == 0


MILL = """\
%
O1001(SQUARE)
(x y)
G21
G90 G17 G40 G80
N10 M09
N20 G40 G80
N30 G53 Z0
N40 M05
N50 T1 M06
N60 M42
N70 S1500 M03
N80 G00 G43 H1 Z50.0
N90 G00 X-10.0 Y0.0 Z5.0
N100 M08
N110  Z-2.0
N120 G01 G41 D11 X0.0 F250.0
N130  Y30.0
N140 G02 X10.0 Y40.0 I10.0 J0.0
N150 G01 X40.0
N160  Y0.0
N170  X0.0
N180  G40 X-10.0
N190 G00 Z50.0
N200 M09
N210 G40 G80
N220 G53 Z0
N230 M05
N240 T2 M06
N250 M41
N260 S800 M03
N270 G00 G43 H2 Z50.0
N280 G00 X10.0 Y10.0 Z5.0
N290 M08
N300 G99 G81 Z-6.0 R2.0 F80.0
N310 G99  X30.0 Z-6.0 R2.0
N320 G80
N330 G04 P0.5
N340 G00 Z50.0
N350 M09
N360 G40 G80
N370 G53 Z0
N380 M05
N390 M30
N400 %
"""
"""Compensation ends on the way out, before the next tool; behind the drill cycle stands G80, and the motion anew."""


def test_the_example_of_a_mill_leaves_nothing_on(shell):
    mill = Path(__file__).parents[2] / "examples/cgt/mill.cgt"
    toolpath = ["--input", str(mill.with_suffix(".cl"))]
    assert shell.run("expand", str(mill), *toolpath, "-D", "DATE=x", "-D", "SYSTIME=y") == (0, MILL, "")
