"""Values that are known without a run: they are those that a run finds, and hints, lenses and calls say what they must."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest

from deburr.ide.calls import incoming, outgoing, prepared
from deburr.ide.hints import hints
from deburr.ide.known import known
from deburr.ide.lenses import lenses
from deburr.symbols.index import at
from support.views import at_cursor


@pytest.mark.parametrize(
    ("dialect", "text", "said"),
    [
        ("rs274", "#1=5\nX#<|>1\n", "5"),
        ("rs274", "#1=5 X#<|>1\n", None),
        ("rs274", "/#1=5\nX#<|>1\n", None),
        ("rs274", "#1=5\n#[1+0]=6\nX#<|>1\n", "6"),
        ("rs274", "#1=5\no1 if [1]\nX#<|>1\no1 endif\n", "5"),
        ("rs274", "o1 if [1]\n#1=5\no1 endif\nX#<|>1\n", "5"),
        ("rs274", "o1 if [1]\n#1=5\nX#<|>1\no1 endif\n", "5"),
        ("rs274", "#1=4\no1 if [1]\n#1=5\no1 elseif [1]\nX#<|>1\no1 endif\n", None),
        ("rs274", "#1=0\no1 while [#<|>1 LT 5]\n#1=[#1+1]\no1 endwhile\n", None),
        ("rs274", "o1 while [1]\n#1=5\nX#<|>1\n#1=6\no1 endwhile\n", "5"),
        ("rs274", "#31=5\nM98 P100\nX#3<|>1\n", None),
        ("rs274", "M98 P100\n#31=5\nM30\nO100\nX#3<|>1\nM99\n", None),
        ("rs274", "#1=5\no<s> call\nX#<|>1\n", "5"),
        ("rs274", "#31=5\no<s> call\nX#3<|>1\n", None),
        ("rs274", "o<s> sub\n#1=5\no<s> endsub\nX#<|>1\n", None),
        ("rs274", "#5220=5\nX#52<|>20\n", None),
        ("rs274", "#1=5\no1 if [1]\nX#<|>1\n", None),
        ("rs274", "#1=[1/0]\nX#<|>1\n", None),
        ("cgt", "@LINE\n#EVAL(#V1=2)\n@\n@ARC\nX#V<|>1\n@\n", None),
        ("cgt", "@LINE\n#EVAL(#V1=2)<#MOV#EVAL(#V1=3)>\nX#V<|>1\n@\n", None),
        ("cgt", "@LINE\n#EVAL(#S1=2)\nX#S<|>1\n@\n", None),
        ("cgt", "@LINE\nX#V<|>1\n@\n@START\n#EVAL(#V1=2)\n@\n", "2"),
        ("cgt", "@LINE\nX#V<|>1\n@\n@START\n#EVAL(#V1=2)\n@\n@RAP\n#EVAL(#V1=#V1+1)\n@\n", None),
        ("cgt", "@DECLARE\n#CALCDEC #c\n@\n@LINE\n#EVAL(#c=2)\nX#<|>c\n@\n@$c\n#RETNUM(1)\n@\n", None),
        ("z32", "(P)\n!HA=2!\nX<H<|>A>\n", "2"),
        ("z32", "(P)\nHA 2,5\nX<H<|>A>\n", "2.5"),
        ("z32", "(P)\n!IF HA=5; GON10!\nX<H<|>A>\nN10\n", None),
        ("z32", "(P)\n!HA=2!\n!GON10-N20!\nX<H<|>A>\nM30\nN10 HA3\nN20\n", "3"),
        ("z32", "(P)\n!HA=2!\n!GOP5!\nX<H<|>A>\n", None),
        ("z32", "(P)\n!HX=2!\n!PC!\nX<H<|>X>\n", None),
        ("z32", "(P)\n!X=2!\nX7\nY<<|>X>\n", "7"),
        ("metagcode", "X|<|>a|\n", None),
    ],
)  # fmt: skip
def test_what_is_known(dialect: str, text: str, said: str | None) -> None:
    view, pos = at_cursor(dialect, text)
    placed = at(view.document, pos.line, pos.col)
    assert placed is not None
    value = known(view, placed)
    assert (None if value is None else value.plain) == said


VALUES = {"variables": "part.vars"}


@pytest.mark.parametrize(
    ("dialect", "text", "settings", "found"),
    [
        ("metagcode", "#LOOP1 |D| 5 c |W| 1 r\nZ|D| X|K|\n#ENDLOOP1\nZ|D|", VALUES, ["0:10 passes, step 1.5", "0:step 1", "1:=3", "3:=15"]),
        ("metagcode", "#LOOP1 |D| |K| c\n#ENDLOOP1\n", VALUES, ["0:=3", "0:5 passes, step 3"]),
        ("metagcode", "#LOOP1 |D| 0 c\n#ENDLOOP1\n", VALUES, []),
        ("metagcode", "#LOOP1 |none| 5 c\n#ENDLOOP1\n", VALUES, []),
        ("rs274", "#<x>=[2*3]\nX[#<x>+1] Y[1+1] Z[SIN[30]] A[5]\n", {}, ["0:=6", "1:=6", "1:=2", "1:=0.5"]),
        ("rs274", "#<x>=3\no1 repeat [#<x>]\no1 endrepeat\no2 repeat [2.4*1]\no2 endrepeat\no3 repeat [5]\no3 endrepeat\n", {}, ["1:3 passes", "3:2 passes"]),
        ("rs274", "X[1/0]\n", {}, []),
        ("cgt", "@LINE\n#EVAL(#V1=2*3)\nX#V1#TABLE(TAB,1)#IF(#COOLNT=1)<a>\n#REPEAT(#V1)<x>\n@\n@TAB\na,hello\nb,world\n@\n", {}, ["1:=6", "2:=6", "2:=world", "2:=M08", "3:6 passes"]),
        ("cgt", "@LINE\nX#V1\n#REPEAT(#V1)<x>\n@\n@START\n#EVAL(#V1=6)\n@\n", {}, ["1:=6", "2:6 passes"]),
        ("cgt", "@LINE\n#TABLE(TAB,7)#EVAL(#MOV=9)\n@\n@TAB\na,hello\n@\n", {}, []),
        ("rs274", "#3=0\no1 while [#3 LT 100]\nG0 X#3\n#3=[#3+10]\no1 endwhile\nX#3\n", {}, ["1:10 passes", "5:=100"]),
        ("rs274", "#4=5\no2 do\nG0 X#4\n#4=[#4-1]\no2 while [#4 GT 0]\nX#4\n", {}, ["4:5 passes", "5:=0"]),
        ("rs274", "#4=#5420\no2 do\nG0 X#4\n#4=[#4-1]\no2 while [#4 GT 0]\nX#4\n", {}, []),
        ("metagcode", "#LOOP1 |D| |none| c\nZ|D|\n#ENDLOOP1\n", VALUES, []),
        ("cgt", "@LINE\n#IF(#XPOS>0)<#EVAL(#V2=2)>#ELSE<#EVAL(#V2=2)>\nX#V2\n#EVAL(#V3=MOD(#XPOS,2))\nX#V3\n@\n", {}, ["2:=2"]),
        ("z32", "(P)\nHA0\nN10 HA<HA+1>\nX<HA>\n!IF HA<5; GON10!\nY<HA>\n", {}, ["4:5 passes", "5:=5"]),
        ("z32", "(P)\nHA<PAL[300]>\nN10 HA<HA+1>\nX<HA>\n!IF HA<5; GON10!\nY<HA>\n", {}, []),
        ("z32", "(P)\n!PAL[1]=3!\nG25YZX\nAA1 X<PAL[1]+2> Y<2*4> Z<HA>\n", {}, ["3:=Y", "3:=3", "3:=8"]),
    ],
)  # fmt: skip
def test_hints(dialect: str, text: str, settings: Mapping[str, Any], found: list[str]) -> None:
    view, _ = at_cursor(dialect, text, settings, part_vars="D=15\nW=10\nK=3\n")
    assert [f"{each.line}:{each.text}" for each in hints(view, 0, 99)] == found


@pytest.mark.parametrize(
    ("dialect", "text", "settings", "found"),
    [
        ("rs274", "#3=0\no1 while [#3 LT 100]\nG0 X#3\n#3=[#3+10]\no1 endwhile\n", {}, ["1:10 passes"]),
        ("rs274", "#4=5\no2 do\nG0 X#4\n#4=[#4-1]\no2 while [#4 GT 0]\n", {}, ["4:5 passes"]),
        ("rs274", "#<n>=3\no3 repeat [#<n>]\nG0 X1\no3 endrepeat\no4 repeat [#5420]\nG0 X1\no4 endrepeat\n", {}, ["1:3 passes"]),
        ("metagcode", "#LOOP1 |D| 5 c\nZ|D|\n#ENDLOOP1\n#LOOP2 |none| 5 c\nZ|none|\n#ENDLOOP2\n", VALUES, ["0:3 passes, step 5"]),
        ("cgt", "@START\n#EVAL(#V1=6)\n@\n@LINE\n#REPEAT(#V1)<x>\n#REPEAT(#TOOL)<y>\n@\n", {}, ["4:6 passes"]),
        ("z32", "(P)\nHA0\nN10 HA<HA+10>\nX<HA>\n!IF HA<100; GON10!\nN20 HB<HB+1>\n!IF HB<5; GON20!\n", {}, ["4:10 passes"]),
    ],
)  # fmt: skip
def test_lenses_of_loops(dialect: str, text: str, settings: Mapping[str, Any], found: list[str]) -> None:
    view, _ = at_cursor(dialect, text, settings, part_vars="D=15\n")
    assert [f"{each.line}:{each.text}" for each in lenses(view) if each.kind == "passes"] == found


@pytest.mark.parametrize(
    ("dialect", "text", "settings", "others", "calls"),
    [
        (
            "rs274",
            "o<a> sub\no<b> call\no<a> endsub\no<b<|>> call\nM2\n",
            {},
            {"b_ngc": "o<b> sub\no<c> call\no<b> endsub\n", "c_ngc": "o<c> sub\no<c> endsub\n"},
            ["b", "< a:2", "< main.ngc:4", "> c:2"],
        ),
        (
            "metagcode",
            "#FILE pa<|>rt\n#IF1 |a| equalto 1 n\n#FILE part\n#ENDIF1\n",
            {},
            {"Snippets__part": "#FILE deep\n", "Snippets__deep": "G0\n"},
            ["part", "< main.mgc:1,3", "> deep:1"],
        ),
        (
            "cgt",
            "@LINE\n#CALL(S<|>UB)\n@\n@SUB\n#GOTO(SUC)#TABLE(TAB,0)\n@\n@SUC\nX\n@\n@TAB\na,b\n@\n",
            {},
            {},
            ["SUB", "< LINE:2", "> SUC:5"],
        ),
        (
            "z32",
            "(P<|>)\n!GOP5!\n!:L254-A\\b.txt!\nM30\n",
            {"cmos-dir": "cmos", "file-root": "root"},
            {"cmos__5_z32": "G1\nG26\n", "root__A__b_txt": "G1\n!GOP5!\nG26\n"},
            ["main.z32", "> 5.z32:2", "> b.txt:3"],
        ),
        (
            "z32",
            "(P)\n!GOP5<|>!\n!:L254-A\\b.txt!\nM30\n",
            {"cmos-dir": "/job/cmos", "file-root": "/job/root"},
            {"cmos__5_z32": "G1\nG26\n", "root__A__b_z32": "G1\n!GOP5!\nG26\n"},
            ["5.z32", "< main.z32:2", "< b.z32:2"],
        ),
    ],
)
def test_calls(dialect: str, text: str, settings: Mapping[str, Any], others: dict[str, str], calls: list[str]) -> None:
    view, pos = at_cursor(dialect, text, settings, **others)
    (routine,) = prepared(view, pos)
    where = view.beside(routine.file)
    assert where is not None
    found = [routine.name]
    for sign, ends in (("<", incoming(where, routine)), (">", outgoing(where, routine))):
        found += [f"{sign} {each.routine.name}:{','.join(str(spot.line + 1) for spot in each.places)}" for each in ends]
    assert found == calls
