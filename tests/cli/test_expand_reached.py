"""`--reached-only`: what a run does not come to is warned of, in every language; what it comes to stops it at its line."""

import pytest

RS274 = "o1 if [0]\n  foo $$\no1 endif\no2 if [1]\nG0 X1\nM2\n"
METAGCODE = "#IF1 |a| equalto 1 n\n  #LOOP2 |z|\n  #ENDLOOP2\n#ENDIF1\nG1 X2\n#IF3 |a| equalto 0 n\nM30\n"
CGT = "@LINE\nX#XPOS\n#IF(#V1>5)<\n #CALL()\n>\nY#YPOS\n@\n@ARC\n#EVAL(\n@\n@START\nG21\n@\n@END\nM30\n@\n"
Z32 = "G0 X1\n!GON20!\nG1 X<1+\nN20 G0 X2\nM30\n"
CL = "GOTO/1,2,0\nFINI\n"
PROGRAMS = {
    "p.ngc": (RS274, (), "G0 X1\nM2\n", ((2, "rs274.function-unknown"), (4, "rs274.o-unclosed"))),
    "p.mgc": (
        METAGCODE,
        ("-D", "a=0"),
        "G1 X2\nM30\n",
        ((2, "metagcode.loop-syntax"), (6, "metagcode.block-unclosed")),
    ),
    "p.cgt": (
        CGT,
        ("--input", "p.cl"),
        "G21\nX1.0\nY2.0\nM30\n",
        ((4, "cgt.command-syntax"), (9, "cgt.command-syntax")),
    ),
    "p.z32": (Z32, (), "G0 X1\nG0 X2\nM30\n", ((3, "z32.angle-unclosed"),)),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_what_is_not_reached_is_warned_of(shell, name):
    text, options, flat, faults = PROGRAMS[name]
    shell.write("p.cl", CL)
    shell.write(name, text)
    ran = shell.run("expand", name, *options)
    assert (ran.code, ran.out) == (1, "")
    ran = shell.run("expand", name, *options, "--reached-only")
    assert (ran.code, ran.out) == (0, flat), ran.err
    for line, rule in faults:
        assert f"{name}:{line}:" in ran.err
        assert rule in ran.err
    assert ran.err.count("(does not stop this run)") == ran.err.count("warning") >= len(faults)
    assert "error" not in ran.err
    assert shell.run("expand", name, *options, "--reached-only", "-q") == (0, flat, "")
    assert shell.run("expand", name, *options, "--reached-only", "--stats", "json").code == 0
    assert shell.run("expand", name, *options, "--reached-only", "--diff", name).code == 0
    assert shell.run("plot", name, *options).code == 1
    assert shell.run("plot", name, *options, "--reached-only").code == 0


@pytest.mark.parametrize(
    ("name", "text", "options", "rule", "line"),
    [
        ("p.ngc", RS274.replace("[0]", "[1]"), (), "rs274.function-unknown", 2),
        ("p.ngc", RS274.replace("o2 if [1]", "o2 if [0]"), (), "rs274.o-unclosed", 4),
        ("p.ngc", RS274.replace("foo $$", "(a (b) c)"), (), "rs274.comment-nested", 2),
        ("p.ngc", "G0 X1\no1 if [0]\nfoo\no1 endif\n", (), "rs274.program-end-missing", 4),
        ("p.mgc", METAGCODE, ("-D", "a=1"), "metagcode.loop-syntax", 2),
        ("p.mgc", METAGCODE, ("-D", "a=2"), "metagcode.block-unclosed", 6),
        (
            "p.mgc",
            METAGCODE.replace("#LOOP2 |z|\n  #ENDLOOP2", "#FILE none"),
            ("-D", "a=0"),
            "metagcode.file-missing",
            2,
        ),
        ("p.mgc", "#LOP1 |a| 2 c\nG1 X1\n#ENDLOOP1\n", ("-D", "a=2"), "metagcode.unknown-directive", 1),
        ("p.mgc", "#IF1 1 equalto 2 n\n#LOP1 |a|\n#ENDIF1\n#ENDLOOP1\n", (), "metagcode.block-unopened", 4),
        ("p.cgt", CGT, ("--input", "p.cl", "-D", "V1=6"), "cgt.command-syntax", 4),
        (
            "p.cgt",
            CGT.replace("@ARC", "@LINE2").replace("Y#Y", "#CALL(LINE2)Y#Y"),
            ("--input", "p.cl"),
            "cgt.command-syntax",
            9,
        ),
        ("p.z32", Z32.replace("GON20", "HA=1"), (), "z32.angle-unclosed", 3),
    ],
)
def test_what_is_reached_stops_the_run(shell, name, text, options, rule, line):
    shell.write("p.cl", CL)
    shell.write(name, text)
    ran = shell.run("expand", name, *options, "--reached-only")
    assert (ran.code, ran.out) == (1, "")
    assert f"error[{rule}]" in ran.err and f"{name}:{line}:" in ran.err, ran.err
    assert ran.err.endswith("deburr: nothing was written: 1 error\n")
    ran = shell.run("expand", name, *options, "--reached-only", "--partial")
    assert ran.code == 1


def test_what_is_reached_in_a_file_that_is_called_stops_the_run(shell):
    """The call's own line is right: what the file is wrong in may never run."""
    shell.write("p.ngc", "o<drill> call [0]\nM2\n")
    drill = "o<drill> sub\no1 if [#1]\nG0 X1 X2\no1 endif\nG0 X[#1+2]\no<drill> endsub\n"
    shell.write("drill.ngc", drill)
    assert shell.run("expand", "p.ngc").code == 1
    ran = shell.run("expand", "p.ngc", "--reached-only")
    assert (ran.code, ran.out) == (0, "G0 X2\nM2\n")
    assert "warning[rs274.word-repeated]" in ran.err and "drill.ngc:3:" in ran.err and "sub-file" not in ran.err
    shell.write("p.ngc", "o<drill> call [1]\nM2\n")
    ran = shell.run("expand", "p.ngc", "--reached-only")
    assert (ran.code, ran.out) == (1, "")
    assert "error[rs274.word-repeated]" in ran.err and "drill.ngc:3:" in ran.err


def test_without_the_option_nothing_has_changed(shell):
    for name, (text, options, *_) in PROGRAMS.items():
        shell.write("p.cl", CL)
        shell.write(name, text)
        assert "does not stop" not in shell.run("expand", name, *options).err
