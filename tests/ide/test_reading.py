"""What an editor shows of a program as it stands: hover, outline, folds, growing selections, colours."""

from __future__ import annotations

from itertools import pairwise

import pytest

from deburr.analysis import Analysis
from deburr.ide.folding import folds
from deburr.ide.hover import hover
from deburr.ide.outline import Part, outline
from deburr.ide.selection import selections
from deburr.ide.tokens import coloured
from deburr_grammar.dialects import NAMES
from support.hovers import Hovered, hovers
from support.views import at_cursor

RS274 = "o<drill> sub\n#<deep>=1\no1 if [#1 GT 2]\nG1 X[#<de<|>ep>+SIN[#1]] (c)\no1 endif\no<drill> endsub\no<drill> call [1]\n(a)\n(b)\n(c)\nM2\n"
METAGCODE = "#LOOP1 |Depth| 5 c\nZ|De<|>pth|\n#IF2 |a| EqualTo 1 n\n#ENDIF2\n#ENDLOOP1\n"
CGT = "@DECLARE\n#DEC #depth\n@\n@LINE\n<#MOV>< X#X<|>POS>#CALL(SUB)\n@\n@SUB\nX\n@\n"
Z32 = "(P)\nN10 G1 X<SN(H<|>A)>\n!GON10!\n:5\nM30\n"


def named(case: Hovered) -> object:
    return pytest.param(case, id=f"{case.dialect}-{case.title}")


@pytest.mark.parametrize("case", [named(case) for dialect in NAMES for case in hovers(dialect)])
def test_hover(case: Hovered) -> None:
    view, pos = at_cursor(case.dialect, case.program, case.settings, beside=case.files)
    found = hover(view, pos)
    assert found is not None
    assert found.text == case.said


def test_nothing_is_said_of_nothing() -> None:
    view, pos = at_cursor("rs274", "G1 X1 (comm<|>ent)\n")
    assert hover(view, pos) is None


@pytest.mark.parametrize(
    ("dialect", "text", "said"),
    [
        ("rs274", "#<a>=1\nG1 X#<<|>a> Y[ Z#<a> F#2\n", "**`#<a>`**"),
        ("rs274", "#<a>=1\nG1 X#<a> Y[ Z#<<|>a> F#2\n", "**`#<a>`**"),
        ("rs274", "#<a>=1\nG1 X#<a> Y[ Z#<a> F#<|>2\n", "**`#2`**"),
        ("rs274", "G1 ?? X1 G9<|>1\n", "**`G91`**"),
        ("metagcode", "X|<|>a| Y|b\n", "**`|a|`**"),
        ("metagcode", "#LOOP1 |a| x |<|>b|\n", "**`|b|`**"),
        ("cgt", "@LINE\n#IF(#V1>3) #V2 #XP<|>OS\n@\n", "**`#XPOS`**"),
        ("cgt", "@LINE\n#IF(#V<|>1>3) #V2 #XPOS\n@\n", "**`#V1`**"),
        ("z32", "(P)\nX<HA+> Y<H<|>B> Z<HC>\n", "**`HB`**"),
        ("z32", "(P)\n!HA=1; FOO; HB=H<|>C!\n", "**`HC`**"),
    ],
)
def test_names_before_and_behind_a_fault_are_known(dialect: str, text: str, said: str) -> None:
    view, pos = at_cursor(dialect, text)
    assert Analysis(view.document, view.ruleset, view.file, view.host).line_findings(pos.line)
    found = hover(view, pos)
    assert found is not None and found.text.startswith(said)
    line = view.document.line(pos.line)
    assert line[found.span.start : found.span.end] == said.strip("*`") and found.span.start <= pos.col <= found.span.end


def tree(parts: list[Part]) -> list[object]:
    return [(part.name, part.sort.value, part.first, part.last, tree(part.parts)) for part in parts]


@pytest.mark.parametrize(
    ("dialect", "text", "found"),
    [
        ("rs274", RS274, [("drill", "subprogram", 0, 5, [("if 1", "label", 2, 4, [])])]),
        ("metagcode", METAGCODE, [("#LOOP 1", "label", 0, 4, [("#IF 2", "label", 2, 3, [])])]),
        (
            "cgt",
            CGT,
            [
                ("DECLARE", "section", 0, 2, [("#depth", "variable", 1, 1, [])]),
                ("LINE", "section", 3, 5, []),
                ("SUB", "section", 6, 8, []),
            ],
        ),
        ("z32", Z32, [("N10", "label", 1, 1, []), (":5", "section", 3, 5, [])]),
    ],
)
def test_outline(dialect: str, text: str, found: list[object]) -> None:
    view, _ = at_cursor(dialect, text)
    assert tree(outline(view)) == found


@pytest.mark.parametrize(
    ("dialect", "text", "found"),
    [
        ("rs274", RS274, [(0, 5, False), (2, 4, False), (7, 9, True)]),
        ("metagcode", METAGCODE, [(0, 4, False), (2, 3, False)]),
        ("cgt", CGT, [(0, 2, False), (3, 5, False), (6, 8, False)]),
        ("z32", "(a)\n" * 40 + "G1\n(b)\n(c)\nG2\n(d)\n(e)\n(f)", [(0, 39, True), (44, 46, True)]),
        ("rs274", "o1 if [1]\nG1\n", []),
    ],
)
def test_folds(dialect: str, text: str, found: list[tuple[int, int, bool]]) -> None:
    view, _ = at_cursor(dialect, text)
    assert [tuple(each) for each in folds(view)] == found


@pytest.mark.parametrize(
    ("dialect", "text", "found"),
    [
        (
            "rs274",
            RS274,
            [
                "<deep>",
                "#<deep>",
                "#<deep>+SIN[#1]",
                "[#<deep>+SIN[#1]]",
                "X[#<deep>+SIN[#1]]",
                "G1 X[#<deep>+SIN[#1]] (c)",
            ],
        ),
        ("z32", Z32, ["HA", "SN(HA)", "<SN(HA)>", "X<SN(HA)>", "N10 G1 X<SN(HA)>"]),
    ],
)
def test_selections(dialect: str, text: str, found: list[str]) -> None:
    view, pos = at_cursor(dialect, text)
    places = selections(view, pos)
    line = view.document.line(pos.line)
    assert [line[each.col : each.end_col] for each in places if each.line == each.end_line] == found
    assert (places[-1].line, places[-1].end_line) == (0, view.document.line_count - 1)
    for inner, outer in pairwise(places):
        assert outer[1:3] <= inner[1:3] and inner[3:] <= outer[3:] and inner != outer


@pytest.mark.parametrize(
    ("dialect", "text", "line", "found"),
    [
        ("rs274", RS274, 3, "G1:macro X:property #<deep>:variable SIN:method #1:variable (c):comment"),
        ("rs274", RS274, 0, "o<drill>:function.declaration sub:keyword"),
        ("metagcode", METAGCODE, 0, "#LOOP:keyword |Depth|:variable.modification 5:number c:keyword"),
        ("cgt", CGT, 4, "#MOV:property #XPOS:property #CALL:keyword SUB:namespace"),
        ("z32", Z32, 1, "N10:label.declaration G1:macro X:variable.modification SN:method HA:variable"),
    ],
)
def test_colours(dialect: str, text: str, line: int, found: str) -> None:
    view, _ = at_cursor(dialect, text)
    said = view.document.line(line)
    tokens = [
        f"{said[each.start : each.end]}:{each.type}{'.' if each.modifier else ''}{each.modifier}"
        for each in coloured(view, line, line)
    ]
    assert " ".join(tokens) == found
