"""Faults in files that a program is configured with: they are shown where they stand, once."""

import json

TEMPLATE = "@START\nG90 G21\n@\n@LINE\n<X#XPOS>< Y#YPOS>< Z#ZPOS>\n@\n@END\nM30\n@\n"
CONFIG = '[cgt]\ninput = "paths/sample.cl"\nmachine = "mill.toml"\n'
PATH = "LOADTL/1\r\nRAPID\r\nGOTO/1,2\r\nPAINT/3\r\nFINI\r\n"


def concise(shell, *arguments):
    ran = shell.run("check", "--output-format", "concise", *arguments)
    return ran.out.splitlines(), ran.code


def test_a_fault_in_a_toolpath_is_shown_there(shell):
    shell.write("deburr.toml", CONFIG)
    shell.write("a.cgt", TEMPLATE)
    shell.write("mill.toml", "block-step = 1\n")
    shell.write("paths/sample.cl", PATH)
    ran = shell.run("check", "a.cgt")
    assert ran.code == 1
    assert ran.out.startswith(
        "error[cgt.cl-syntax]: `GOTO` has 2 values; write `GOTO/x,y,z` or `GOTO/x,y,z,i,j,k`\n"
        " --> paths/sample.cl:3:1\n"
        "  |\n"
        "1 | LOADTL/1\n"
        "2 | RAPID\n"
        "3 | GOTO/1,2\n"
        "  | ^^^^^^^^\n"
        "4 | PAINT/3\n"
        "5 | FINI\n"
    )
    found = json.loads(shell.run("check", "a.cgt", "--output-format", "json").out)
    assert [(each["rule"], each["filename"].split("/")[-1], each["location"]["row"]) for each in found] == [
        ("cgt.cl-syntax", "sample.cl", 3),
        ("cgt.cl-unknown", "sample.cl", 4),
    ]


def test_what_templates_share_is_said_once(shell):
    shell.write("deburr.toml", CONFIG)
    for name in ("a.cgt", "b.cgt"):
        shell.write(name, TEMPLATE)
    shell.write("mill.toml", "\n[words]\nXPOS = 'text'\n")
    shell.write("paths/sample.cl", PATH)
    lines, code = concise(shell, ".")
    assert [" ".join(line.split(" ")[:3]) for line in lines[:-1]] == [
        "mill.toml:3:1: error cgt.machine-file",
        "paths/sample.cl:3:1: error cgt.cl-syntax",
        "paths/sample.cl:4:1: warning cgt.cl-unknown",
    ]
    assert lines[-1] == "Found 2 errors, 1 warning in 2 files (2 checked)"
    assert code == 1


def test_a_file_that_is_not_there_is_said_with_its_key(shell):
    shell.write("deburr.toml", CONFIG)
    shell.write("a.cgt", TEMPLATE)
    ran = shell.run("check", "a.cgt")
    folder = shell.folder.as_posix()
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.splitlines() == [
        f"deburr: error: {folder}/deburr.toml:2: `input` names `{folder}/paths/sample.cl`, which does not exist",
        f"deburr: error: {folder}/deburr.toml:3: `machine` names `{folder}/mill.toml`, which does not exist",
    ]


def test_a_comment_in_the_template_speaks_for_the_template_alone(shell):
    shell.write("deburr.toml", '[cgt]\ninput = "sample.cl"\n')
    shell.write("a.cgt", TEMPLATE.replace("G90 G21", "G90 G21 // deburr: allow cgt.cl-syntax"))
    shell.write("sample.cl", "\nGOTO/1,2\n")
    assert [line.split(" ")[0] + line.split(" ")[2] for line in concise(shell, "a.cgt", "-q")[0]] == [
        "a.cgt:2:26:cgt.allow-unused",
        "sample.cl:2:1:cgt.cl-syntax",
    ]


def test_a_table_word_of_the_machine_file_makes_its_section_a_table(shell):
    shell.write("deburr.toml", '[cgt]\nmachine = "mill.toml"\n')
    shell.write("a.cgt", TEMPLATE.replace("G90 G21", "G90 G21 #GEAR") + "@GEAR\n0,M40 <low>>\n1,M41\n2\n@\n")
    shell.write("mill.toml", '[words]\nGEAR = "table"\n')
    assert [line.split(" ")[0] + line.split(" ")[2] for line in concise(shell, "a.cgt", "-q")[0]] == [
        "a.cgt:13:1:cgt.table-row"
    ]


def test_standard_input_without_a_name_has_no_files_around_it(shell):
    shell.write("deburr.toml", CONFIG)
    assert shell.run("check", "--dialect", "cgt", "-", "-q", stdin=TEMPLATE.encode()).out == ""


def test_what_several_programs_find_in_a_file_that_they_call_is_said_once(shell):
    shell.write("part.ngc", "o<part> sub\n#<d>=0\nG0 X[#1/#<d>]\no<part> endsub\nM2\n")
    for name in ("a.ngc", "b.ngc"):
        shell.write(name, "G21 G90 G17\no1 if [#5420 GT 5]\no<part> call [1]\no1 endif\nM2\n")
    lines, code = concise(shell, ".")
    assert [line.split(" `")[0] for line in lines[:-1]] == ["part.ngc:3:9: error rs274.divide-by-zero"]
    assert code == 1
    lines, code = concise(shell, "a.ngc")
    assert [line.split(" `")[0] for line in lines[:-1]] == ["part.ngc:3:9: error rs274.divide-by-zero"]
    assert code == 1
