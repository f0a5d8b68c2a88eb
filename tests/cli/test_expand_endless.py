"""`deburr expand` on programs that never end: a located finding within the budget, in little memory, and nothing written."""

import tracemalloc

import pytest

NESTED = "#LOOP1 |z| .0001 c\n#LOOP2 |z| .0001 c\nG1 Z|z|\n#ENDLOOP2\n#ENDLOOP1\n"
ENDLESS = {
    "a step of 0": ({"p.mgc": "#LOOP1 |z| |s| c\nG1 Z|z|\n#ENDLOOP1\n"}, "metagcode.loop-step-zero", "p.mgc:1:12"),
    "loops in loops": ({"p.mgc": NESTED}, "metagcode.limit", "p.mgc:"),
    "a snippet that includes itself": (
        {"p.mgc": "G0\n#FILE a.txt\n", "Snippets/a.txt": "#FILE b.txt\n", "Snippets/b.txt": "#FILE a.txt\n"},
        "metagcode.snippet-cycle",
        "p.mgc:2:1",
    ),
    "snippets that double": (
        {"p.mgc": "#FILE 0.txt\n", **{f"Snippets/{at}.txt": f"#FILE {at + 1}.txt\n" * 9 for at in range(9)}}
        | {"Snippets/9.txt": "G0\n"},
        "metagcode.limit",
        "p.mgc:1:1",
    ),
    "a count in exponents": ({"p.cgt": "@START\n#REPEAT(1e12)<A>\n@\n@END\nM30\n@\n"}, "cgt.command-syntax", "p.cgt:2:10"),
    "a count that is too large": (
        {"p.cgt": "@START\n#EVAL(#V1=10^12)\n#REPEAT(#V1)<A>\n@\n@END\nM30\n@\n"},
        "cgt.limit",
        "p.cgt:3:9",
    ),
    "repeats in repeats": (
        {"p.cgt": "@START\n#REPEAT(99999)<\n#REPEAT(99999)<\n#EVAL(#V1=1)\n>\n>\n@\n@END\nM30\n@\n"},
        "cgt.limit",
        "p.cgt:",
    ),
    "sections that call each other": (
        {"p.cgt": "@START\n#CALL(a)\n@\n@a\n#CALL(b)\n@\n@b\nA\n#CALL(a)\n@\n@END\nM30\n@\n"},
        "cgt.limit",
        "p.cgt:9:7",
    ),
    "sections that go to each other": (
        {"p.cgt": "@START\n#GOTO(a)\n@\n@a\n#GOTO(b)\n@\n@b\n#GOTO(a)\n@\n@END\nM30\n@\n"},
        "cgt.limit",
        "p.cgt:",
    ),
    "a jump to itself": ({"p.z32": "G0 X1\nN10 !GON10!\nM30\n"}, "z32.limit", "p.z32:2:1"),
    "a jump that counts": ({"p.z32": "HA0\nN10 HA<HA+1>\n!GON10!\nM30\n"}, "z32.limit", "p.z32:"),
    "ranges that never return": (
        {"p.z32": "G0 X1\nN10\n!GON20-N30!\nN20\n!GON10-N30!\nN30\nM30\n"},
        "z32.limit",
        "p.z32:5:1",
    ),
    "a section that calls itself": ({"p.z32": "G0 X1\n!GOP1!\nM30\n:1\n!GOP1!\nG26\n"}, "z32.call-depth", "p.z32:5:5"),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDLESS)
def test_what_never_ends_is_said_where_it_stands(shell, name):
    files, rule, place = ENDLESS[name]
    for file, text in files.items():
        shell.write(file, text)
    shell.write("t.cl", "GOTO/1,0,0\nFINI\n")
    program = next(iter(files))
    given = {"p.mgc": ("-D", "z=9", "-D", "s=0.0"), "p.cgt": ("--input", "t.cl"), "p.z32": ()}[program]
    tracemalloc.start()
    ran = shell.run("expand", program, *given, "--max-steps", "20000", "-o", "flat", "-q")
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert ran.code == 1 and not (shell.folder / "flat").exists()
    assert f"error[{rule}]: " in ran.err and f"--> {place}" in ran.err, ran.err
    assert ran.err.endswith("deburr: nothing was written: 1 error\n")
    assert peak < 100_000_000
