"""Where names lead, where they are used, and what they may be called instead."""

from __future__ import annotations

import pytest

from deburr.ide.definition import definition
from deburr.ide.highlight import highlights
from deburr.ide.references import references
from deburr.ide.rename import Cannot, prepared, renamed
from deburr_grammar.document import Document
from support.views import at_cursor, marked

SUBS = "o<drill> sub\n#<x>=1\nG1 X[#<x>+#1]\no<drill> endsub\no<drill> call [1]\n#<x>=5\n"


@pytest.mark.parametrize(
    ("dialect", "text", "others", "found"),
    [
        ("rs274", SUBS.replace("o<drill> call", "o<dr<|>ill> call"), {}, ["main:1:drill"]),
        ("rs274", SUBS.replace("+#1", "+#1").replace("X[#<x>", "X[#<<|>x>"), {}, ["main:2:x"]),
        ("rs274", "o<|>5 call\nM2\n", {"5_ngc": "o5 sub\no5 endsub\n"}, ["5:1:5"]),
        ("rs274", "o<de<|>ep> call\nM2\n", {"deep_ngc": "(nothing)\n"}, ["deep:1:"]),
        (
            "rs274",
            "#<_a<|>>=1\nG1 X#<_a>\no<s> call\n",
            {"s_ngc": "o<s> sub\n#<_a>=2\no<s> endsub\n"},
            ["main:1:_a", "s:2:_a"],
        ),
        ("metagcode", "#LOOP1 |Depth| 5 c\nZ|De<|>pth|\n#ENDLOOP1\n", {}, ["main:1:Depth"]),
        ("metagcode", "#FILE pa<|>rt\n", {"Snippets__part": "G1\n"}, ["part:1:"]),
        ("cgt", "@LINE\n#CALL(S<|>UB)\n@\n@SUB\nX\n@\n", {}, ["main:4:SUB"]),
        ("cgt", "@DECLARE\n#DEC #depth\n@\n@LINE\nX#de<|>pth\n@\n", {}, ["main:2:depth"]),
        ("z32", "(P)\nN10 G1\n!GON1<|>0!\n", {}, ["main:2:10"]),
        ("z32", "(P)\nN10 G1\n!GON10-N<|>20!\nN20 G0\n", {}, ["main:4:20"]),
        ("z32", "(P)\n!HA=2!\nX<H<|>A>\n", {}, ["main:2:HA"]),
        ("rs274", "G1 X<|>1\n", {}, []),
        ("z32", "(P)\n<|>\n", {}, []),
    ],
)
def test_definition(dialect: str, text: str, others: dict[str, str], found: list[str]) -> None:
    view, pos = at_cursor(dialect, text, **others)
    assert marked(view, definition(view, pos)) == found


@pytest.mark.parametrize(
    ("call", "settings", "found"),
    [
        ("GOP", {"cmos-dir": "cmos"}, ["/job/cmos/5.z32"]),
        ("GOS", {"cmos-dir": "cmos"}, ["/job/cmos-temp/05.z32"]),
        ("GOP", {}, ["/job/main.z32"]),
        ("GOS", {}, ["/job/main.z32"]),
    ],
)
def test_the_program_that_a_number_calls(call: str, settings: dict[str, str], found: list[str]) -> None:
    """Folders of programs are asked, temporary ones for GOS; without one, sections of the file (spec/z32.md §6.4, §10)."""
    text = f"(P)\n!{call}5<|>!\nM30\n:5\nG26\n"
    view, pos = at_cursor("z32", text, settings, {"cmos/5.z32": "G1\nG26\n", "cmos-temp/05.z32": "G0\nG26\n"})
    assert [spot.file for spot in definition(view, pos)] == found


@pytest.mark.parametrize(
    ("dialect", "text", "others", "found"),
    [
        ("rs274", SUBS.replace("#<x>=1", "#<<|>x>=1"), {}, ["main:2:x", "main:3:x"]),
        ("rs274", SUBS.replace("#<x>=5", "#<<|>x>=5"), {}, ["main:6:x"]),
        (
            "rs274",
            SUBS.replace("o<drill> sub", "o<<|>drill> sub"),
            {},
            ["main:1:drill", "main:4:drill", "main:5:drill"],
        ),
        (
            "rs274",
            "#<_<|>a>=1\no<s> call\n",
            {"s_ngc": "o<s> sub\nG1 X#<_A>\no<s> endsub\n", "t_ngc": "#<_a>=4\n"},
            ["main:1:_a", "s:2:_A"],
        ),
        (
            "metagcode",
            "X|<|>a|\n#FILE part\n",
            {"Snippets__part": "Y|a| (|a|)\n"},
            ["main:1:a", "part:1:a", "part:1:a"],
        ),
        ("cgt", "@LINE\n#EVAL(#V1=#V1+1)#V<|>1\n@\n", {}, ["main:2:V1", "main:2:V1", "main:2:V1"]),
        ("z32", "(P)\nN010 G1\n!GON1<|>0!\n", {}, ["main:2:010", "main:3:10"]),
        ("rs274", "#<<|>a>=1\nG1 X#<a> Y[ Z#<a>\n", {}, ["main:1:a", "main:2:a", "main:2:a"]),
        ("z32", "(P)\n!PAL[3]=1!\nX<PAL[<|>3]>\n", {}, ["main:2:3", "main:3:3"]),
    ],
)
def test_references(dialect: str, text: str, others: dict[str, str], found: list[str]) -> None:
    view, pos = at_cursor(dialect, text, **others)
    assert marked(view, references(view, pos)) == found


def test_references_without_definitions() -> None:
    view, pos = at_cursor("rs274", SUBS.replace("o<drill> sub", "o<<|>drill> sub"))
    assert marked(view, references(view, pos, definitions=False)) == ["main:4:drill", "main:5:drill"]


@pytest.mark.parametrize(
    ("dialect", "text", "found"),
    [
        ("rs274", "o1 <|>if [1]\no1 endif\n", [(0, None), (1, None)]),
        ("rs274", "#<<|>a>=1\nG1 X#<a>\n", [(0, True), (1, False)]),
        ("metagcode", "#IF1 |a| EqualTo 1 n\n#LOOP2 |b| 1 c\n#ENDLOOP2\n#END<|>IF1\n", [(0, None), (3, None)]),
        ("cgt", "@LINE\n<|><#MOV>\n@\n", [(1, None), (1, None)]),
    ],
)
def test_highlights(dialect: str, text: str, found: list[tuple[int, bool | None]]) -> None:
    view, pos = at_cursor(dialect, text)
    assert [(each.line, each.writes) for each in highlights(view, pos)] == found


@pytest.mark.parametrize(
    ("dialect", "text", "others", "name", "result"),
    [
        ("rs274", SUBS.replace("#<x>=1", "#<<|>x>=1"), {}, "depth", ["#<depth>=1", "X[#<depth>+#1]", "#<x>=5"]),
        (
            "rs274",
            SUBS.replace("o<drill> sub", "o<<|>drill> sub"),
            {},
            "peck",
            ["o<peck> sub", "o<peck> endsub", "o<peck> call"],
        ),
        ("rs274", "#3<|>1=1 (debug,#31)\n", {}, "32", ["#32=1 (debug,#32)"]),
        ("metagcode", "X|<|>a|\n#FILE part\n", {"Snippets__part": "Y|a|\n"}, "Depth", ["X|Depth|", "Y|Depth|"]),
        ("cgt", "@DECLARE\n#DEC #my<|>a\n@\n@LINE\nX#mya\n@\n", {}, "myb", ["#DEC #myb", "X#myb"]),
        ("cgt", "@LINE\n#CALL(SUB)\n@\n@S<|>UB\nX\n@\n", {}, "PART", ["#CALL(PART)", "@PART"]),
        ("z32", "(P)\nN1<|>0 G1\n!GON10!\n", {}, "20", ["N20 G1", "!GON20!"]),
        ("z32", "(P)\n!HA=2!\nX<H<|>A>\n", {}, "HB", ["!HB=2!", "X<HB>"]),
    ],
)
def test_rename(dialect: str, text: str, others: dict[str, str], name: str, result: list[str]) -> None:
    view, pos = at_cursor(dialect, text, **others)
    after = ""
    for change in renamed(view, pos, name):
        other = view.beside(change.file)
        assert other is not None
        after += other.document.edit(*sorted(change.edits, reverse=True)).text
    assert all(each in after for each in result), after


@pytest.mark.parametrize(
    ("dialect", "text", "name", "why"),
    [
        ("rs274", "G1 X<|>1\n", "Y", "nothing here"),
        ("rs274", "#54<|>20=1\n", "31", "no name of yours"),
        ("rs274", "#<_<|>x>=1\n", "_y", "no name of yours"),
        ("rs274", "#<<|>a>=1\n#<b>=2\n", "b", "already"),
        ("rs274", "#<<|>a>=1\n", "_a", "shared by all"),
        ("rs274", "#3<|>1=1\nG1 X##31\n", "32", "computed"),
        ("rs274", "o<|>1 if [1]\no1 endif\no2 if [1]\no2 endif\n", "2", "already"),
        ("metagcode", "X|<|>a|\n", "b|c", "is no name"),
        ("cgt", "@DECLARE\n#DEC #my\n@\n@LINE\nX#m<|>y\n@\n", "XPOS", "system word"),
        ("cgt", "@DECLARE\n#DEC #my,#ab\n@\n@LINE\nX#m<|>yb\n@\n", "a", "another way"),
        ("z32", "(P)\nN1<|>0 G1\n!GON<HA>!\n", "20", "computed"),
        ("z32", "(P)\nX<|>10\n", "Y", "machine"),
    ],
)
def test_a_rename_that_would_change_the_meaning_is_refused(dialect: str, text: str, name: str, why: str) -> None:
    view, pos = at_cursor(dialect, text)
    with pytest.raises(Cannot, match=why):
        renamed(view, pos, name)


def test_what_is_renamed_is_shown_first() -> None:
    view, pos = at_cursor("rs274", "#<de<|>ep>=1\n")
    assert prepared(view, pos) == ((2, 6), "deep")
    assert isinstance(view.document, Document)
