"""`deburr expand` of a template: its toolpath, its machine file, values for words that nothing declares."""

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
