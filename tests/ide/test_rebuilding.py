"""Programs rebuilt: other numbers, constants in place of names, lines as a part of their own, all safe fixes. Each case was worked out by hand."""

from __future__ import annotations

import pytest

from deburr.analysis import Analysis
from deburr.fix import applied
from deburr.ide.create import missing_file
from deburr.ide.refactor import Cannot, NewFile
from deburr.ide.refactorings import Rebuilt, offers, rebuilt
from deburr.ide.view import View
from deburr_grammar.text import Pos
from support.views import CURSOR, at_cursor


def made(dialect: str, name: str, text: str, **others: str) -> tuple[View, Rebuilt]:
    """What is made of a program; of two cursors the second ends the selection."""
    places = _places(text)
    view, _ = at_cursor(dialect, text.replace(CURSOR, "", 2), **others)
    first = places[0] if places else Pos(0, 0)
    return view, rebuilt(view, name, first, places[-1] if places else first)


def _places(text: str) -> list[Pos]:
    """Where the cursors of a text stand."""
    found: list[Pos] = []
    while CURSOR in text:
        before, _, after = text.partition(CURSOR)
        lines = before.split("\n")
        found.append(Pos(len(lines) - 1, len(lines[-1])))
        text = before + after
    return found


def check(dialect: str, name: str, text: str, expected: str, **others: str) -> None:
    """It makes exactly this text, and nothing more when it is done again."""
    view, found = made(dialect, name, text, **others)
    after = applied(view.document, found.edits)
    assert after.text == expected


def refused(dialect: str, name: str, text: str, why: str, **others: str) -> None:
    """It is not done, and the message says why."""
    with pytest.raises(Cannot, match=why):
        made(dialect, name, text, **others)


Z32_LOOP = "(P)\nN5 G0 X1\n!HA=0!\nN7 !HA=HA+1!\nN20 G0 Z5\nG1 X<HA> F200\n!IF HA<3; GON7!\nN30 G0\n!GON7-N20!\nM30\n"
Z32_LOOP_RENUMBERED = (
    "(P)\nN10 G0 X1\n!HA=0!\nN20 !HA=HA+1!\nN30 G0 Z5\nG1 X<HA> F200\n!IF HA<3; GON20!\nN40 G0\n!GON20-N30!\nM30\n"
)


def test_lines_are_renumbered_and_jumps_and_ranges_follow() -> None:
    check("z32", "renumber-lines", Z32_LOOP, Z32_LOOP_RENUMBERED)
    check("z32", "renumber-lines", Z32_LOOP_RENUMBERED, Z32_LOOP_RENUMBERED)


def test_a_jump_stays_in_its_section() -> None:
    check(
        "z32",
        "renumber-lines",
        "(P)\nN7 G0 X2\n!IF X>9; GON7!\n!GOP5!\nM30\n:5\nN7 G0 X3\n!IF X<1; GON7!\nG26\n",
        "(P)\nN10 G0 X2\n!IF X>9; GON10!\n!GOP5!\nM30\n:5\nN20 G0 X3\n!IF X<1; GON20!\nG26\n",
    )


def test_block_numbers_with_decimals_and_zeros_are_numbers() -> None:
    check(
        "z32",
        "renumber-lines",
        "(P)\nG0 X0\nN150.50 X1\n!IF X>5; GON0150.5!\nM30\n",
        "(P)\nG0 X0\nN10 X1\n!IF X>5; GON10!\nM30\n",
    )


def test_line_numbers_mean_nothing_where_nothing_jumps_to_them() -> None:
    check(
        "rs274",
        "renumber-lines",
        "G21 G90 G17\nN5 G0 X1 (N5)\n/N5 G0 X2\nn 7 o1 if [1]\no1 endif\nM2\nN3 never read\n",
        "G21 G90 G17\nN10 G0 X1 (N5)\n/N20 G0 X2\nn 30 o1 if [1]\no1 endif\nM2\nN3 never read\n",
    )


def test_steps_are_smaller_where_there_are_many_lines() -> None:
    count = 12_000
    view, found = made("rs274", "renumber-lines", "G21 G90 G17\n" + "N1 G0 X1\n" * count + "M2\n")
    after = applied(view.document, found.edits)
    assert len(found.edits) == 1, "so many are one edit"
    assert [after.line(at) for at in (1, 2, count)] == ["N10 G0 X1", "N15 G0 X1", "N60005 G0 X1"]


@pytest.mark.parametrize(
    ("dialect", "text", "why"),
    [
        ("z32", "(P)\nN5 G0 X1\nN7 G0 X2\n!GON<HA>!\nM30\n", "line 4 goes to a number that is computed"),
        (
            "z32",
            "(P)\nG0\nN7 G0 X2\nN7 G0 X3\n!IF X>5; GON7!\nM30\n",
            "N7 of the jump in line 5 is there more than once",
        ),
        ("z32", "(P)\nN7 G0 X2\n!IF X>5; GON8!\nM30\n", "N8 of the jump in line 3 is not there"),
        ("metagcode", "N10 G0\n", "lines have no numbers"),
        ("cgt", "@START\nN10\n@\n", "lines have no numbers"),
    ],
)
def test_lines_are_not_renumbered_where_it_is_not_clear_what_follows(dialect: str, text: str, why: str) -> None:
    refused(dialect, "renumber-lines", text, why)


def test_blocks_are_renumbered_in_their_order() -> None:
    check(
        "rs274",
        "renumber-blocks",
        "G21 G90 G17\no5 sub\n#1=1\no7 if [#1]\no7 else\no7 endif\no5 endsub\no5 call\no9 repeat [2]\no9 endrepeat\no<x> call\nM2\n",
        "G21 G90 G17\no100 sub\n#1=1\no110 if [#1]\no110 else\no110 endif\no100 endsub\no100 call\no120 repeat [2]\no120 endrepeat\no<x> call\nM2\n",
        x_ngc="o<x> sub\no5 if [1]\no5 endif\no<x> endsub\nM2\n",
    )
    check(
        "metagcode",
        "renumber-blocks",
        "#IF7 1 equalto 1 n\n#LOOP9 |a| 2 c\nX|a| #IF7\n#ENDLOOP9\n#ENDIF7\n#if7 1 equalto 2 n\n#endif7\n",
        "#IF1 1 equalto 1 n\n#LOOP2 |a| 2 c\nX|a| #IF7\n#ENDLOOP2\n#ENDIF1\n#if1 1 equalto 2 n\n#endif1\n",
    )


def test_a_number_that_is_a_file_s_is_left_alone() -> None:
    check(
        "rs274",
        "renumber-blocks",
        "G21 G90 G17\no1 if [1]\n  o100 call\no1 endif\nM2\n",
        "G21 G90 G17\no110 if [1]\n  o100 call\no110 endif\nM2\n",
        _100_ngc="o100 sub\no100 endsub\nM2\n",
    )


@pytest.mark.parametrize(
    ("dialect", "text", "why"),
    [
        ("rs274", "G21 G90 G17\no5 sub\no5 endsub\nM98 P5\nM2\n", "cannot be followed"),
        ("rs274", "G21 G90 G17\n#1=5\no5 sub\no5 endsub\no#1 call\nM2\n", "cannot be followed"),
        ("z32", "(P)\nG0 X1\nM30\n", "blocks have no numbers"),
    ],
)
def test_blocks_are_not_renumbered_where_numbers_are_computed(dialect: str, text: str, why: str) -> None:
    refused(dialect, "renumber-blocks", text, why)


def test_a_subprogram_that_another_file_calls_keeps_its_number() -> None:
    refused(
        "rs274",
        "renumber-blocks",
        "o5 sub\no5 endsub\nG21 G90 G17\no<x> call\nM2\n",
        "x.ngc as well",
        x_ngc="o<x> sub\no5 call\no<x> endsub\nM2\n",
    )


@pytest.mark.parametrize("place", ["#<de<|>pth>=-5", "G1 Z#<de<|>pth> F100"])
def test_a_constant_goes_where_it_is_used(place: str) -> None:
    lines = ["#<depth>=-5", "G1 Z#<depth> F100", "G1 Z[#<depth>*2] X[#<depth>]", "o<s> call [#<depth>]", "#2=#<depth>"]
    text = "\n".join(place if line == place.replace(CURSOR, "") else line for line in lines)
    check(
        "rs274",
        "inline",
        f"o<s> sub\no<s> endsub\nG21 G90 G17\n{text}\nM2\n",
        "o<s> sub\no<s> endsub\nG21 G90 G17\nG1 Z-5 F100\nG1 Z[[-5]*2] X[-5]\no<s> call [-5]\n#2=-5\nM2\n",
    )


def test_a_number_that_may_be_kept_in_a_file_stays_set() -> None:
    check(
        "rs274",
        "inline",
        "G21 G90 G17\n#10<|>1=2.5\nG0 X#101\nM2\n",
        "G21 G90 G17\n#101=2.5\nG0 X2.5\nM2\n",
    )


def test_a_user_parameter_goes_where_it_is_used() -> None:
    check(
        "z32",
        "inline",
        "(P)\n!HA=-5!\nG1 X<HA> F100\nG1 X<3*H<|>A>\nM30\n",
        "(P)\nG1 X<(-5)> F100\nG1 X<3*(-5)>\nM30\n",
    )
    check("z32", "inline", "(P)\nH<|>A2,5\nG1 X<HA> F100\nM30\n", "(P)\nG1 X<2.5> F100\nM30\n")


@pytest.mark.parametrize(
    ("dialect", "text", "why"),
    [
        ("rs274", "G21 G90 G17\n#<|>1=2\n#1=3\nG0 X#1\nM2\n", "set in 2 places"),
        ("rs274", "G21 G90 G17\nG0 X#<|>77\nM2\n", "it is not set"),
        ("rs274", "G21 G90 G17\n#<|>1=2\nM2\n", "nothing uses it"),
        ("rs274", "G21 G90 G17\n#<|>1=[2+1]\nG0 X#1\nM2\n", "not set to a number"),
        ("rs274", "G21 G90 G17\n/#<|>1=2\nG0 X#1\nM2\n", "not set to a number"),
        ("rs274", "G21 G90 G17\n#<|>101=2\n#2=101\nG0 X#101 Y##2\nM2\n", "computed somewhere"),
        ("rs274", "G21 G90 G17\no1 if [1]\n#<|>1=2\no1 endif\nG0 X#1\nM2\n", "set in a block"),
        ("rs274", "G21 G90 G17\nG0 X#1\n#<|>1=2\nG0 X#1\nM2\n", "used before it is set"),
        ("rs274", "G21 G90 G17\n#<|>1=2\n(DEBUG,#1)\nG0 X#1\nM2\n", "a comment shows its value"),
        ("rs274", "G21 G90 G17\n#<|>5220=2\nG0 X#5220\nM2\n", "the machine knows it"),
        ("rs274", "G21 G90 G17\nG0 <|>X1\nM2\n", "nothing here is a variable"),
        ("z32", "(P)\n!IF X>1; GON9!\n!H<|>A=5!\nN9 G0\nG1 X<HA> F100\nM30\n", "jumps may pass"),
        ("z32", "(P)\n!IF X>1; H<|>A=5!\nG1 X<HA> F100\nM30\n", "not set to a number"),
        ("metagcode", "X|<|>a|\n", "it is not set"),
        ("cgt", "@START\n#EVAL(#V<|>1=5)\n#V1\n@\n", "printed in its format"),
        ("cgt", "@START\n#EVAL(#V<|>1=5)\n#FMT(#V1,D3.4)\n@\n", "printed in its format"),
        ("cgt", "@START\n#EVAL(#V<|>1=5+1)\n#EVAL(#V2=#V1)\n@\n", "not set to a number"),
        ("cgt", "@START\n<#SPEED#EVAL(#V<|>1=5)>\n#EVAL(#V2=#V1)\n@\n", "5 is not proven of it"),
        ("cgt", "@LINE\n#EVAL(#V<|>1=5)\n@\n@RAP\n#EVAL(#V2=#V1)\n@\n", "5 is not proven of it"),
    ],
)
def test_what_is_no_constant_is_left_alone(dialect: str, text: str, why: str) -> None:
    refused(dialect, "inline", text, why)


VALUES = {"variables": "part.vars"}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("X|De<|>pth| (|Depth|) Z|n|\n", "X15 (15) Z|n|\n"),
        ("#IF1 |De<|>pth| greaterthan 3 n\nM8\n#ENDIF1\n", "#IF1 15 greaterthan 3 n\nM8\n#ENDIF1\n"),
        ("#LOOP1 |n| |De<|>pth| c\nZ|n|\n#ENDLOOP1\n", "#LOOP1 |n| 15 c\nZ|n|\n#ENDLOOP1\n"),
        ("(|M<|>at|)\n", "(Mild Steel)\n"),
    ],
)
def test_a_configured_value_in_the_place_of_its_name(before: str, after: str) -> None:
    view, pos = at_cursor("metagcode", before, VALUES, part_vars="Depth=15\nn=2\nMat=Mild Steel\n")
    assert applied(view.document, rebuilt(view, "inline", pos, pos).edits).text == after


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("#IF1 |M<|>at| equalto Steel a\n#ENDIF1\n", "no single word"),
        ("Z|n|\n#LOOP1 |n<|>| 1 c\nZ|n|\n#ENDLOOP1\n", "a loop counts it in line 2"),
        ("Z|q<|>|\n", "it is not set"),
    ],
)
def test_a_configured_value_that_cannot_stand_there(text: str, why: str) -> None:
    view, pos = at_cursor("metagcode", text, VALUES, part_vars="n=2\nMat=Mild Steel\n")
    with pytest.raises(Cannot, match=why):
        rebuilt(view, "inline", pos, pos)


def test_a_word_that_is_only_computed_with_is_a_constant_if_that_is_proven() -> None:
    start = "@START\n#EVAL(#a=-2.5)\n#EVAL(#b=1)\n@\n@LINE\nX#XPOS\n#EVAL(#V2=#<|>a*2)\n"
    more = "#IF(#b>#a)<Y#YPOS>\n#REPEAT(#b)<Z#ZPOS>\n@\n"
    rest = more.replace("#b>#a", "#b>(-2.5)")
    without = "@START\n#EVAL(#b=1)\n@\n@LINE\nX#XPOS\n#EVAL(#V2=(-2.5)*2)\n"
    check("cgt", "inline", f"@DECLARE\n#DEC #a,#b\n@\n{start}{more}", f"@DECLARE\n#DEC #b\n@\n{without}{rest}")
    check("cgt", "inline", f"@DECLARE\n#DEC #b, #a\n@\n{start}{more}", f"@DECLARE\n#DEC #b\n@\n{without}{rest}")
    alone = f"@DECLARE\n#DEC #a\n#DEC #b\n@\n{start}{more}"
    check("cgt", "inline", alone, f"@DECLARE\n#DEC #b\n@\n{without}{rest}")


def test_a_shared_name_that_another_file_uses_is_left_alone() -> None:
    refused(
        "rs274",
        "inline",
        "G21 G90 G17\n#<|><_a>=2\no<s> call\nG0 X#<_a>\nM2\n",
        "s.ngc uses it as well",
        s_ngc="o<s> sub\nG0 Y#<_a>\no<s> endsub\nM2\n",
    )


RS274_HEAD = "G21 G90 G17 F100\n#<a>=5\n#1=2\n"


def test_lines_become_a_subprogram_before_the_outermost_block() -> None:
    check(
        "rs274",
        "extract",
        f"{RS274_HEAD}o1 repeat [2]\n<|>  G1 X#<a>\n  G1 Y#1\n<|>o1 endrepeat\nM2\n",
        f"{RS274_HEAD}o<part> sub\n#<a>=#2\n  G1 X#<a>\n  G1 Y#1\no<part> endsub\n"
        "o1 repeat [2]\n  o<part> call [#1] [#<a>]\no1 endrepeat\nM2\n",
    )


def test_what_lines_set_for_themselves_is_no_argument() -> None:
    check(
        "rs274",
        "extract",
        "G21 G90 G17 F100\n<|>#<x>=3\nG1 X#<x> Y#<_g>\n<|>G1 Y1\nM2\n".replace(" Y#<_g>", ""),
        "G21 G90 G17 F100\no<part> sub\n#<x>=3\nG1 X#<x>\no<part> endsub\no<part> call\nG1 Y1\nM2\n",
    )


def test_a_part_of_a_subprogram_goes_before_it() -> None:
    check(
        "rs274",
        "extract",
        "o<s> sub\n<|>G0 X#1\n<|>o<s> endsub\nG21 G90 G17\no<s> call [1]\nM2\n",
        "o<part> sub\nG0 X#1\no<part> endsub\no<s> sub\no<part> call [#1]\no<s> endsub\nG21 G90 G17\no<s> call [1]\nM2\n",
    )


def test_names_that_are_there_are_left_alone() -> None:
    view, found = made("rs274", "extract", "o<part> sub\no<part> endsub\nG21 G90 G17\n<|>G0 X1\n<|>o<part> call\nM2\n")
    assert "o<part2> call\n" in applied(view.document, found.edits).text


def test_lines_become_a_snippet() -> None:
    view, found = made(
        "metagcode",
        "extract",
        "G0 X1\n<|>#IF1 1 equalto 1 n\nG1 X2\n#ENDIF1<|>\nG0 X3\n",
        Snippets__part_txt="X",
    )
    assert applied(view.document, found.edits).text == "G0 X1\n#FILE part2.txt\nG0 X3\n"
    assert found.file == NewFile("/job/Snippets/part2.txt", "#IF1 1 equalto 1 n\nG1 X2\n#ENDIF1\n")


CGT = "@START\n%\n@\n@TOOLCHG\nT#TOOL M06\n@\n@RAP\n<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>\n@\n@ARC\n<#MOV>< X#XPOS>< Y#YPOS>\n@\n@END\nM30\n@\n"


def test_lines_become_a_section() -> None:
    check(
        "cgt",
        "extract",
        f"{CGT}@LINE\n<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>\n<|>M8\nM9\n<|>@\n",
        f"{CGT}@LINE\n<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>\n#CALL(part)\n@\n@part\nM8\nM9\n@\n",
    )


def test_blocks_become_a_range_behind_the_end_of_their_program() -> None:
    check(
        "z32",
        "extract",
        "(P)\nN15 G0 X1 F100\n  <|>G1 X2\n  G1 Y2\n<|>G0 Z5\nM30\n",
        "(P)\nN15 G0 X1 F100\n  !GON20-N30!\nG0 Z5\nM30\nN20\n  G1 X2\n  G1 Y2\nN30\n",
    )


def test_a_range_stays_in_the_section_of_its_blocks() -> None:
    check(
        "z32",
        "extract",
        "(P)\n!GOP5!\nM30\n:5\n<|>G0 X1\n<|>G26\n:6\nG26\n",
        "(P)\n!GOP5!\nM30\n:5\n!GON10-N20!\nG26\nN10\nG0 X1\nN20\n:6\nG26\n",
    )


@pytest.mark.parametrize(
    ("dialect", "text", "why"),
    [
        ("rs274", f"{RS274_HEAD}<|>o1 repeat [2]\nG1 X#<a>\n<|>o1 endrepeat\nM2\n", "only a part of a block"),
        ("rs274", "G21 G90 G17\n#1=1\no1 if [#1]\n<|>G0 X1\no1 else\n<|>o1 endif\nM2\n", "only a part of a block"),
        ("rs274", "G21 G90 G17\n<|>#<a>=5\n<|>G0 X#<a>\nM2\n", "used elsewhere: `a`"),
        ("rs274", "G21 G90 G17\n#1=1\n<|>G0 X##1\n<|>M2\n", "a parameter is computed"),
        ("rs274", "G21 G90 G17\n#<a>=1\n<|>#<_b>=EXISTS[#<a>]\n<|>M2\n", "EXISTS"),
        ("rs274", "G21 G90 G17\n<|>G0 X1\nM2\n<|>", "ends more than these lines"),
        ("rs274", "o<s> sub\n<|>G0 X1\no<s> return\n<|>o<s> endsub\nG21 G90 G17\no<s> call\nM2\n", "only a part"),
        ("rs274", "G21 G90 G17\n<|>M70\nG91\n<|>M72\nM2\n", "ends more than these lines"),
        ("rs274", "G21 G90 G17\nM2\n<|>G0 X1\n<|>", "never read"),
        ("rs274", "G21 G90 G17\n<|>\n<|>M2\n", "there is nothing"),
        ("metagcode", "<|>#IF1 1 equalto 1 n\n<|>#ENDIF1\n", "only a part of a block"),
        ("z32", "(P)\n<|>G0 X1\n<|>G0 X2\n", "does not end in M2"),
        ("z32", "(P)\n<|>G0 X1\n<|>!IF X>1; M30!\nM3\n", "does not end in M2"),
        ("z32", "(P)\n<|>G0 X1\nM30\n<|>", "end the program"),
        ("z32", "(P)\n!GOP5!\n<|>M30\n:5\n<|>G26\n", "end the program"),
        ("z32", "TITLE\n<|>MORE\n<|>%\nG0 X1\nM30\n", "never read"),
        ("z32", "(P)\n<|>!IF X>1; GON9!\nG0 X1\n<|>N9 G0 X2\nM30\n", "leads out of the lines or into"),
        ("z32", "(P)\n<|>N9 G0 X1\n<|>!IF X<1; GON9!\nM30\n", "leads out of the lines or into"),
        ("z32", "(P)\n<|>G0 X1\n<|>!GON<HA>!\nM30\n", "computed"),
        ("z32", "(P)\n<|>G0 X1\n<|>N999999990\nM30\n", "no higher number"),
        ("cgt", "@LINE\n<|>#EXIT\n<|>@\n", "would leave the new section"),
        ("cgt", "@LINE\n<|>M8\n@\n<|>@RAP\n@\n", "not whole lines of one section"),
    ],
)
def test_lines_stay_where_a_part_of_them_would_mean_something_else(dialect: str, text: str, why: str) -> None:
    refused(dialect, "extract", text, why)


def test_what_is_unknown_is_not_done() -> None:
    refused("rs274", "sing", "M2\n", "`sing` is nothing that can be done")


@pytest.mark.parametrize(
    ("dialect", "text", "titles"),
    [
        ("rs274", "N10 G0 X#<|>1\n", ["Renumber all lines", "Put the value of `#1` in its place"]),
        ("rs274", "o<|>5 if [1]\n", ["Renumber all blocks"]),
        ("rs274", "o<|><a> call\n", []),
        ("rs274", "<|>G0 X1\n<|>", ["Extract to a subprogram"]),
        ("z32", "N1<|>0 !GON20!\n", ["Renumber all lines"]),
        ("z32", "<|>G0 X1\n<|>", ["Extract to a range of blocks"]),
        ("metagcode", "#IF<|>1 |a| equalto 1 n\n", ["Renumber all blocks"]),
        ("metagcode", "<|>G0\nG1<|>\n", ["Extract to a snippet"]),
        ("cgt", "@LINE\n<|>M8\n<|>@\n", ["Extract to a section"]),
    ],
)
def test_what_is_offered_is_seen_from_the_line(dialect: str, text: str, titles: list[str]) -> None:
    places = _places(text)
    view, _ = at_cursor(dialect, text.replace(CURSOR, ""))
    assert [each.title for each in offers(view, places[0], places[-1])] == titles


@pytest.mark.parametrize(
    ("dialect", "before", "after"),
    [
        ("z32", "(P)\ng0 x1 y<ha+1>\n!;HA=2;;HB=3!\nM30\n", "(P)\nG0 X1 Y<HA+1>\n!HA=2;HB=3!\nM30\n"),
        ("rs274", "G21 G90 G17\n#1=[0 AND 1 + 1]\nM2\n", "G21 G90 G17\n#1=[0 AND [1 + 1]]\nM2\n"),
        ("rs274", "G21\r\n(deburr: allow rs274.limit)\r\nM2\r\n", "G21\r\nM2\r\n"),
        ("metagcode", "#IF1 1 equalto 1 never\n#ENDIF1\n", "#IF1 1 equalto 1 n\n#ENDIF1\n"),
        ("rs274", "G21 G90 G17\nG0 X1 G1 Y2 F1\nM2\n", "G21 G90 G17\nG0 X1 G1 Y2 F1\nM2\n"),
    ],
)
def test_all_safe_fixes_are_made_until_there_are_none(dialect: str, before: str, after: str) -> None:
    view, _ = at_cursor(dialect, before)
    assert applied(view.document, rebuilt(view, "fix-all", Pos(0, 0), Pos(0, 0)).edits).text == after
    view, _ = at_cursor(dialect, after)
    assert rebuilt(view, "fix-all", Pos(0, 0), Pos(0, 0)).edits == ()


@pytest.mark.parametrize(
    ("dialect", "text", "expected"),
    [
        (
            "rs274",
            "G21 G90 G17\no<Deep> call [1]\nM2\n",
            NewFile("/job/deep.ngc", "o<deep> sub\n\no<deep> endsub\nM2\n"),
        ),
        ("rs274", "G21 G90 G17\no9 call\nM2\n", NewFile("/job/9.ngc", "o9 sub\n\no9 endsub\nM2\n")),
        ("metagcode", "#FILE mill/deep.txt\n", NewFile("/job/Snippets/mill/deep.txt", "")),
        ("rs274", "G21 G90 G17\nG0 X[1/0]\nM2\n", None),
    ],
)
def test_the_file_that_is_missing(dialect: str, text: str, expected: NewFile | None) -> None:
    view, _ = at_cursor(dialect, text, Snippets__other_txt="")
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    assert [missing_file(view, each) for each in findings] == [expected]


def test_the_file_of_a_call_by_path() -> None:
    view, _ = at_cursor("z32", "(P)\n!:L254-SUBS\\DRILL!\nM30\n", {"file-root": "icamfs"}, icamfs__other="G26\n")
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    assert [missing_file(view, each) for each in findings] == [NewFile("/job/icamfs/SUBS/DRILL", "G26\n")]


@pytest.mark.parametrize(("call", "folder"), [("GOP", "cmos"), ("GOS", "cmos-temp")])
def test_the_file_of_a_program_in_the_memory(call: str, folder: str) -> None:
    text, settings = f"(P)\n!{call}9!\nM30\n", {"cmos-dir": "cmos"}
    beside = {f"{folder}/3.z32": "G26\n"}
    view, _ = at_cursor("z32", text, settings, beside)
    findings = Analysis(view.document, view.ruleset, view.file, view.host).findings()
    assert [missing_file(view, each) for each in findings] == [NewFile(f"/job/{folder}/9.z32", "G26\n")]
    view, _ = at_cursor("z32", text, settings, {**beside, f"{folder}/9.z32": "G26\n"})
    assert Analysis(view.document, view.ruleset, view.file, view.host).findings() == []
