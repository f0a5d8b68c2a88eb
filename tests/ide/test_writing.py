"""What an editor offers while a program is written: completions, signatures, and what can be done about findings."""

from __future__ import annotations

import pytest

from deburr.analysis import Analysis
from deburr.ide.completion import MOST, completions, resolved
from deburr.ide.fixes import LOOKED_AT, quick_fixes
from deburr.ide.signature import signature
from deburr_grammar.dialects import by_name
from support.views import at_cursor

FILES = {
    "metagcode": {"Snippets__part": "", "Snippets__deep__more": "", "job_vars": "Width=3\nDepth=4\n"},
    "rs274": {"ext_ngc": "o<ext> sub\no<ext> endsub\n", "subs__far_ngc": ""},
    "cgt": {},
    "z32": {"cmos__7_z32": "G1\n:12\nG26\n", "cmos-temp__9_z32": "G26\n", "root__A__b_txt": "", "root__c_txt": ""},
}
SETTINGS: dict[str, dict[str, object]] = {
    "metagcode": {"variables": "job.vars"},
    "rs274": {"subroutine-path": ("/job/subs",)},
    "cgt": {},
    "z32": {"cmos-dir": "cmos", "file-root": "root", "pal": {"300": 5}},
}
SUBS = "o<drill> sub\n#<inner>=1\no<drill> endsub\n#<x>=1\n#<_g>=2\n"
TEMPLATE = "@DECLARE\n#DEC #depth\n@\n@SUB\nx\n@\n@LINE\n"
BLOCKS = "(P)\nN10 G1\n!HA=1!\n:5\nN20\n!PAL[3]=1!\n"


@pytest.mark.parametrize(
    ("dialect", "text", "first"),
    [
        ("rs274", "G1 X[SI<|>\n", ["SIN[", "SQRT["]),
        ("rs274", f"{SUBS}o<|>\n", ["o<drill>", "o<ext>", "o<far>"]),
        ("rs274", f"{SUBS}o<dr<|>\n", ["o<drill>", "o<ext>", "o<far>"]),
        ("rs274", "o7 while [1]\no<|>\n", ["o7 endwhile", "o<ext>"]),
        ("rs274", "o<a> do\no<|>\n", ["o<a> while ["]),
        ("rs274", f"{SUBS}o<drill> ca<|>\n", ["call", "continue"]),
        ("rs274", "G<|>\n", ["G0", "G1", "G2"]),
        ("rs274", "G1 G<|>\n", ["G4", "G5.3", "G7"]),
        ("rs274", "M3 M<|>\n", ["M0", "M1", "M2", "M6"]),
        ("rs274", f"{SUBS}G1 X#<<|>\n", ["#<_g>", "#<x>", "#<_a>"]),
        ("rs274", f"{SUBS}G1 X#<|>\n", ["#<_g>", "#<x>", "#<_a>"]),
        ("rs274", "o1 wh<|>\n", ["while"]),
        ("rs274", "o1 if [#1 <|>\n", ["MOD", "EQ", "NE", "GT"]),
        ("rs274", "(de<|>\n", ["DEBUG, "]),
        ("rs274", "(hello) ; <|>\n", []),
        ("metagcode", "#<|>\n", ["#FILE", "#IF", "#ENDIF", "#LOOP", "#ENDLOOP"]),
        ("metagcode", "#LOOP3 |a| 5 c\n#END<|>\n", ["#ENDLOOP3", "#FILE"]),
        ("metagcode", "#IF1 |a| <|>\n", ["greaterthan", "lessthan", "equalto", "notequalto"]),
        ("metagcode", "#IF1 <|>\n", ["|Width|", "|Depth|"]),
        ("metagcode", "#IF1 |a| equalto <|>\n", ["|a|", "|Width|", "|Depth|"]),
        ("metagcode", "#IF1 |a| equalto 1 <|>\n", ["alpha", "numeric"]),
        ("metagcode", "#LOOP1 |a| <|>\n", ["|a|", "|Width|", "|Depth|"]),
        ("metagcode", "#LOOP1 |a| 5 <|>\n", ["c", "r"]),
        ("metagcode", "#FILE <|>\n", ["part", "deep/more"]),
        ("metagcode", "X|a|\nY|<|>\n", ["|a|", "|Width|", "|Depth|"]),
        ("metagcode", "G1 X<|>\n", []),
        ("cgt", "@LINE\n#XP<|>\n@\n", ["#ABSI", "#ADIR", "#ARAD"]),
        ("cgt", f"{TEMPLATE}#<|>", ["#depth", "#ABSI"]),
        ("cgt", f"{TEMPLATE}@<|>", ["@ARC", "@CYCLCHG", "@DWELL", "@END"]),
        ("cgt", f"{TEMPLATE}#CALL(<|>\n@\n", ["DECLARE", "LINE", "SUB"]),
        ("cgt", f"{TEMPLATE}#TABLE(SUB,<|>\n@\n", ["#depth", "#ABSI"]),
        ("cgt", f"{TEMPLATE}#EVAL(<|>\n@\n", ["#depth", "#ABSI"]),
        ("cgt", f"{TEMPLATE}#FMT(<|>\n@\n", ["#F_BlockNumber", "#F_Decimal", "#F_Integer", "#F_Offset", "#depth"]),
        ("cgt", f"{TEMPLATE}#FMT(#F_Decimal,<|>\n@\n", ["D", "E", "F", "L", "P", "T", "Z"]),
        ("cgt", f"{TEMPLATE}#IF(#depth>1,#<|>\n@\n", ["#AND", "#OR"]),
        ("cgt", f"{TEMPLATE}#EVAL(#V1=S<|>\n@\n", ["SGN(", "SIN(", "SQR("]),
        ("z32", f"{BLOCKS}!GON<|>\n", ["10", "20"]),
        ("z32", f"{BLOCKS}!GON10-N<|>\n", ["10", "20"]),
        ("z32", f"{BLOCKS}!GOP<|>\n", ["5", "7", "12"]),
        ("z32", f"{BLOCKS}!GOS<|>\n", ["5", "9"]),
        ("z32", f"{BLOCKS}!:L254-<|>\n", ["A\\b", "c"]),
        ("z32", f"{BLOCKS}!:L254-A\\<|>\n", ["A\\b"]),
        ("z32", f"{BLOCKS}!<|>\n", ["IF", "EB", "CP", "PC", "GON", "GOP", "GOS", ":L254-", "HA", "PAL[3]", "PAL["]),
        ("z32", f"{BLOCKS}!HA=1; <|>\n", ["IF", "EB", "CP"]),
        ("z32", f"{BLOCKS}!IF HA>1; G<|>\n", ["GON", "GOP", "GOS"]),
        ("z32", f"{BLOCKS}X<PAL[<|>\n", ["PI", "PAL[3]", "PAL[", "PAR[", "P", "PAL[300]"]),
        ("z32", f"{BLOCKS}X<<|>\n", ["ABS(", "AT("]),
        ("z32", f"{BLOCKS}G<|>\n", ["G0", "G1", "G2", "G3", "G25", "G26"]),
        ("z32", f"{BLOCKS}G1 G<|>\n", ["G25", "G26"]),
    ],
)
def test_completions(dialect: str, text: str, first: list[str]) -> None:
    view, pos = at_cursor(dialect, text, SETTINGS[dialect], **FILES[dialect])
    found = [item.text for item in completions(view, pos)]
    assert found[: len(first)] == first
    assert first or not found


@pytest.mark.parametrize("dialect", FILES)
def test_every_name_of_a_table_is_explained(dialect: str) -> None:
    texts = {"rs274": "<|>\n", "metagcode": "#<|>\n", "cgt": "@LINE\n#<|>\n", "z32": "(P)\n!<|>\n"}
    view, pos = at_cursor(dialect, texts[dialect])
    found = [item for item in completions(view, pos) if item.table]
    assert found
    assert all(item.detail and resolved(by_name(dialect), item.table, item.name) for item in found)


def test_a_local_name_is_offered_where_it_means_something() -> None:
    text = "o<s> sub\n#<inner>=1\nG1 X#<{}>\no<s> endsub\n#<outer>=1\nG1 X{}\n"
    view, pos = at_cursor("rs274", text.format("inner", "#<|>"))
    names = {item.text for item in completions(view, pos)}
    assert "#<outer>" in names
    assert "#<inner>" not in names


def test_of_more_names_than_can_be_offered_those_that_go_on_as_is_written() -> None:
    labels = "".join(f"N{number} G1\n" for number in range(1, 3_000))
    view, pos = at_cursor("z32", f"(P)\n{labels}!GON<|>\n")
    assert [item.text for item in completions(view, pos)] == [str(number) for number in range(1, MOST + 1)]
    view, pos = at_cursor("z32", f"(P)\n{labels}!GON299<|>\n")
    found = [item.text for item in completions(view, pos)]
    assert found == ["299", *(f"299{digit}" for digit in range(10))]


def test_what_a_table_says_of_an_item() -> None:
    assert resolved(by_name("rs274"), "function", "SIN").startswith("`SIN[a]`\n\n")
    assert resolved(by_name("rs274"), "function", "NONE") == ""


@pytest.mark.parametrize(
    ("dialect", "text", "label", "item"),
    [
        ("rs274", "G1 X[ATAN[1<|>\n", "ATAN[y]/[x]", "y"),
        ("rs274", "o<drill> call [<|>\n", "o<drill> call [depth] [feed] [peck]", "depth"),
        ("rs274", "o<drill> call [1] [<|>\n", "o<drill> call [depth] [feed] [peck]", "feed"),
        ("rs274", "o<drill> call [1] [2] [SIN[<|>\n", "SIN[a]", "a"),
        ("rs274", "o<drill> call [1] [SIN[2]] [[3] + <|>\n", "o<drill> call [depth] [feed] [peck]", "peck"),
        ("rs274", "o<bare> call [1] [<|>\n", "o<bare> call [#1] [#2]", "#2"),
        ("rs274", "o<none> call [<|>\n", "o<name> call [a] [b] ...", "a"),
        ("rs274", "o1 if [#1 GT <|>\n", "o1 if [condition]", "condition"),
        ("cgt", "@LINE\n#EVAL(<|>\n@\n", "#EVAL(#word=expression)", "word"),
        ("cgt", "@LINE\n#EVAL(#V1=<|>\n@\n", "#EVAL(#word=expression)", "expression"),
        ("cgt", "@LINE\n#TABLE(TAB,<|>\n@\n", "#TABLE(section, row)", "row"),
        ("cgt", "@LINE\n#IF(#V1>1,#AND #V2=<|>\n@\n", "#IF(test)<then>#ELSE<else>", "test"),
        ("cgt", "@LINE\n#FMT(#F_Decimal,<|>\n@\n", "#FMT(#word,format)", "format"),
        ("cgt", "@LINE\n#EVAL(#V1=MAX(1,<|>\n@\n", "MAX(a, b)", "b"),
        ("cgt", "@LINE\n#EVAL(#V1=MAX(ABS(1),<|>\n@\n", "MAX(a, b)", "b"),
        ("metagcode", "#IF1 |a| Equ<|>\n", "#IFn value operator value type", "operator"),
        ("metagcode", "#IF1 |a| EqualTo <|>\n", "#IFn value operator value type", "value"),
        ("z32", "(P)\nX<SN(<|>\n", "SN(a)", "a"),
    ],
)
def test_signature(dialect: str, text: str, label: str, item: str) -> None:
    view, pos = at_cursor(dialect, text, drill_ngc=DRILL, bare_ngc="o<bare> sub\nX#2\no<bare> endsub\n")
    found = signature(view, pos)
    assert found is not None
    start, end = found.items[found.active]
    assert (found.label, found.label[start:end]) == (label, item)


DRILL = """(Drills a hole)
o<drill> sub (#1 = depth, #2: feed)
(in pecks)
#<peck> = #3 (not 0)
(no word of this)
G1 Z#1
o<drill> endsub
"""


def test_what_a_subprogram_says_of_itself_is_said_with_its_signature() -> None:
    view, pos = at_cursor("rs274", f"{DRILL}o<drill> call [<|>\n")
    found = signature(view, pos)
    assert found is not None
    assert found.text == "Drills a hole\n#1 = depth, #2: feed\nin pecks"


def test_no_signature_where_nothing_is_called() -> None:
    view, pos = at_cursor("rs274", "G1 X[1]<|>\n")
    assert signature(view, pos) is None


@pytest.mark.parametrize(
    ("dialect", "text", "titles"),
    [
        (
            "metagcode",
            "#IFF1 |a| EqualTo 1 n\n#ENDIF1\n",
            ["Change to `#IF1`", "Allow `metagcode.unknown-directive` here"],
        ),
        ("metagcode", "#IF1 |a| EqalTo 1 n\n#ENDIF1\n", ["Change to `equalto`", "Allow `metagcode.if-operator` here"]),
        ("z32", "(P)\nX<SINN(1)>\nM30\n", ["Change to `SN`", "Allow `z32.function-unknown` here"]),
        ("rs274", "G21 G90 G17\nG1 X1 F1 G1\nM2\n", ["Delete `G1`", "Allow `rs274.g-group` here"]),
        ("rs274", "G21 G90 G17\nG0 X1 G1 Y1 F1\nM2\n", ["Split the line before `G1`", "Allow `rs274.g-group` here"]),
        ("rs274", "G21 G90 G17\nM3 M4\nM2\n", ["Allow `rs274.m-group` here"]),
    ],
)
def test_actions(dialect: str, text: str, titles: list[str]) -> None:
    view, _ = at_cursor(dialect, text)
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    found = quick_fixes(view, findings)
    assert [each.title for each in found] == titles
    for each in found:
        after = Analysis(view.document.edit(*each.edits), view.ruleset, view.file, view.host).findings()
        assert each.finding.rule not in {finding.rule for finding in after}
        assert {finding.rule for finding in after} <= {finding.rule for finding in findings}


def test_a_second_rule_is_allowed_in_the_comment_that_is_there() -> None:
    view, _ = at_cursor("rs274", "G21 G90 G17 F1\nG1 X1 P3 Q1 (deburr: allow rs274.x)\nM2\n")
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    found = [each for each in quick_fixes(view, findings) if each.finding.place.line == 1]
    edits = [each.edits[0].text for each in found if each.title.startswith("Allow")]
    assert edits
    assert all(text.endswith(", ") for text in edits)


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_fixes_end_lines_as_the_program_does(ending: str) -> None:
    view, _ = at_cursor("rs274", ending.join(("G21 G90 G17", "M0 M30", "")))
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    (split,) = [each for each in quick_fixes(view, findings) if each.title == "Split the line here"]
    assert [edit.text for edit in split.edits] == [ending]


def test_of_very_many_findings_the_first_are_looked_at() -> None:
    view, _ = at_cursor("z32", "(P)\n" + "g0 X1\n" * 300 + "M30\n")
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    assert {each.finding.place.line for each in quick_fixes(view, findings)} == set(range(1, LOOKED_AT + 1))
