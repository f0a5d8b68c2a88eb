"""CGT lines and sections: what they are read as, and what is wrong with them, by hand from spec/cgt.md."""

import pytest

from deburr_grammar.dialect import Role
from deburr_grammar.dialects import by_name
from deburr_grammar.dialects.cgt.outline import SECTIONS, TABLE_WORDS
from deburr_grammar.document import Document
from deburr_grammar.structure import Fault
from deburr_grammar.tree import Node, Token

DIALECT = by_name("cgt")


def shown(line: str, header: str = "@LINE") -> str:
    """The tree of a line in a section as one expression: rule names with their parts, tokens as their text between `|`."""
    return _shown(line, Document.parse(f"{header}\n{line}\n", DIALECT).node(1).tree)


def _shown(line: str, part: Node | Token) -> str:
    if isinstance(part, Token):
        return line[part.start : part.end]
    return f"{part.kind}({'|'.join(_shown(line, child) for child in part.children)})"


def readings(text: str) -> list[str]:
    return [node.reading.name for node in Document.parse(text, DIALECT).nodes()]


@pytest.mark.parametrize(
    ("line", "tree"),
    [
        ("G0 X1 (a, b) / c", "template(G0 X1 (a, b) / c)"),
        ("", "template()"),
        ("  // only this", "template(  |// only this)"),
        ("a // b <c> #d", "template(a |// b <c> #d)"),
        ("#100=#5 # a", "template(#100=#5 # a)"),
        ("< #MOV#OR X#XPOS >", "template(<| |#MOV|#OR| X|#XPOS| |>)"),
        ("< #MOV,#AND X#XPOS >", "template(<| |#MOV|,|#AND| X|#XPOS| |>)"),
        ("<X,Y#XPOS,>", "template(<|X,Y|#XPOS|,|>)"),
        ("<X#XPOS#ANDY#YPOS>", "template(<|X|#XPOS|#ANDY|#YPOS|>)"),
        ("#XPOSY", "template(#XPOSY)"),
        ("TOOL#TOOL#EVAL(#V1=1)", "template(TOOL|#TOOL|eval(#EVAL|(|#V1|=|1|)))"),
        ("<T#NTOOL>#ELSE< T0>", "template(<|T|#NTOOL|>|#ELSE|<| T0|>)"),
        ("#IF(#V1>3)<a>", "template(if(#IF|(|tests(test(#V1|>|3))|)|<)|a|>)"),
        (
            "#IF(#V2>3,#OR#V2<-1)<a>",
            "template(if(#IF|(|tests(test(#V2|>|3)|,|#OR|test(#V2|<|signed(-|1)))|)|<)|a|>)",
        ),
        ("#IF(#V1+1 <> 2*3)<a>", "template(if(#IF|(|tests(test(sum(#V1|+|1)|<>|product(2|*|3)))|)|<)|a|>)"),
        ("#IFSTR(#S1=G00)<a>", "template(if(#IFSTR|(|string_tests(string_test(#S1|=|G00))|)|<)|a|>)"),
        (
            "#IFSTR(#S1=a, b ,#AND #S2<> #S3)<a>",
            "template(if(#IFSTR|(|string_tests(string_test(#S1|=|a, b )|,|#AND|string_test(#S2|<>|#S3))|)|<)|a|>)",
        ),
        (
            "#IFSTR(#S1=,#OR#S2=)<a>",
            "template(if(#IFSTR|(|string_tests(string_test(#S1|=)|,|#OR|string_test(#S2|=))|)|<)|a|>)",
        ),
        ("#IFCHG(#XPOS, #YPOS)<a>", "template(if(#IFCHG|(|#XPOS|,|#YPOS|)|<)|a|>)"),
        ("#REPEAT(3)", "template(repeat(#REPEAT|(|3|)))"),
        ("#REPEAT(#n) <", "template(repeat(#REPEAT|(|#n|))| |<)"),
        ("#INT #a , #b", "template(declaration(#INT|#a| ,|#b))"),
        ("#TBL#myTable", "template(declaration(#TBL|#myTable))"),
        ("#CALL( a_1 )#GOTO($x)", "template(call(#CALL|(|a_1|))|call(#GOTO|(|$x|)))"),
        ("#RESET(#XPOS,#YPOS)", "template(mark(#RESET|(|#XPOS|,|#YPOS|)))"),
        ("#TABLE(t, -1)", "template(lookup(#TABLE|(|t|,|negative(-|1)|)))"),
        ("#FMT(#XPOS, D+3.4,10)", "template(fmt(#FMT|(|#XPOS|,|D+3.4|,|10|)))"),
        ("#GETBLK(0)#SETBLK(#V1)", "template(block(#GETBLK|(|0|))|block(#SETBLK|(|#V1|)))"),
        ("#EXIT#EXITC#ONBLK", "template(#EXIT|#EXITC|#ONBLK)"),
        ("#EVAL(#V1=-2^2^3)", "template(eval(#EVAL|(|#V1|=|power(power(signed(-|2)|^|2)|^|3)|)))"),
        ("#EVAL(#V1=1-2-3)", "template(eval(#EVAL|(|#V1|=|sum(sum(1|-|2)|-|3)|)))"),
        ("#EVAL(#V1=1/2*3)", "template(eval(#EVAL|(|#V1|=|product(quotient(1|/|2)|*|3)|)))"),
        ("#EVAL(#V1=(1+.5)*2.)", "template(eval(#EVAL|(|#V1|=|product(group((|sum(1|+|.5)|))|*|2.)|)))"),
        (
            "#EVAL(#V1=PI+PI()+MAX(1,#V2))",
            "template(eval(#EVAL|(|#V1|=|sum(sum(PI|+|function(PI|(|)))|+|function(MAX|(|1|,|#V2|)))|)))",
        ),
        ("#EVAL(#V1=jos(TOOL DIA))", "template(eval(#EVAL|(|#V1|=|job(jos|(|TOOL DIA|))|)))"),
        ("#EVAL(#S9=M03)", "template(eval(#EVAL|(|#S9|=|M03|)))"),
        ("#EVAL(#S9=G0 X-1.5: 5%)", "template(eval(#EVAL|(|#S9|=|G0 X-1.5: 5%|)))"),
        ("#EVAL(#S9=)", "template(eval(#EVAL|(|#S9|=|)))"),
        ("#EVAL(3=#V1)", "template(eval(#EVAL|(|3|=|#V1|)))"),
        ("#EVMD(#x=1)#EVMS(#y=M03)", "template(macro(#EVMD|(|#x|=|1|))|macro(#EVMS|(|#y|=|M03|)))"),
        ("#RETNUM(#V1)#RETSTR(abc)", "template(returned(#RETNUM|(|#V1|))|returned(#RETSTR|(|abc|)))"),
        ("#eval(#V1=1)#If(#V1=1)<a>", "template(eval(#eval|(|#V1|=|1|))|if(#If|(|tests(test(#V1|=|1))|)|<)|a|>)"),
        ("#IFX(1)#EVALUATE(2)", "template(#IFX|(1)|#EVALUATE|(2))"),
    ],
)
def test_template_lines_are_read_as_the_reference_says(line: str, tree: str) -> None:
    assert shown(line) == tree


@pytest.mark.parametrize(
    ("line", "tree"),
    [
        ("0,Off", "table(row(0|,|Off))"),
        (",Off", "table(row(,|Off))"),
        (" 10 , M3, <b> ", "table(row(10 |,| M3, <b> ))"),
        ("1,G41 D#DOFF #5", "table(row(1|,|G41 D|#DOFF| #5))"),
        ("1,", "table(row(1|,))"),
        ("// a, b", "table(// a, b)"),
        ("1,a // b", "table(row(1|,|a )|// b)"),
        ("", "table()"),
    ],
)
def test_table_rows_are_read_as_the_reference_says(line: str, tree: str) -> None:
    assert shown(line, "@MOV") == tree


@pytest.mark.parametrize(
    ("line", "kind", "marked"),
    [
        ("#IF(#V1)<..>", "if-syntax", "#IF(#V1)"),
        ("#IF(#V1>3)", "if-syntax", "#IF(#V1>3)"),
        ("#IF(#V1>3)  // c", "if-syntax", "#IF(#V1>3)"),
        ("#IF(#V1>3) <a>", "if-syntax", "#IF(#V1>3)"),
        ("#IF(#V1>3", "command-syntax", "#IF(#V1>3"),
        ("#IFCHG(3)<..>", "ifchg-argument", "3"),
        ("#IFCHG <a>", "if-syntax", "#IFCHG"),
        ("#EVAL(#V1)", "eval-syntax", "#EVAL(#V1)"),
        ("#EVAL (#V1=1)", "eval-syntax", "#EVAL"),
        ("x #EVAL(#V1=1 22) y", "eval-syntax", "22"),
        ("#EVAL(#V12=100 // half", "command-syntax", "#EVAL(#V12=100"),
        ("#EVAL(#V1=12345*)", "eval-syntax", "#EVAL(#V1=12345*)"),
        ("#CALL()", "command-syntax", "#CALL()"),
        ("#CALL(12ab)", "command-syntax", "12ab"),
        ("#TABLE(t)", "command-syntax", "#TABLE(t)"),
        ("#TABLE(t,#V1+1)", "command-syntax", "+"),
        ("#INT", "command-syntax", "#INT"),
        ("#INT #a,", "command-syntax", "#INT #a,"),
        ("#REPEAT()", "command-syntax", "#REPEAT()"),
    ],
)
def test_a_broken_line_is_one_problem_at_its_place(line: str, kind: str, marked: str) -> None:
    (problem,) = Document.parse(f"@LINE\n{line}\n", DIALECT).node(1).problems
    assert (problem.kind, line[problem.start : problem.end]) == (kind, marked)


@pytest.mark.parametrize(
    ("line", "marked"),
    [("@9x", "@9x"), ("@", None), ("@A-B", "@A-B"), ("@LINE 5 // c", "5"), ("@ LINE", "@ LINE"), ("@LINE//c", None)],
)
def test_headers_hold_a_name_and_nothing_else(line: str, marked: str | None) -> None:
    document = Document.parse(f"@START\n{line}\n", DIALECT)
    assert [(p.kind, line[p.start : p.end]) for _, p in document.problems()] == (
        [("section-name", marked)] if marked else []
    )


def test_a_row_without_a_comma_is_a_problem() -> None:
    (problem,) = Document.parse("@MOV\n  G00 12 // rapid\n", DIALECT).node(1).problems
    assert (problem.kind, problem.start, problem.end) == ("table-row", 2, 8)


def test_sections_decide_how_lines_are_read() -> None:
    text = "free text #IF(\n@\n@DECLARE\n#INT #a\n@START // c\nG90\n@\nnotes <\n@MOV\n0,G00\n@other\nx"
    assert readings(text) == [
        "preamble",
        "preamble",
        "header",
        "declare",
        "header",
        "template",
        "header",
        "outside",
        "header",
        "table",
        "header",
        "template",
    ]
    assert not list(Document.parse(text, DIALECT).problems())


@pytest.mark.parametrize(
    ("by", "table"),
    [
        ("#TABLE(t, 1)", True),
        ("#table( t,1)", True),
        ("#TBL#t", True),
        ("#TBL #s, #t", True),
        ("// #TABLE(t, 1)", False),
        ("#TABLE(T, 1)", False),
        ("#INT #t", False),
    ],
)
def test_a_section_is_a_table_if_something_names_it(by: str, table: bool) -> None:
    assert readings(f"@t\n0,a\n@START\n{by}")[1] == ("table" if table else "template")


def test_a_section_that_the_generator_runs_is_never_a_table() -> None:
    assert readings("@START\n#TABLE(LINE,1)\n@LINE\nG01") == ["header", "template", "header", "template"]


def test_a_table_that_is_named_later_is_read_again() -> None:
    from deburr_grammar.text import Edit, Pos

    document = Document.parse("@t\n0,a\n@START\n", DIALECT)
    edited = document.edit(Edit(Pos(3, 0), Pos(3, 0), "#TABLE(t,0)"))
    assert document.node(1).reading.name == "template"
    assert edited.node(1).reading.name == "table"


def test_brackets_pair_over_lines_and_never_over_sections() -> None:
    document = Document.parse("@LINE\n#REPEAT(3)\n<\nX<Y\n>>\n@a\n>\n<\n@b\n", DIALECT)
    found = [(line, bracket.word) for line, bracket in document.brackets() if bracket.kind == "bracket"]
    assert found == [(2, "<"), (3, "<"), (4, ">"), (4, ">"), (6, ">"), (7, "<")]
    faults = [(f.fault, f.at.line) for f in document.faults if f.at.bracket.kind == "bracket"]
    assert faults == [(Fault.UNOPENED, 6), (Fault.UNCLOSED, 7)]


def test_comparisons_are_no_brackets() -> None:
    document = Document.parse("@LINE\n#IF(#V1<#V2,#AND#V1<>3)<a>\n", DIALECT)
    spans = [tuple(bracket.span) for _, bracket in document.brackets() if bracket.kind == "bracket"]
    assert spans == [(23, 24), (25, 26)]


@pytest.mark.parametrize(
    "line", ["#IF(#V1)<a>", "#EVAL(#V1)<X#XPOS #IF(#V1>3)<a>>", "#CALL(1 (<) )<b>", "#IF(#V1>3) <a>", "#INT a<b>"]
)
def test_brackets_behind_a_fault_still_pair(line: str) -> None:
    document = Document.parse(f"@LINE\n<\n{line}\n>\n", DIALECT)
    assert not [fault for fault in document.faults if fault.at.bracket.kind == "bracket"]


def test_sections_are_regions() -> None:
    document = Document.parse("x\n@A\n@\n@B1 // c\n@9 \n", DIALECT)
    found = [(line, b.role, b.label) for line, b in document.brackets()]
    assert found == [
        (1, Role.REGION, "A"),
        (2, Role.END_REGION, "A"),
        (3, Role.REGION, "B1"),
        (4, Role.END_REGION, "B1"),
        (4, Role.REGION, "9"),
    ]


def test_names_are_told_apart_by_their_digits() -> None:
    fold = DIALECT.folding.fold
    assert fold("#V12 X12 FXD123") == "#V12 X0 FXD0"
    assert fold("@FXD12\n12 // #V12 12") == "@FXD12\n0 //"


def test_the_lists_of_the_outline_are_those_of_the_tables() -> None:
    words = DIALECT.codes.table("word")
    assert {entry.name for entry in words if entry.more["type"] == "table"} == TABLE_WORDS
    assert {entry.name for entry in DIALECT.codes.table("section")} == SECTIONS
