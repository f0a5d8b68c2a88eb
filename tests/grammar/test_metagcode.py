"""MetaGCODE lines: what they are read as, and what is wrong with them, by hand from spec/metagcode.md."""

import re

import pytest

from deburr_grammar.dialects import by_name
from deburr_grammar.dialects.metagcode.forms import counters, is_numeric, name, names, number
from deburr_grammar.document import Document
from deburr_grammar.tree import Node, Token

DIALECT = by_name("metagcode")


def shown(line: str) -> str:
    """The tree of a line as one expression: rule names with their parts, tokens as their text."""
    return _shown(line, Document.parse(line, DIALECT).node(0).tree)


def _shown(line: str, part: Node | Token) -> str:
    if isinstance(part, Token):
        return line[part.start : part.end]
    return f"{part.kind}({' '.join(_shown(line, child) for child in part.children)})"


@pytest.mark.parametrize(
    ("line", "tree"),
    [
        ("", "line()"),
        (" \t ", "line()"),
        ("%", "line(%)"),
        ("  G0 X|a|Y-|b c| Z1 ", "line(G0 X |a| Y- |b c| Z1)"),
        ("X|a||b|", "line(X |a| |b|)"),
        ("G0 (PART |No| x) Z1", "line(G0 comment(( PART |No| x )) Z1)"),
        ("(a |x)y| b) Z1", "line(comment(( a |x)y| b )) Z1)"),
        ("()", "line(comment(( )))"),
        ("G0 (open |x| y", "line(G0 comment(( open |x| y))"),
        ("G0 ; foo (|x| ;", "line(G0 comment(; foo ( |x| ;))"),
        ("G0;", "line(G0 comment(;))"),
        # `#` and anything but a letter is G-code.
        ("#3=15", "line(#3=15)"),
        ("##2=1", "line(##2=1)"),
        ("#<x>=1 G1 X#<if>", "line(#<x>=1 G1 X#<if>)"),
        ("#[1+2]=3", "line(#[1+2]=3)"),
        ("#", "line(#)"),
        ("# FILE a.txt", "line(# FILE a.txt)"),
        ("#|a|=1", "line(# |a| =1)"),
        # Letters are ASCII.
        ("#ſile a", "line(#ſile a)"),
        ("#\u0131f1 a", "line(#\u0131f1 a)"),
        # A directive keyword behind something else.
        ("G0 X1 #FILE a.txt", "line(G0 X1 embedded(#FILE) a.txt)"),
        ("N10#endif1", "line(N10 embedded(#endif) 1)"),
        ("##IF1", "line(# embedded(#IF) 1)"),
        ("G0 X#FILES", "line(G0 X#FILES)"),
        ("G0 (#FILE a) ; #IF1", "line(G0 comment(( #FILE a )) comment(; #IF1))"),
    ],
)
def test_gcode_lines_pass_through_with_their_variables(line: str, tree: str) -> None:
    assert shown(line) == tree


@pytest.mark.parametrize(
    ("line", "tree"),
    [
        ("#IF1 |a| equalto 1 n", "line(if(#IF 1 condition(left(|a|) operator(equalto) right(1) type(n))))"),
        (
            "\t#If012  a\tNOTEQUALTO | b c | Alpha ",
            "line(if(#If 012 condition(left(a) operator(NOTEQUALTO) right(| b c |) type(Alpha))))",
        ),
        ("#IF1 n lessthan -.5 |t|", "line(if(#IF 1 condition(left(n) operator(lessthan) right(-.5) type(|t|))))"),
        ("#IF1 |a| = 1 text", "line(if(#IF 1 condition(left(|a|) operator(=) right(1) type(text))))"),
        ("#IF |a| equalto 1 n", "line(if(#IF condition(left(|a|) operator(equalto) right(1) type(n))))"),
        ("#IF1", "line(if(#IF 1))"),
        ("#IF1 a", "line(if(#IF 1 partial(left(a))))"),
        ("#IF1 a equalto", "line(if(#IF 1 partial(left(a) operator(equalto))))"),
        ("#IF1 a equalto 1", "line(if(#IF 1 partial(left(a) operator(equalto) right(1))))"),
        ("#IF1 a equalto 1 n |x|", "line(if(#IF 1 partial(left(a) operator(equalto) right(1) type(n) extra(|x|))))"),
        ("#IF1|a| equalto 1 n", "line(if(#IF 1 partial(|a| extra(equalto) extra(1) extra(n))))"),
        ("#IF1x a", "line(if(#IF 1 partial(x extra(a))))"),
        ("#IF-1 a", "line(if(#IF partial(-1 extra(a))))"),
        ("#IF1 |a|equalto 1 n", "line(if(#IF 1 partial(left(|a|) equalto extra(1) extra(n))))"),
        ("#IF1 a equalto|b| n", "line(if(#IF 1 partial(left(a) operator(equalto) |b| extra(n))))"),
        ("#ENDIF1", "line(endif(#ENDIF 1))"),
        (" #endif 1 x", "line(endif(#endif extra(1) extra(x)))"),
        ("#LOOP1 |z| 2 c", "line(loop(#LOOP 1 header(group(counter(|z|) step(2) mode(c)))))"),
        (
            "#Loop2 |c| |n| Cum |a| +.5 R",
            "line(loop(#Loop 2 header(group(counter(|c|) step(|n|) mode(Cum)) group(counter(|a|) step(+.5) mode(R)))))",
        ),
        ("#LOOP1 Z two |m|", "line(loop(#LOOP 1 header(group(counter(Z) step(two) mode(|m|)))))"),
        ("#LOOP1", "line(loop(#LOOP 1))"),
        ("#LOOP1 |z|", "line(loop(#LOOP 1 loose(counter(|z|))))"),
        ("#LOOP1 |z| 2", "line(loop(#LOOP 1 loose(counter(|z|) step(2))))"),
        ("#LOOP1 |z| 2 c |x|", "line(loop(#LOOP 1 loose(group(counter(|z|) step(2) mode(c)) counter(|x|))))"),
        ("#LOOP1 |z|2 c", "line(loop(#LOOP 1 loose(counter(|z|) 2 extra(c))))"),
        ("#LOOP1 |z| 2 c|x|", "line(loop(#LOOP 1 loose(group(counter(|z|) step(2) mode(c)) |x|)))"),
        ("#ENDLOOP1", "line(endloop(#ENDLOOP 1))"),
        ("#ENDLOOP", "line(endloop(#ENDLOOP))"),
        ("#FILE sub\\drill 12.txt  ", "line(file(#FILE sub\\drill 12.txt))"),
        ("#file", "line(file(#file))"),
        ("#FILE |s", "line(file(#FILE |s))"),
        ("#FILE1 a", "line(unknown(#FILE 1 a))"),
        ("#FILES a |b", "line(unknown(#FILES a |b))"),
        ("#IFx1 a", "line(unknown(#IFx 1 a))"),
        ("#WHILE1 |a| lessthan 3 n", "line(unknown(#WHILE 1 |a| lessthan 3 n))"),
    ],
)
def test_directives_are_read_item_by_item(line: str, tree: str) -> None:
    node = Document.parse(line, DIALECT).node(0)
    assert shown(line) == tree
    assert node.problems == ()


@pytest.mark.parametrize(
    ("line", "marked"),
    [
        ("G0 X|a ", "|a"),
        ("|", "|"),
        ("X|a Y|b| Z", "| Z"),
        ("(a | b)", "| b)"),
        ("; |x", "|x"),
        ("#IF1 |a equalto 1 n", "|a equalto 1 n"),
        ("#IF1 |a equalto |b| n", "| n"),
        ("#LOOP1 |z| 2 c |", "|"),
        ("#ENDIF1 |", "|"),
        ("#ENDLOOP1|", "|"),
    ],
)
def test_a_bar_without_partner_is_the_only_thing_that_cannot_be_read(line: str, marked: str) -> None:
    (problem,) = Document.parse(line, DIALECT).node(0).problems
    assert (problem.kind, line[problem.start : problem.end]) == ("unterminated-variable", marked)


@pytest.mark.parametrize(
    ("line", "bracket"),
    [
        ("#IF1 |a| equalto 1 n", ("OPEN", "if", "#IF", "1", "#IF1")),
        ("  #if012 |a equalto 1 n", ("OPEN", "if", "#IF", "012", "#if012")),
        ("#IF |a| equalto 1 n", ("OPEN", "if", "#IF", None, "#IF")),
        ("#LOOP3", ("OPEN", "loop", "#LOOP", "3", "#LOOP3")),
        ("#ENDIF12 x", ("CLOSE", "if", "#ENDIF", "12", "#ENDIF12")),
        ("#EndLoop1|", ("CLOSE", "loop", "#ENDLOOP", "1", "#EndLoop1")),
        (" #FILE a b.txt ", ("MIDDLE", "file", "#FILE", "a b.txt", "#FILE a b.txt")),
        ("#FILE", ("MIDDLE", "file", "#FILE", None, "#FILE")),
        ("#IFS1 a", ("MIDDLE", "unknown", "#IFS", "1", "#IFS1")),
        ("  #File1", ("MIDDLE", "unknown", "#FILE", "1", "#File1")),
        ("#else x", ("MIDDLE", "unknown", "#ELSE", None, "#else")),
        ("#WHILE12 |a", ("MIDDLE", "unknown", "#WHILE", "12", "#WHILE12")),
    ],
)
def test_directives_open_and_close_blocks_even_when_faulty(line: str, bracket: tuple[str, ...]) -> None:
    ((_, found),) = Document.parse(line, DIALECT).brackets()
    assert (found.role.name, found.kind, found.word, found.label, line[slice(*found.span)]) == bracket


@pytest.mark.parametrize("line", ["G0 #IF1", "#3=IF1", "(#IF1)", "# IF1", "#<if1>=2", "N1 #ENDIF1"])
def test_nothing_else_is_a_block(line: str) -> None:
    assert list(Document.parse(line, DIALECT).brackets()) == []


def test_what_a_loop_counts() -> None:
    line = Document.parse("#LOOP1 | z | 2 c Y 1 r |x y| |s| c", DIALECT).node(0)
    assert [(found, line.text[token.start : token.end]) for found, token in counters(line)] == [
        ("z", "| z |"),
        ("x y", "|x y|"),
    ]


def test_names_stand_between_two_bars_of_one_line() -> None:
    assert list(names("X|a\nY|b| |\tc |\n||")) == [(5, "b"), (9, "c"), (15, "")]
    assert name("|\t a b |") == "a b"


@pytest.mark.parametrize("text", ["0", "-12", "+3.", ".5", "-0.25", "007.10"])
def test_plain_decimal_numbers(text: str) -> None:
    assert str(number(text)) == str(number(text.rstrip(".")))
    assert number(text) is not None


@pytest.mark.parametrize("text", ["", "-", ".", "1e9", "1,5", "0x1", "٣", "1 2", "--1", "1.2.3", "inf", "1_0"])
def test_all_else_is_no_number(text: str) -> None:
    assert number(text) is None


def test_the_first_letter_of_a_type_decides() -> None:
    assert [is_numeric(said) for said in ("n", "Never", "a", "Alpha")] == [True, True, False, False]


@pytest.mark.parametrize(
    ("text", "proper"),
    [
        ("#IF1 |a| equalto 1 n\r\n", True),
        ("  #endloop12", True),
        ("#FILE drill.txt", True),
        ("G1 Z-|Depth| F100", True),
        ("G0 X|Start|", True),
        ("#FILE=3", False),
        ("#<if1>=2 (#IF1)", False),
        ("| Syntax | Description |\n| a | b |", False),
        ("a|b|c", False),
        ("G65 P9010 A1. #1=3", False),
        ("O1000 (PART | 5)", False),
    ],
)
def test_what_shows_that_a_text_is_metagcode(text: str, proper: bool) -> None:
    assert any(re.search(evidence.pattern, text) for evidence in DIALECT.evidence) is proper
