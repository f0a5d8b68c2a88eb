"""How Z32 lines are read: trees and problems worked out by hand from spec/z32.md §2 and §3."""

import re

import pytest

from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.tree import Node, Token

Z32 = by_name("z32")


def told(text: str) -> str:
    """The tree of a line in one string: `(word HA (angle < X >))`."""
    line = Document.parse(text, Z32).node(0)
    assert line.problems == (), line.problems

    def said(part: Node | Token) -> str:
        if isinstance(part, Token):
            return text[part.start : part.end]
        return f"({part.kind} {' '.join(map(said, part.children))})"

    return " ".join(map(said, line.tree.children))


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ("N12 G0 Z120.5 ;some text", "(nword N 12) (g_word G 0) (word Z 120.5) (text ;some text)"),
        ("(this is a comment)", "(this is a comment)"),
        ("/N5 X1", "/ (nword N 5) (word X 1)"),
        (":1", "(section :1)"),
        (":1 DRILL", "(section :1 DRILL)"),
        ("%", "%"),
        ("HA10", "(word HA 10)"),
        ("HA 10 X .1", "(word HA 10) (word X .1)"),
        ("X1Y-2Z+,5", "(word X 1) (word Y (signed - 2)) (word Z (signed + ,5))"),
        ("HA<X+Y*(2+X)>", "(word HA (angle < (sum X + (product Y * (group ( (sum 2 + X) )))) >))"),
        ("HA<X-Y+2>", "(word HA (angle < (sum X - Y + 2) >))"),
        ("HA<-X*-2>", "(word HA (angle < (product (unary - X) * (unary - 2)) >))"),
        ("HA<SN(X)>", "(word HA (angle < (function SN ( X )) >))"),
        ("HA<PI>", "(word HA (angle < PI >))"),
        ("F<F+100>", "(word F (angle < (sum F + 100) >))"),
        (
            "PAL[10+PAL[6]]<1+2>",
            "(word (vector PAL [ (sum 10 + (vector PAL [ 6 ])) ]) (angle < (sum 1 + 2) >))",
        ),
        ("PAL[<2*PAL[1]>]5", "(word (vector PAL [ (angle < (product 2 * (vector PAL [ 1 ])) >) ]) 5)"),
        ("PAR[300]10", "(word (vector PAR [ 300 ]) 10)"),
        ("G25XYZ AA1", "(axis_alias G25XYZ) (word (alias_name AA) 1)"),
        ("G26", "(g_word G 26)"),
        ("M30", "(word M 30)"),
        ("QQ5", "(word (other QQ) 5)"),
        ("X<HA> (c) Y5", "(word X (angle < HA >)) (c) (word Y 5)"),
        ("HA&ltX+Y&gt", "(word HA (angle &lt (sum X + Y) &gt))"),
        ("X1 ;wow!", "(word X 1) (text ; wow!)"),
        ("!X=0!", "(advanced ! (assign X = 0) !)"),
        ("N1.5 !X=Y! ;assignment", "(nword N 1.5) (advanced ! (assign X = Y) ! ;assignment)"),
        ("!X=0! (store !)", "(advanced ! (assign X = 0) ! (store !))"),
        ("!HX=1;HY=1;CP!", "(advanced ! (assign HX = 1) ; (assign HY = 1) ; (polar CP) !)"),
        ("!IF X=Y ; GOP1!", "(advanced ! (if IF (comparison X = Y)) ; (call GOP 1) !)"),
        ("!IF X<>Y ; X=X+1!", "(advanced ! (if IF (comparison X < > Y)) ; (assign X = (sum X + 1)) !)"),
        ("!IF X<=Y;EB!", "(advanced ! (if IF (comparison X < = Y)) ; (stop EB) !)"),
        ("!IF X < Y;EB!", "(advanced ! (if IF (comparison X < Y)) ; (stop EB) !)"),
        ("!IF X>=Y;EB!", "(advanced ! (if IF (comparison X > = Y)) ; (stop EB) !)"),
        ("!IF PAL[<HA>]>5;EB!", "(advanced ! (if IF (comparison (vector PAL [ (angle < HA >) ]) > 5)) ; (stop EB) !)"),
        ("!IF <HA>=5;EB!", "(advanced ! (if IF (comparison (angle < HA >) = 5)) ; (stop EB) !)"),
        ("!IF X<<Y>;EB!", "(advanced ! (if IF (comparison X < (angle < Y >))) ; (stop EB) !)"),
        (
            "!IF (HA+HB)*PAR[10]>=HC; GON20!",
            "(advanced ! (if IF (comparison (product (group ( (sum HA + HB) )) * (vector PAR [ 10 ])) > = HC)) ; (jump GON 20) !)",
        ),
        ("!GON150-N200!", "(advanced ! (jump GON 150 (range_end -N 200)) !)"),
        ("!GON<HA>!", "(advanced ! (jump GON (angle < HA >)) !)"),
        ("!GOS<HA+1>!", "(advanced ! (call GOS (angle < (sum HA + 1) >)) !)"),
        ("!:L254-FOLDER\\FILE!", "(advanced ! (file_call :L254- FOLDER\\FILE) !)"),
        ("!HA=5-NA!", "(advanced ! (assign HA = (sum 5 - (other NA))) !)"),
        (
            "ADD_VAR=$FCEPP('ADD_VAR_SYST_SPEC','MYVARNAME',0)",
            "(config ADD_VAR = $FCEPP ( 'ADD_VAR_SYST_SPEC' , 'MYVARNAME' , 0 ))",
        ),
    ],
)
def test_trees(text: str, tree: str) -> None:
    assert told(text) == tree


def check_problem(text: str, kind: str, marked: str) -> None:
    """``marked`` is the line with `^` under the span."""
    (problem,) = Document.parse(text, Z32).node(0).problems
    assert (problem.kind, " " * problem.start + "^" * (problem.end - problem.start)) == (kind, marked)


@pytest.mark.parametrize(
    ("text", "kind", "marked"),
    [
        ("X1 (a 12 (b) c) ;(", "comment-nested", "         ^^^"),
        ("X12345 (open 1", "comment-unclosed", "       ^^^^^^^"),
        ("!IF HA; HB<2; GON1!", "if-syntax", " ^^^^^"),
        ("!IF;EB!", "if-syntax", " ^^"),
        ("!IF (HA>5; EB!", "paren-unclosed", "    ^^^"),
        ("!IF PAL[<HA>>5;EB!", "expression-syntax", "       ^^^^^"),
        ("HA<X>5>", "relational-outside-if", "    ^"),
        ("HA<(X+>", "paren-unclosed", "   ^^^"),
        ("HA<X+", "angle-unclosed", "  ^^^"),
        ("X<HA*2 (text) Y5", "angle-unclosed", " ^^^^^"),
        ("HA<X+1)>", "expression-syntax", "      ^"),
        ("HA<HB(3)>", "expression-syntax", "     ^^^"),
        ("HA<POW(X,2)>", "function-unknown", "   ^^^"),
        ("X<PAL>", "expression-syntax", "  ^^^"),
        ("PAR[1234]", "word-syntax", "^^^^^^^^^"),
        ("PAL 5", "word-syntax", "^^^"),
        ("X1 > 5", "word-syntax", "   ^"),
        ("%X", "word-syntax", " ^"),
        ("!GON1234-200;HA=1!", "field-unknown", " ^^^^^^^^^^^"),
        ("!CP 5!", "field-unknown", " ^^^^"),
        ("!:L254-!", "field-unknown", " ^^^^^^"),
        ("!X=1 Y2!", "expression-syntax", "     ^"),
        ("$FCEPP('X',", "word-syntax", "^^^^^^^^^^^"),
    ],
)
def test_problems(text: str, kind: str, marked: str) -> None:
    check_problem(text, kind, marked)


def readings(text: str) -> list[str]:
    return [line.reading.name for line in Document.parse(text, Z32).nodes()]


def test_text_before_the_first_percent_is_title() -> None:
    assert readings("PART (7\n% not alone\n % \nX1\n%\nX2") == [
        "title",
        "title",
        "program",
        "program",
        "program",
        "program",
    ]


def test_without_percent_all_is_program() -> None:
    assert readings("X1\n%A\nM30\nN10 X2") == ["program"] * 4


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("N12 G01 X12.5 (any 5) Y7 ;text 8", "N0 G01 X0.0 () Y0 ;"),
        ("  (any 5)", "  ()"),
        ("X<HA> (kept 12)", "X<HA> (kept 0)"),
        ("!X=0; Y=12! ;text", "!X=0; Y=0! ;"),
        ("!:L254-A12!", "!:L254-A0!"),
        ("X1 ;see (12) !", "X0 ;see (0) !"),
    ],
)
def test_only_what_is_comment_for_sure_is_folded(text: str, shape: str) -> None:
    line = Document.parse(text, Z32).node(0)
    assert line.shape.text == shape


@pytest.mark.parametrize(
    "text",
    [
        "X<5 (a>b)>",
        "4.5(a;PAL[$F(",
        "G25XYZM30'X'text256'X'*256",
        "N10 G0 X<HA*2> (c 12) Y5 ;t 5",
        "!IF HA>QQ10; HA=12!",
        "PAL[10+PAL[6];]<12>",
        "é 12 (5) ;12",
    ],
)
def test_a_shape_reads_as_the_line_itself(text: str) -> None:
    line = Document.parse(text, Z32).node(0)
    direct = Z32.grammar.parse("line", text)
    assert direct.tree == line.tree
    assert ([] if direct.fault is None else [Z32.diagnose(direct.fault)]) == list(line.problems)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("G0 X1\n!X=0!\n", True),
        ("N10 !IF HA>1; GON20!", True),
        ("/!PAL[3]=PAL[3]+1!", True),
        ("!:L254-FOLDER\\FILE!", True),
        ("A=$FCEPP('INIT_VAR_SYST')", True),
        ("G0 X1 (stop!) (wait!)", False),
        ("!!! attention !!!", False),
        ("#1=[2+3]\nG1 X#1 (a=b!)", False),
        ("%\nO1000\nIF [#1 EQ 2] GOTO 10\nM30", False),
    ],
)
def test_evidence(text: str, shown: bool) -> None:
    assert any(re.search(evidence.pattern, text) for evidence in Z32.evidence) is shown
