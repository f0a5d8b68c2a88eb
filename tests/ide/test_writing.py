"""What an editor offers while a program is written: completions, signatures, and what can be done about findings."""

from __future__ import annotations

import pytest

from deburr.analysis import Analysis
from deburr.ide.completion import completions, resolved
from deburr.ide.fixes import quick_fixes
from deburr.ide.signature import signature
from deburr_grammar.dialects import by_name
from support.views import at_cursor


@pytest.mark.parametrize(
    ("dialect", "text", "first"),
    [
        ("rs274", "G1 X[SI<|>\n", ["SIN[", "SQRT["]),
        ("rs274", "o<dr<|>\no<drill> sub\no<drill> endsub\n", ["o<drill>"]),
        ("rs274", "G<|>\n", ["G0", "G1", "G2"]),
        ("rs274", "#<a>=1\nG1 X#<|>\n", ["#<a>"]),
        ("rs274", "o1 wh<|>\n", ["while"]),
        ("metagcode", "#<|>\n", ["#FILE", "#IF", "#ENDIF", "#LOOP", "#ENDLOOP"]),
        ("metagcode", "#IF1 |a| <|>\n", ["greaterthan", "lessthan", "equalto", "notequalto", "|a|"]),
        ("metagcode", "#LOOP1 |a| 5 <|>\n", ["c", "r"]),
        ("metagcode", "#FILE <|>\n", ["part", "deep/more"]),
        ("metagcode", "X|a|\nY|<|>\n", ["|a|"]),
        ("cgt", "@LINE\n#XP<|>\n@\n", ["#ABSI", "#ADIR", "#ARAD"]),
        ("cgt", "@LINE\n#CALL(<|>\n@\n@SUB\nx\n@\n", ["LINE", "SUB"]),
        ("cgt", "@LINE\n#EVAL(#V1=S<|>\n@\n", ["SGN(", "SIN(", "SQR("]),
        ("z32", "(P)\nN10 G1\n!GON<|>\n!GON10!\n", ["N10"]),
        ("z32", "(P)\n!HC=1!\nX<<|>\n", ["ABS("]),
        ("z32", "(P)\n!<|>\n", ["IF", "EB", "CP"]),
    ],
)
def test_completions(dialect: str, text: str, first: list[str]) -> None:
    view, pos = at_cursor(
        dialect, text, **({"Snippets__part": "", "Snippets__deep__more": ""} if dialect == "metagcode" else {})
    )
    assert [item.text for item in completions(view, pos)][: len(first)] == first


def test_a_local_name_is_offered_where_it_means_something() -> None:
    text = "o<s> sub\n#<inner>=1\nG1 X#<{}>\no<s> endsub\n#<outer>=1\nG1 X{}\n"
    view, pos = at_cursor("rs274", text.format("inner", "#<|>"))
    names = {item.text for item in completions(view, pos)}
    assert "#<outer>" in names
    assert "#<inner>" not in names


def test_what_a_table_says_of_an_item() -> None:
    assert resolved(by_name("rs274"), "function", "SIN").startswith("`SIN[a]`\n\n")
    assert resolved(by_name("rs274"), "function", "NONE") == ""


@pytest.mark.parametrize(
    ("dialect", "text", "label", "item"),
    [
        ("rs274", "G1 X[ATAN[1<|>\n", "ATAN[y]/[x]", "y"),
        ("cgt", "@LINE\n#EVAL(#V1=MAX(1,<|>\n@\n", "MAX(a, b)", "b"),
        ("cgt", "@LINE\n#EVAL(#V1=MAX(ABS(1),<|>\n@\n", "MAX(a, b)", "b"),
        ("metagcode", "#IF1 |a| Equ<|>\n", "#IFn value operator value type", "operator"),
        ("metagcode", "#IF1 |a| EqualTo <|>\n", "#IFn value operator value type", "value"),
        ("z32", "(P)\nX<SN(<|>\n", "SN(a)", "a"),
    ],
)
def test_signature(dialect: str, text: str, label: str, item: str) -> None:
    view, pos = at_cursor(dialect, text)
    found = signature(view, pos)
    assert found is not None
    start, end = found.items[found.active]
    assert (found.label, found.label[start:end]) == (label, item)


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
