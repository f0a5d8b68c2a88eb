"""`deburr expand` of MetaGCODE: test steps, values, snippets."""

import pytest

LOOP = "#LOOP1 |Depth| 2 c\nG1 Z-|Depth|\n#ENDLOOP1\n"


def test_values_come_by_name_and_from_a_file(shell):
    shell.write("pocket.mgc", LOOP)
    shell.write("part.vars", "Depth=4\n")
    assert shell.run("expand", "pocket.mgc", "-D", "Depth=3") == (0, "G1 Z-1.5\nG1 Z-3\n", "")
    assert shell.run("expand", "pocket.mgc", "--variables", "part.vars") == (0, "G1 Z-2\nG1 Z-4\n", "")
    both = shell.run("expand", "pocket.mgc", "--variables", "part.vars", "-D", "Depth=2")
    assert both == (0, "G1 Z-2\n", "")


def test_a_value_that_is_given_by_name_is_missing_in_no_file(shell):
    shell.write("pocket.mgc", LOOP)
    shell.write("part.vars", "Length=4\n")
    assert shell.run("expand", "pocket.mgc", "--variables", "part.vars", "-D", "Depth=2") == (0, "G1 Z-2\n", "")
    assert shell.run("check", "pocket.mgc", "--variables", "part.vars", "-D", "Depth=2").code == 0
    assert shell.run("check", "pocket.mgc", "--variables", "part.vars").code == 1


def test_a_missing_value_is_refused_by_expand_and_no_matter_for_check(shell):
    shell.write("pocket.mgc", LOOP)
    assert shell.run("check", "pocket.mgc").code == 0
    ran = shell.run("expand", "pocket.mgc", "-D", "depth=4", "-o", "flat.nc")
    assert (ran.code, ran.out) == (1, "")
    assert "error[metagcode.undefined-variable]" in ran.err and "did you mean `depth`?" in ran.err
    assert not (shell.folder / "flat.nc").exists()


def test_a_broken_line_of_the_file_of_values_is_named(shell):
    shell.write("pocket.mgc", LOOP)
    shell.write("part.vars", "Depth 4\n")
    ran = shell.run("expand", "pocket.mgc", "--variables", "part.vars")
    assert (ran.code, ran.out) == (1, "")
    assert "line 1 of the file of values `part.vars`" in ran.err
    assert shell.run("expand", "pocket.mgc", "--variables", "none.vars").code == 2


def test_steps_that_hang_together_are_joined(shell):
    shell.write("1.mgc", "#IF1 |on| equalto yes a\nG0 X1")
    shell.write("2.mgc", "G0 X2\n#ENDIF1\nM30\n")
    ran = shell.run("expand", "1.mgc", "2.mgc", "-D", "on=yes")
    assert (ran.code, ran.out) == (0, "G0 X1\nG0 X2\nM30\n")
    assert "warning[metagcode.block-crosses-file]" in ran.err
    assert shell.run("expand", "1.mgc", "2.mgc", "-D", "on=no", "-q") == (0, "M30\n", "")
    shell.write("2.mgc", "G0 X2\n#ENDIF2\nM30\n")
    ran = shell.run("expand", "1.mgc", "2.mgc", "-D", "on=yes")
    assert (ran.code, ran.out) == (1, "") and "error[metagcode.block-mismatch]" in ran.err


def test_what_is_wrong_in_a_snippet_of_a_snippet_is_shown_with_the_way_to_it(shell):
    shell.write("part.mgc", "G0 Z5\n#FILE a.txt\n")
    shell.write("Snippets/a.txt", "#FILE b.txt\n")
    shell.write("Snippets/b.txt", "G0 X1\n#IF1 |a| is 1 n\n#ENDIF1\n")
    ran = shell.run("expand", "part.mgc", "-D", "a=1")
    assert (ran.code, ran.out) == (1, "")
    for words in ("error[metagcode.if-operator]", "Snippets/b.txt:2:10", "Snippets/a.txt:1:1", "part.mgc:2:1"):
        assert words in ran.err.replace(str(shell.folder) + "/", "")
    ran = shell.run("check", "part.mgc", "--output-format", "concise")
    assert "b.txt:2:10: error metagcode.if-operator" in ran.out.replace("[", " ").replace("]", "")


def test_a_name_that_nothing_reads_is_warned_of(shell):
    shell.write("pocket.mgc", "#FILE deep.mgc\n" + LOOP)
    shell.write("Snippets/deep.mgc", "G0 Z|Deep|\n")
    ran = shell.run("expand", "pocket.mgc", "-D", "Depth=2", "-D", "Deep=1", "-D", "Detph=3")
    expected = "deburr: warning: -D Detph: the program never reads `|Detph|`; did you mean `Depth`?\n"
    assert ran == (0, "G0 Z1\nG1 Z-2\n", expected)
    assert "`|DEEP|`; did you mean `Deep`?" in shell.run("expand", "pocket.mgc", "-D", "DEEP=1").err
    shell.write("part.vars", "Depth=2\nDeep=1\nLength=4\n")
    assert shell.run("expand", "pocket.mgc", "--variables", "part.vars").err == ""


FAULTY = {
    "an open block": ("G0 X|a|\n#IF1 |b| equalto 1 n\n", "block-unclosed"),
    "a line": ("G0 X|a|\n#IF1 |b| is 1 n\n#ENDIF1\n", "if-operator"),
}


@pytest.mark.parametrize("name", FAULTY)
def test_a_name_that_nothing_reads_is_warned_of_beside_a_fault_of_form(shell, name):
    text, rule = FAULTY[name]
    shell.write("part.mgc", text)
    given = ("-D", "a=1", "-D", "b=2")
    assert "warning" not in shell.run("expand", "part.mgc", *given).err
    ran = shell.run("expand", "part.mgc", *given, "-D", "zz=3")
    assert ran.code == 1 and f"error[metagcode.{rule}]" in ran.err
    assert ran.err.startswith("deburr: warning: -D zz: the program never reads `|zz|`\n")
    # Where programs are joined, faults of form are the run's to find.
    shell.write("more.mgc", "G0 Y|c|\n")
    ran = shell.run("expand", "part.mgc", "more.mgc", *given, "-D", "c=3", "-D", "zz=3")
    assert ran.code == 1 and ran.err.count("warning: -D") == 1 and "`|zz|`" in ran.err


@pytest.mark.parametrize(
    "text",
    [
        # A bar is missing, or both; a text is missing, or a misspelt line may name it.
        "G0 X|zz Y1\n",
        "G0 Y|b|\n#LOOP1 zz 1 c\n#ENDLOOP1\n",
        "#FILE gone.mgc\n",
        "#FILE\n",
        "#FIEL zz.mgc\n",
    ],
)
def test_nothing_is_said_of_names_that_a_fault_may_hide(shell, text):
    shell.write("part.mgc", text)
    ran = shell.run("expand", "part.mgc", "-D", "zz=3")
    assert ran.code == 1 and "warning: -D" not in ran.err
