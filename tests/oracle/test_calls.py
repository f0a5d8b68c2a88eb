"""Calls, files and named parameters: deburr has an error where the interpreter refuses a program, and none where it runs it."""

from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.oracle import judged
from support.pages import MemoryHost

DIALECT = by_name("rs274")
FOO = "o<foo> sub\nG0 X1\no<foo> endsub\n"
BAR = FOO.replace("foo", "bar")
CALLS_BAR = "o<foo> sub\no<bar> call\no<foo> endsub\n"
CONTOUR = "o100 sub\nG0 X2\nG1 Z-5\nX3\no100 endsub\n"
LATHE = "G18 G90 G21 F100\nG0 X10 Z5\nG71 Q100 X4 Z2 D0.5 I1 R0.5\n"
CASES: dict[str, tuple[str, dict[str, str]]] = {
    "read, then set on the line": ("G0 X#<a> #<a>=2\nM2\n", {}),
    "set from a later setting": ("#<a>=#<b> #<b>=1\nM2\n", {}),
    "set in a loop, read above": ("#1=0\no1 while [#1 LT 2]\no2 if [#1]\nG0 X#<a>\no2 endif\n#<a>=1\n#1=[#1+1]\no1 endwhile\nM2\n", {}),
    "value of a sub": ("o2 sub\no2 endsub [#<zz>]\no2 call\nM2\n", {}),
    "value of a return": ("o2 sub\no2 return [#<zz>]\no2 endsub\no2 call\nM2\n", {}),
    "asked by EXISTS": ("o1 if [EXISTS[#<a>]]\nG0 X#<a>\no1 endif\nM2\n", {}),
    "read in a skipped branch": ("o5 if [0]\nG0 X#<nope>\no5 endif\nM2\n", {}),
    "read in the label of a skipped block": ("o1 if [0]\no[#<nope>] if [1]\no2 endif\no1 endif\nM2\n", {}),
    "condition behind a taken branch": ("o1 if [1]\nG0 X1\no1 elseif [#<nope>]\no1 endif\nM2\n", {}),
    "global of a called file": ("o<foo> call\nG0 X#<_q>\nM2\n", {"foo.ngc": "o<foo> sub\n#<_q>=3\no<foo> endsub\n"}),
    "global of nobody": ("o<foo> call\nG0 X#<_q>\nM2\n", {"foo.ngc": FOO}),
    "local of the caller": ("#<a>=1\no<foo> call\nM2\n", {"foo.ngc": FOO.replace("X1", "X#<a>")}),
    "call in a skipped branch": ("o5 if [0]\no<nope> call\no5 endif\nM2\n", {}),
    "call in an uncalled sub": ("o5 sub\no<nope> call\no5 endsub\nG0 X1\nM2\n", {}),
    "sub behind M2": ("o1 call\nM2\no1 sub\no1 endsub\n", {}),
    "sub behind M2 that was called before": ("o5 call\no6 call\nM2\no5 sub\no5 endsub\no6 sub\no5 call\no6 endsub\n", {}),
    "sub behind M2 that was passed over": ("o6 call\nM2\no5 sub\no5 endsub\no6 sub\no5 call\no6 endsub\n", {}),
    "sub behind M2 that stands further down": ("o6 call\nM2\no6 sub\no5 call\no6 endsub\no5 sub\no5 endsub\n", {}),
    "sub behind M2 calls one before it": ("o5 sub\no5 endsub\no6 call\nM2\no6 sub\no5 call\no6 endsub\n", {}),
    "label by a name of the caller": ("o100 sub\nG0 X#1\no100 endsub\n#<n>=100\no#<n> call [5]\no[#<n>] call [6]\nM2\n", {}),
    "number by a name of the caller": ("#<n>=100\nM98 P#<n>\nM2\no100\nG0 X7\nM99\n", {}),
    "call above the definition": ("o1 call\no1 sub\no1 endsub\nM2\n", {}),
    "call above the definition, skipped": ("o2 if [0]\no1 call\no2 endif\no1 sub\no1 endsub\nM2\n", {}),
    "call in a call above the definition": ("o1 sub\no2 call\no1 endsub\no1 call\no2 sub\no2 endsub\nM2\n", {}),
    "definition in a branch": ("o5 if [1]\no1 sub\no1 endsub\no5 endif\no1 call\nM2\n", {}),
    "definition in a skipped branch": ("o5 if [0]\no1 sub\no1 endsub\no5 endif\no1 call\nM2\n", {}),
    "definition in a loop": ("o5 repeat [2]\no1 sub\no1 endsub\no1 call\no5 endrepeat\nM2\n", {}),
    "file and definition below": ("o<foo> call\n" + FOO + "M2\n", {"foo.ngc": FOO}),
    "file and definition above": (FOO + "o<foo> call\nM2\n", {"foo.ngc": FOO}),
    "M98 to a file without the program": ("M98 P2\nM30\nO2\nG0 X5\nM99\n", {"2.ngc": "G0 X1\nM2\n"}),
    "M98 to a file with the program": ("M98 P2\nM30\nO2\nG0 X5\nM99\n", {"2.ngc": "O2\nG0 X1\nM99\n"}),
    "M98 to nothing": ("M98 P100\nM2\n", {}),
    "M98 to a program above": ("o100\nG0 X1\nM99\nM98 P100\nM2\n", {}),
    "contour above": (CONTOUR + LATHE + "M2\n", {}),
    "contour behind M2": (LATHE + "M2\n" + CONTOUR, {}),
    "contour below": (LATHE + CONTOUR + "M2\n", {}),
    "contour in a file": (LATHE + "M2\n", {"100.ngc": CONTOUR}),
    "contour nowhere": (LATHE + "M2\n", {}),
    "capital in a file": ("o<Foo> call\nM2\n", {"Foo.ngc": FOO}),
    "capital in a call": ("o<Foo> call\nM2\n", {"foo.ngc": FOO}),
    "other extension": ("o<foo> call\nM2\n", {"foo.nc": FOO}),
    "blank in a file": ("o<my foo> call\nM2\n", {"my foo.ngc": FOO.replace("foo", "my foo")}),
    "folder in a call": ("o<sub/foo> call\nM2\n", {"sub/foo.ngc": FOO}),
    "folder in call and sub": ("o<sub/foo> call\nM2\n", {"sub/foo.ngc": FOO.replace("foo", "sub/foo")}),
    "file of another sub": ("o<foo> call\nM2\n", {"foo.ngc": BAR}),
    "sub behind M2 of a file": ("o<foo> call\nM2\n", {"foo.ngc": "G0 X1\nM2\n" + FOO}),
    "rubbish above the sub of a file": ("o<foo> call\nM2\n", {"foo.ngc": "foo bar [\n" + FOO}),
    "error in a file": ("o<foo> call\nM2\n", {"foo.ngc": FOO.replace("X1", "X1 X2")}),
    "label twice in a file": ("o<foo> call\nM2\n", {"foo.ngc": FOO.replace("G0 X1", "o1 if [1]\no1 endif\no1 if [1]\no1 endif")}),
    "no endsub": ("o<foo> call\nM2\n", {"foo.ngc": "o<foo> sub\nG0 X1\n"}),
    "no endsub but M2": ("o<foo> call\nM2\n", {"foo.ngc": "o<foo> sub\nG0 X1\nM2\n"}),
    "no endsub but a return": ("o<foo> call\nM2\n", {"foo.ngc": "o<foo> sub\nG0 X1\no<foo> return\n"}),
    "sub in a sub of a file": ("o<foo> call\nM2\n", {"foo.ngc": FOO.replace("G0 X1", BAR + "o<bar> call")}),
    "helper above the file's sub": ("o<foo> call\nM2\n", {"foo.ngc": BAR + CALLS_BAR}),
    "helper below the file's sub": ("o<foo> call\nM2\n", {"foo.ngc": CALLS_BAR + BAR}),
    "helper above, and in the program": (BAR + "o<foo> call\nM2\n", {"foo.ngc": BAR + CALLS_BAR}),
    "helper above, and in a file": ("o<foo> call\nM2\n", {"foo.ngc": BAR + CALLS_BAR, "bar.ngc": BAR}),
    "helper in the program": (BAR + "o<foo> call\nM2\n", {"foo.ngc": CALLS_BAR}),
    "helper behind the program's M2": ("o<foo> call\nM2\n" + BAR, {"foo.ngc": CALLS_BAR}),
    "helper nowhere": ("o<foo> call\nM2\n", {"foo.ngc": CALLS_BAR}),
    "% in both": ("%\no<foo> call\n%\n", {"foo.ngc": "%\n" + FOO + "%\n"}),
    "% below a comment in both": ("%\no<foo> call\n%\n", {"foo.ngc": "(foo)\n%\n" + FOO}),
    "% in the file": ("o<foo> call\nM2\n", {"foo.ngc": "%\n" + FOO + "%\n"}),
    "% in the program": ("%\no<foo> call\n%\n", {"foo.ngc": FOO}),
    "% at the end of the file": ("o<foo> call\nM2\n", {"foo.ngc": FOO + "%\n"}),
    "% in the program and in the second file": ("%\no<foo> call\n%\n", {"foo.ngc": CALLS_BAR, "bar.ngc": "%\n" + BAR}),
    "% in both files": ("o<foo> call\nM2\n", {"foo.ngc": "%\n" + CALLS_BAR + "%\n", "bar.ngc": "%\n" + BAR}),
    "label of a calculation": ("o[1+1] call\nM2\n", {"2.ngc": "o2 sub\no2 endsub\n"}),
    "sub that returns before it calls itself": ("o1 sub\no2 if [#1 LE 1]\no1 return\no2 endif\no1 call [#1-1]\no1 endsub\no1 call [3]\nM2\n", {}),
    "sub that calls itself": ("o1 sub\no1 call\no1 endsub\no1 call\nM2\n", {}),
}  # fmt: skip


def errors(program: str, files: dict[str, str]) -> list[str]:
    """The rules of which there is an error."""
    host = MemoryHost({"p.ngc": program, **files})
    found = Analysis(Document.parse(program, DIALECT), RuleSet(DIALECT), "p.ngc", host).findings()
    return [finding.rule for finding in found if finding.severity is Severity.ERROR]


@pytest.mark.oracle
@pytest.mark.parametrize("name", CASES)
def test_an_error_where_the_interpreter_stops(name: str, tmp_path: Path) -> None:
    program, files = CASES[name]
    verdict = judged(program, tmp_path, files)
    assert bool(errors(program, files)) is not verdict.accepted, (verdict.message, errors(program, files))


@pytest.mark.oracle
@pytest.mark.parametrize("sign", "!^%,@#=:+-.~*?[]")
def test_signs_that_may_stand_in_a_file_name(sign: str, tmp_path: Path) -> None:
    files = {f"a{sign}b.ngc": f"o<a{sign}b> sub\no<a{sign}b> endsub\n"}
    program = f"o<a{sign}b> call\nM2\n"
    assert judged(program, tmp_path, files).accepted
    assert errors(program, files) == []


@pytest.mark.oracle
@pytest.mark.parametrize("sign", "'\"\\{})&|$`")
def test_signs_that_make_a_shell_of_a_file_name(sign: str, tmp_path: Path) -> None:
    files = {f"a{sign}b.ngc": f"o<a{sign}b> sub\no<a{sign}b> endsub\n"}
    program = f"o<a{sign}b> call\nM2\n"
    assert not judged(program, tmp_path, files).accepted
    assert errors(program, files) == ["rs274.sub-name-unsafe"]
