"""`deburr expand`: what is written where, in which bytes, and what is refused."""

import json
import os

import pytest
import sourcemap

LOOP = "G21 G90\n#<n> = 0\no1 while [#<n> LT 3]\n  G0 X[#<n> * 10]\n  #<n> = [#<n> + 1]\no1 endwhile\nM2\n"
FLAT = "G21 G90\n  G0 X0\n  G0 X10\n  G0 X20\nM2\n"
BAD = "G0 X1\n#1 = [2 - 2]\nG0 X[5 / #1]\nM2\n"


def test_the_flat_program_goes_to_standard_output(shell):
    shell.write("loop.ngc", LOOP)
    assert shell.run("expand", "loop.ngc") == (0, FLAT, "")


def test_the_flat_program_goes_to_a_file(shell):
    shell.write("loop.ngc", LOOP)
    assert shell.run("expand", "loop.ngc", "-o", "flat.ngc") == (0, "", "")
    assert (shell.folder / "flat.ngc").read_text() == FLAT
    assert sorted(path.name for path in shell.folder.iterdir()) == ["flat.ngc", "loop.ngc"]


def test_programs_that_run_by_themselves_are_not_joined(shell):
    shell.write("a.ngc", "G0 X1\nM2\n")
    shell.write("b.ngc", "G0 X2\nM2\n")
    said = "deburr: error: a program in `rs274` runs by itself: name one file, not 2; nothing joins them\n"
    assert shell.run("expand", "a.ngc", "b.ngc") == (2, "", said)


def test_standard_input_is_a_program(shell):
    assert shell.run("expand", "-", "--dialect", "rs274", stdin=LOOP.encode()) == (0, FLAT, "")


@pytest.mark.parametrize(
    "text", ["G0 X1\r\n(two)\r\n\r\nM2\r\n", "G0 X1\nM2", "  G0 X1  \n(\u00b5)\nM2\n", "%\nG0 X1\n%\n"]
)
def test_what_has_no_macros_comes_out_as_it_went_in(shell, text):
    shell.write("plain.ngc", text)
    assert shell.run("expand", "plain.ngc", "-o", "flat.ngc").code == 0
    assert (shell.folder / "flat.ngc").read_bytes() == text.encode()


def test_encoding_byte_order_mark_and_line_ends_are_kept(shell):
    shell.write("umlaut.ngc", "(M\u00fcller)\r\n#1=2 G0 X#1\r\nM2\r\n".encode("cp1252"))
    assert shell.run("expand", "umlaut.ngc", "-o", "flat.ngc").code == 0
    assert (shell.folder / "flat.ngc").read_bytes() == "(M\u00fcller)\r\nG0 X0\r\nM2\r\n".encode("cp1252")
    shell.write("marked.mgc", "\ufeffG0 X1\nM2\n")
    assert shell.run("expand", "marked.mgc", "-o", "flat.ngc", "--eol", "crlf").code == 0
    assert (shell.folder / "flat.ngc").read_bytes() == "\ufeffG0 X1\r\nM2\r\n".encode()


def test_a_fault_of_the_run_leaves_nothing_behind(shell):
    shell.write("bad.ngc", BAD)
    shell.write("flat.ngc", "as it was\n")
    ran = shell.run("expand", "bad.ngc", "-o", "flat.ngc", "--source-map", "flat.map")
    assert (ran.code, ran.out) == (1, "")
    assert ran.err.startswith("error[rs274.divide-by-zero]: `5 / #1` is a division by zero")
    assert "--> bad.ngc:3:10" in ran.err
    assert (shell.folder / "flat.ngc").read_text() == "as it was\n"
    assert not (shell.folder / "flat.map").exists()


def test_a_part_is_written_if_it_is_wanted(shell):
    shell.write("bad.ngc", BAD)
    ran = shell.run("expand", "bad.ngc", "--partial")
    assert (ran.code, ran.out) == (1, "G0 X1\n")


@pytest.mark.parametrize("eol", ["lf", "crlf"])
def test_a_part_ends_before_the_first_line_that_a_value_makes_wrong(shell, eol):
    shell.write("bad.ngc", "(\u00b5)\n#1=5\nG1 X1 F#1\nG1 X2 F[#1-9]\nG1 X3 F5\nG0 X9\nM2\n")
    ran = shell.run("expand", "bad.ngc", "--partial", "--eol", eol, "-o", "flat.ngc", "--source-map", "flat.map")
    assert ran.code == 1 and "rs274.negative-value" in ran.err
    end = {"lf": "\n", "crlf": "\r\n"}[eol]
    assert (shell.folder / "flat.ngc").read_bytes() == f"(\u00b5){end}G1 X1 F5{end}".encode()
    document = json.loads((shell.folder / "flat.map").read_text())
    assert document["x_deburr_lines"] == [[0, 0, -1], [0, 2, -1]]
    shell.write("none.ngc", "#1=-5\nG1 X1 F#1\nM2\n")
    ran = shell.run("expand", "none.ngc", "--partial")
    assert (ran.code, ran.out) == (1, "")


def test_a_program_that_is_wrong_as_it_stands_is_not_run(shell):
    shell.write("wrong.ngc", "G0 X1\no1 if [1]\nM2\n")
    ran = shell.run("expand", "wrong.ngc", "--partial")
    assert (ran.code, ran.out) == (1, "")
    assert "rs274.o-unclosed" in ran.err
    assert ran.err.endswith("deburr: nothing was written: 1 error\n")


def test_values_are_given_by_name(shell):
    shell.write("p.ngc", "G0 X#5 Y#<_depth>\nM2\n")
    assert shell.run("expand", "p.ngc", "-D", "5=1.25", "-D", "_depth=-3").out == "G0 X1.25 Y-3\nM2\n"
    assert shell.run("expand", "p.ngc", "-D", "5").code == 2
    ran = shell.run("expand", "p.ngc", "-D", "_depth=deep", "-D", "5=1")
    assert ran == (2, "", "deburr: error: -D _depth=deep: the value is no number\n")


@pytest.mark.parametrize(
    ("switch", "code", "out"),
    [((), 1, ""), (("--block-delete", "on"), 0, "G0 X5\nM2\n"), (("--block-delete", "off"), 0, "G0 X7\nM2\n")],
)
def test_block_delete_is_the_operators(shell, switch, code, out):
    shell.write("p.ngc", "#1=5\n/#1=7\nG0 X#1\nM2\n")
    ran = shell.run("expand", "p.ngc", *switch)
    assert (ran.code, ran.out) == (code, out)
    assert ("--block-delete" in ran.err) is bool(code)


def test_budgets_name_the_loop(shell):
    shell.write("p.ngc", "#1=0\n#2=0\no1 while [#1 LT 1]\nG0 X#2\n#2=[#2+1]\no1 endwhile\nM2\n")
    ran = shell.run("expand", "p.ngc", "--max-steps", "5000")
    assert ran.code == 1
    assert "rs274.limit" in ran.err
    assert "5,000" in ran.err and "`o1 while [#1 LT 1]` of line 3" in ran.err and "`#1` = 0" in ran.err
    assert "more than 10 lines" in shell.run("expand", "p.ngc", "--max-blocks", "10").err


def test_decimals_and_line_numbers(shell):
    shell.write("p.ngc", "N10 #1=[1/3]\nN20 G0 X#1\nN30 M2\n")
    assert shell.run("expand", "p.ngc").out == "G0 X0.333333\nM2\n"
    assert shell.run("expand", "p.ngc", "--decimals", "2", "--keep-n").out == "N20 G0 X0.33\nN30 M2\n"
    assert shell.run("expand", "p.ngc", "--decimals", "exact").out == "G0 X0.3333333333333333\nM2\n"
    assert shell.run("expand", "p.ngc", "--decimals", "all").code == 2


def test_the_source_map_is_read_by_a_published_consumer(shell):
    shell.write("loop.ngc", LOOP)
    assert shell.run("expand", "loop.ngc", "-o", "flat.ngc", "--source-map", "flat.map").code == 0
    text = (shell.folder / "flat.map").read_text()
    index = sourcemap.loads(text)
    rows = [index.lookup(line=line, column=0).src_line for line in range(5)]
    assert rows == [0, 3, 3, 3, 6]
    assert index.lookup(line=1, column=0).src == "loop.ngc"
    document = json.loads(text)
    assert (document["version"], document["file"], document["sources"], document["names"]) == (
        3,
        "flat.ngc",
        ["loop.ngc"],
        [],
    )
    assert document["x_deburr_frames"] == [[-1, 0, 2, "loop", 1], [-1, 0, 2, "loop", 2], [-1, 0, 2, "loop", 3]]
    assert document["x_deburr_lines"] == [[0, 0, -1], [0, 3, 0], [0, 3, 1], [0, 3, 2], [0, 6, -1]]


def test_two_programs_are_compared_flat(shell):
    shell.write("loop.ngc", LOOP)
    shell.write("other.ngc", LOOP.replace("* 10", "* 11"))
    shell.write("plain.ngc", FLAT)
    ran = shell.run("expand", "loop.ngc", "--diff", "other.ngc")
    assert ran.code == 1
    assert ran.out.splitlines() == [
        "--- loop.ngc",
        "+++ other.ngc",
        "@@ -1,5 +1,5 @@ loop.ngc:4 <- loop.ngc:3 (loop 2) | other.ngc:4 <- other.ngc:3 (loop 2)",
        " G21 G90",
        "   G0 X0",
        "-  G0 X10",
        "-  G0 X20",
        "+  G0 X11",
        "+  G0 X22",
        " M2",
    ]
    assert shell.run("expand", "loop.ngc", "--diff", "plain.ngc") == (0, "", "deburr: the flat programs are the same\n")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("gone.ngc",), "gone.ngc: No such file or directory"),
        (("p.ngc", "-o", "no/such/folder/flat.ngc"), "No such file or directory"),
        (("p.txt",), "--dialect"),
        (("p.ngc", "--variables", "gone.vars"), "--variables: gone.vars: no such file"),
        (("p.ngc", "--input", "p.txt"), "--input: rs274 programs have no such input"),
        (("p.ngc", "q.mgc"), "several dialects"),
    ],
)
def test_what_cannot_be_done_is_said(shell, arguments, said):
    shell.write("p.ngc", "G0 X1\nM2\n")
    shell.write("p.txt", "hello\n")
    shell.write("q.mgc", "G0 X1\n")
    ran = shell.run("expand", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert said in ran.err


def test_check_reports_what_a_run_meets_with_its_stack(shell):
    shell.write(
        "p.ngc",
        "o<a> sub\n  G0 X[1 / #1]\no<a> endsub\n#2 = 2\no1 while [#2 GE 0]\n  o<a> call [#2]\n  #2 = [#2 - 1]\no1 endwhile\nM2\n",
    )
    ran = shell.run("check", "p.ngc", "--output-format", "json")
    (finding,) = json.loads(ran.out)
    assert (ran.code, finding["rule"]) == (1, "rs274.divide-by-zero")
    assert finding["location"] == {"row": 2, "column": 12}
    said = [(each["location"]["row"], each["message"]) for each in finding["related"]]
    assert said == [(6, "called here"), (5, "in pass 3 of the loop that starts here")]
    assert shell.run("check", "p.ngc", "--no-run").code == 0
    shell.write("deburr.toml", "[check]\nrun = false\n")
    assert shell.run("check", "p.ngc").code == 0
    assert shell.run("check", "p.ngc", "--run").code == 1


def test_check_says_nothing_of_what_only_the_machine_knows(shell):
    shell.write("p.ngc", "G0 X[1 / #5061]\n/#1=5\nM2\n")
    assert shell.run("check", "p.ngc").code == 0
    assert shell.run("expand", "p.ngc").code == 1


@pytest.mark.parametrize(
    ("name", "program", "given", "said"),
    [
        ("p.ngc", "G0 X#1\nM2\n", "1=x", "-D 1=x: the value is no number"),
        ("p.ngc", "G0 X#31\nM2\n", "31=inf", "-D 31=inf: the value is no number"),
        ("p.ngc", "G0 X#31\nM2\n", "31=nan", "-D 31=nan: the value is no number"),
        ("p.ngc", "G0 X#31\nM2\n", "31=1e400", "-D 31=1e400: the value is no number"),
        ("p.ngc", "G0 X#31\nM2\n", "31=1_0", "-D 31=1_0: the value is no number"),
        ("p.ngc", "G0 X1\nM2\n", "31=bar", "-D 31=bar: the value is no number"),
        ("p.ngc", "G0 X1\nM2\n", "foo=bar", "-D foo=bar: the value is no number"),
        ("p.mgc", "G0 X1\n", "b=1|2", "-D b=...: the value has a bar in it"),
        ("p.z32", "G0 X1\nM30\n", "HA=inf", "-D HA=inf: `inf` is no number"),
        ("p.z32", "G0 X1\nM30\n", f"HA={'9' * 400}", f"-D HA={'9' * 400}: `{'9' * 400}` is no number"),
        ("p.cgt", "@START\n%\n@\n@END\n@\n", "V1=inf", "-D V1=inf: `#V1` takes a number"),
        ("p.cgt", "@START\n%\n@\n@END\n@\n", "V1=1e400", "-D V1=1e400: `#V1` takes a number"),
        ("p.mgc", "G0 X|a|\n", "a=1|2", "-D a=...: the value has a bar in it"),
        ("p.z32", "X<HA>\nM30\n", "HA=", "-D HA=: `` is no number"),
        ("p.cgt", "@START\n#V1\n@\n@END\n@\n", "V1=a", "-D V1=a: `#V1` takes a number"),
    ],
)
def test_a_value_that_cannot_be_used_is_an_error_of_usage(shell, name, program, given, said):
    shell.write(name, program)
    shell.write("t.jsonl", "")
    toolpath = ["--input", "t.jsonl"] if name == "p.cgt" else []
    for command in ("expand", "check"):
        ran = shell.run(command, name, *toolpath, "-D", given)
        assert (ran.code, ran.out) == (2, "")
        assert ran.err.startswith(f"deburr: error: {said}") and ran.err.count("\n") == 1


def test_a_value_is_judged_where_a_template_has_no_toolpath(shell):
    shell.write("p.cgt", "@START\n#V1\n@\n@END\n@\n")
    for command in ("expand", "check"):
        assert shell.run(command, "p.cgt", "-D", "V1=a") == (2, "", "deburr: error: -D V1=a: `#V1` takes a number\n")


def test_a_value_may_be_meant_for_another_language(shell):
    shell.write("p.z32", "X<1/HA>\nM30\n")
    shell.write("q.mgc", "#LOOP1 |Depth| 2 c\nG1 Z|Depth|\n#ENDLOOP1\n")
    assert shell.run("check", "-D", "Depth=4").code == 0
    assert shell.run("check", "p.z32", "-D", "Depth=4").code == 2
    ran = shell.run("check", "-D", "Depth=0", "-D", "HA=0")
    assert "metagcode.loop-zero" in ran.out


def test_check_is_given_values_too(shell):
    shell.write("p.ngc", "G0 X[1 / #<_n>]\nM2\n")
    assert shell.run("check", "p.ngc", "-D", "_n=0").code == 1
    assert shell.run("check", "p.ngc", "-D", "_n=1").code == 0


def test_links_are_followed_modes_kept_and_devices_written_into(shell):
    shell.write("p.ngc", FLAT)
    target = shell.write("real.ngc", "old\n")
    target.chmod(0o640)
    (shell.folder / "link.ngc").symlink_to(target)
    assert shell.run("expand", "p.ngc", "-o", "link.ngc").code == 0
    assert (shell.folder / "link.ngc").is_symlink()
    assert (target.read_text(), target.stat().st_mode & 0o777) == (FLAT, 0o640)
    os.mkfifo(shell.folder / "pipe")
    with os.fdopen(os.open(shell.folder / "pipe", os.O_RDONLY | os.O_NONBLOCK)) as pipe:
        assert shell.run("expand", "p.ngc", "-o", "pipe").code == 0
        assert pipe.read() == FLAT


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("-o", "p.ngc"), "-o p.ngc: that would write over p.ngc"),
        (("-o", "again.ngc"), "that would write over p.ngc"),
        (("-o", "f", "--source-map", "f"), "--source-map f: that would write over f"),
        (("-o", ""), "-o: the name of the file is empty"),
        (("--source-map", ""), "--source-map: the name of the file is empty"),
        (("-o", "."), "Is a directory"),
        (("-o", "no/x.ngc"), "no/x.ngc: No such file or directory"),
        (("--diff", "p.ngc", "-o", "f"), "--diff writes no flat program"),
    ],
)
def test_nothing_is_written_over(shell, arguments, said):
    shell.write("p.ngc", FLAT)
    (shell.folder / "again.ngc").symlink_to(shell.folder / "p.ngc")
    ran = shell.run("expand", "p.ngc", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert said in ran.err
    assert sorted(path.name for path in shell.folder.iterdir()) == ["again.ngc", "p.ngc"]
    assert (shell.folder / "p.ngc").read_text() == FLAT


@pytest.mark.parametrize("option", ["--variables", "--config"])
@pytest.mark.parametrize("written", ["-o", "--source-map"])
def test_inputs_are_not_written_over(shell, option, written):
    shell.write("p.mgc", "G0 X1\n")
    shell.write("in", "")
    ran = shell.run("expand", "p.mgc", option, "in", written, "./in")
    assert ran == (2, "", f"deburr: error: {written} ./in: that would write over in\n")
    assert (shell.folder / "in").read_text() == ""


@pytest.mark.parametrize(
    ("option", "text", "said"),
    [
        ("--parameters", "5161\t0.5\n\nG0 X1\n", "p.var:3: `G0 X1` is no stored parameter"),
        ("--parameters", "5602 1\n", "p.var:1: `5602 1` is no stored parameter"),
        ("--parameters", "31 one\n", "p.var:1: `31 one` is no stored parameter"),
        ("--parameters", "\0\1\2", "p.var:1: "),
        ("--tool-table", "; old\nT1 P1 D3\nG0 X1\n", "p.var:3: `G0 X1` is no tool"),
        ("--tool-table", "T1 P1 length 5 ;a\n", "p.var:1: `T1 P1 length 5` is no tool"),
        ("--tool-table", "P1 D3\n", "p.var:1: `P1 D3` is no tool"),
    ],
)
def test_a_file_that_is_none_of_its_sort_is_refused_at_its_line(shell, option, text, said):
    shell.write("p.ngc", "G0 X#31\nM2\n")
    shell.write("p.var", text)
    ran = shell.run("expand", "p.ngc", option, "p.var")
    assert (ran.code, ran.out) == (2, "")
    assert said in ran.err
    shell.write("deburr.toml", f'[rs274]\n{option.removeprefix("--")} = "p.var"\n')
    assert said in shell.run("check", "p.ngc").err


def test_files_of_their_sort_are_read(shell):
    shell.write("p.ngc", "G0 X#31 Y#5410\nT2 M6\nM2\n")
    shell.write("p.var", "\n31\t7.5\r\n5161  -1e-3\n")
    shell.write("t.tbl", "; a table\n\nT2 P2 Z+25.4 D.5 ;mill T9 X\nt3p3 d1\n")
    ran = shell.run("expand", "p.ngc", "--parameters", "p.var", "--tool-table", "t.tbl")
    assert (ran.code, ran.out) == (0, "G0 X7.5 Y0\nT2 M6\nM2\n")


@pytest.mark.parametrize(
    ("program", "said"),
    [
        ("T9 M6\nM2\n", "1:1 `T9`"),
        ("#1=9\nT[#1] M6\nM2\n", "2:1 `T9`"),
        ("#1=9\nG43 H#1\nM2\n", "2:5 `H9`"),
        ("G1 F100 X-1\nG41 D9\nG1 X10\nM2\n", "2:5 `D9`"),
    ],
)
def test_a_tool_that_a_given_table_does_not_have_stops_the_run(shell, program: str, said: str) -> None:
    shell.write("p.ngc", program)
    shell.write("t.tbl", "T1 P1 Z5\nT4 P4\n")
    assert shell.run("expand", "p.ngc").code == 0
    ran = shell.run("expand", "p.ngc", "--tool-table", "t.tbl")
    assert (ran.code, ran.out) == (1, "")
    place, word = said.split()
    assert f"[rs274.tool-unknown]: {word} is tool 9, which the tool table `t.tbl` does not have;" in ran.err
    assert f"p.ngc:{place}\n" in ran.err
    checked = shell.run("check", "--run", "p.ngc", "--tool-table", "t.tbl")
    assert checked.code == 1
    assert "rs274.tool-unknown" in checked.out


def test_a_tool_that_comes_late_is_looked_for_as_well(shell) -> None:
    """Calculated tools are only known in the flat program, of which the first 20,000 lines are followed."""
    shell.write("p.ngc", "#1=9\no1 repeat [20010]\nG1 F100 X1\no1 endrepeat\nT1 M6\n(T9)\nG43 H[#1]\nM2\n")
    shell.write("t.tbl", "T1 P1 Z5\n")
    assert shell.run("expand", "p.ngc", "-o", "out.ngc").code == 0
    ran = shell.run("expand", "p.ngc", "--tool-table", "t.tbl")
    assert (ran.code, ran.out) == (1, "")
    assert ran.err.count("error[") == 1 and "p.ngc:7:5\n" in ran.err
    assert "[rs274.tool-unknown]: `H9` is tool 9, which the tool table `t.tbl` does not have;" in ran.err


def test_a_name_that_nothing_reads_is_warned_of(shell):
    shell.write("a.ngc", "#<width>=5\no<deep> call\nG0 X#<Wi dth> Y#03\nM2\n")
    shell.write("deep.ngc", "o<deep> sub\nG0 Z#<_deep>\no<deep> endsub\n")
    given = ["-D", "_deep=2", "-D", "3=1", "-D", "#<width>=1", "-D", "wdith=2", "-D", "7=1"]
    ran = shell.run("expand", "a.ngc", *given)
    assert (ran.code, ran.out) == (0, "G0 Z2\nG0 X5 Y1\nM2\n")
    assert ran.err == (
        "deburr: warning: -D wdith: the program never reads `#<wdith>`; did you mean `width`?\n"
        "deburr: warning: -D 7: the program never reads `#7`\n"
    )
    assert shell.run("expand", "-q", "a.ngc", *given).err == ""


def test_what_a_run_alone_knows_may_read_any_name(shell):
    shell.write("a.ngc", "#1=7\nG0 X##1\nM2\n")
    assert shell.run("expand", "a.ngc", "-D", "7=3") == (0, "G0 X3\nM2\n", "")
    shell.write("12.ngc", "o12 sub\nG0 X#<_wide>\no12 endsub\n")
    shell.write("b.ngc", "#1=12\no#1 call\nM2\n")
    assert shell.run("expand", "b.ngc", "-D", "_wide=3") == (0, "G0 X3\nM2\n", "")


@pytest.mark.parametrize("command", ["expand", "check"])
def test_what_the_control_sets_itself_cannot_be_given(shell, command):
    shell.write("a.ngc", "#1=5\nG0 X#1\nM2\n")
    said = "deburr: error: -D 5420=1: the control sets `#5420` itself; programs can only read it\n"
    assert shell.run(command, "a.ngc", "-D", "5420=1") == (2, "", said)
    assert shell.run(command, "-q", "a.ngc", "-D", "5419=1").code == 0


@pytest.mark.parametrize("command", ["expand", "check"])
@pytest.mark.parametrize("name", ["_metric", "#<_Feed>", "_x", "_value", "_current_tool", "_line"])
def test_a_predefined_name_that_follows_from_the_program_cannot_be_given(shell, command, name):
    shell.write("a.ngc", "G21\nG0 X[#<_metric> + #<_x>]\nM2\n")
    plain = name.strip("#<>").lower()
    said = f"deburr: error: -D {name.removeprefix('#')}=7: the control sets `#<{plain}>` itself; programs can only read it\n"
    assert shell.run(command, "a.ngc", "-D", f"{name}=7") == (2, "", said)


def test_what_only_the_machine_knows_can_be_given_by_its_name(shell):
    shell.write("a.ngc", "G21\no1 if [#<_task> EQ 1]\nG0 X#<_HAL[spindle at]> (debug,#<_ini[a]b>)\no1 endif\nM2\n")
    given = ["-D", "_task=1", "-D", "_hal[spindleat]=2.5", "-D", "#<_ini[a]b>=4"]
    ran = shell.run("expand", "a.ngc", *given)
    assert ran == (0, "G21\nG0 X2.5 (MSG,4.000000)\nM2\n", "")
    assert shell.run("expand", "a.ngc", *given, "--machine-values", "simulate", "-D", "_task=0").out == "G21\nM2\n"
    assert "; -D _ini[a]b=... gives it\n" in shell.run("expand", "a.ngc", *given[:4]).err
    # A name counts without its blanks, as the control has it.
    shell.write("b.ngc", "G0 X#<wi dth>\nM2\n")
    assert shell.run("expand", "b.ngc", "-D", "w idth=3") == (0, "G0 X3\nM2\n", "")


@pytest.mark.parametrize("fault", ["", "G0 X[1/0]\n", "G0 X1 (a (b) c)\no<unclosed> if [1]\n"])
def test_a_misspelt_name_is_warned_of_where_nothing_is_run_either(shell, fault):
    shell.write("a.ngc", f"G21\n{fault}o<deep> call\nM2\n")
    shell.write("deep.ngc", "o<deep> sub\nG0 Z#<_depth>\no<deep> endsub\n")
    warning = "deburr: warning: -D _deth: the program never reads `#<_deth>`; did you mean `_depth`?\n"
    ran = shell.run("expand", "a.ngc", "-D", "_deth=4")
    assert ran.code == 1 and ran.err.startswith(warning)
    assert "warning: -D" not in shell.run("expand", "-q", "a.ngc", "-D", "_deth=4").err
    assert "warning: -D" not in shell.run("expand", "a.ngc", "-D", "_depth=4").err


NEAR_HALF = "G21 G90 G17 F100\n#1=15.000005\nG0 X0 Y0\nG2 X[30] Y0 R#1\nG2 X[60] R#1\nM2\n"
"""Arcs whose centre lies sqrt(15.000005^2 - 15^2) = 0.0122 mm beside the line between their ends, as the interpreter prints it, too."""
MOVED = "deburr: warning: p.ngc:4: `--decimals {}` moves the centre of this arc by {} mm; more decimals keep it\n"


@pytest.mark.parametrize(
    ("decimals", "said"),
    [
        ("4", MOVED.format(4, "0.012")),
        # R15.00001: sqrt(15.00001^2 - 15^2) = 0.0173.
        ("5", MOVED.format(5, "0.005")),
        ("6", ""),
        ("exact", ""),
    ],
)
def test_a_centre_that_rounding_moves(shell, decimals, said):
    shell.write("p.ngc", NEAR_HALF)
    assert shell.run("expand", "p.ngc", "--decimals", decimals, "-o", "flat.ngc") == (0, "", said)
    assert shell.run("expand", "p.ngc", "--decimals", decimals, "-q", "-o", "flat.ngc") == (0, "", "")


def test_arcs_that_rounding_leaves_where_they_are(shell):
    # A quarter of a circle, and a centre that is written: what is moved is moved by what was rounded, no more. The R is in a comment.
    shell.write(
        "p.ngc", "G21 G90 F100\n#1=[1/3]\nG0 X0 Y0\nG2 X[10+#1] Y[10+#1] R[10+#1]\nG3 X[#1] Y[#1] I-5 J-5 (R)\nM2\n"
    )
    assert shell.run("expand", "p.ngc", "--decimals", "3", "-o", "flat.ngc") == (0, "", "")


def test_an_arc_that_rounding_makes_impossible(shell):
    # A way of 20.006 mm with a radius of 10.0031 becomes one of 20.01 with a radius of 10, which the interpreter refuses as too small.
    shell.write("p.ngc", "G21 G90 G17 F100\n#1=10.0031\nG0 X0 Y0\nG2 X[20.006] Y0 R#1\nM2\n")
    said = "deburr: warning: p.ngc:4: it is `--decimals 2` that makes this arc one that the control refuses; with more it is none\n"
    found = shell.run("expand", "p.ngc", "--decimals", "2", "-o", "flat.ngc")
    assert (found.code, found.err.splitlines(keepends=True)[0]) == (1, said)
    assert shell.run("expand", "p.ngc", "--decimals", "4", "-o", "flat.ngc") == (0, "", "")
    # Here it is the program that is wrong.
    shell.write("p.ngc", "G21 G90 G17 F100\n#1=10.0\nG0 X0 Y0\nG2 X[20.012] Y0 R#1\nM2\n")
    assert "--decimals" not in shell.run("expand", "p.ngc", "--decimals", "2", "-o", "flat.ngc").err
