"""RS274 lines: what they are read as, and what is wrong with them, by hand from spec/rs274.md."""

import pytest

from deburr_grammar.dialects import by_name
from deburr_grammar.dialects.rs274.outline import codes
from deburr_grammar.document import Document
from deburr_grammar.tree import Node, Token

DIALECT = by_name("rs274")


def shown(line: str) -> str:
    """The tree of a line as one expression: rule names with their parts, tokens as their text."""
    return _shown(line, Document.parse(line, DIALECT).node(0).tree)


def _shown(line: str, part: Node | Token) -> str:
    if isinstance(part, Token):
        return line[part.start : part.end].strip()
    return f"{part.kind}({' '.join(_shown(line, child) for child in part.children)})"


@pytest.mark.parametrize(
    ("line", "tree"),
    [
        ("G0 X1", "line(item(word(G 0)) item(word(X 1)))"),
        ("g0x +0. 12 34y 7", "line(item(word(g 0)) item(word(x signed(+ 0. 12 34))) item(word(y 7)))"),
        ("/N5.5 M3", "line(/ line_number(N 5.5) item(word(M 3)))"),
        ("#1=2", "line(item(setting(param(# 1) = 2)))"),
        ("##2=#[1]", "line(item(setting(param(# param(# 2)) = param(# group([ 1 ])))))"),
        ("#<a b>=-#1", "line(item(setting(param(# <a b>) = signed(- param(# 1)))))"),
        ("X[1+2*3]", "line(item(word(X group([ sum(1 + product(2 * 3)) ]))))"),
        ("X[2**3**2]", "line(item(word(X group([ power(power(2 ** 3) ** 2) ]))))"),
        ("X[-2**2]", "line(item(word(X group([ power(signed(- 2) ** 2) ]))))"),
        ("X[#1+2]", "line(item(word(X group([ sum(param(# 1) + 2) ]))))"),
        ("X[1 OR 0 AND 0]", "line(item(word(X group([ logical(logical(1 OR 0) AND 0) ]))))"),
        ("X[1 + 1 EQ 2]", "line(item(word(X group([ comparison(sum(1 + 1) EQ 2) ]))))"),
        ("X[7 MOD 3]", "line(item(word(X group([ modulo(7 MOD 3) ]))))"),
        ("X[4 M O D 3]", "line(item(word(X group([ modulo(4 M O D 3) ]))))"),
        ("XATAN[1]/[2]", "line(item(word(X atan(ATAN group([ 1 ]) / group([ 2 ])))))"),
        ("XSIN[30]", "line(item(word(X function(SIN group([ 30 ])))))"),
        ("o1 else if [1] (c)", "line(o_line(o label(1) else if group([ 1 ]) (c)))"),
        ("O<a> CALL [1] (x) [2]", "line(o_line(O label(<a>) CALL group([ 1 ]) (x) group([ 2 ])))"),
        ("o 1 0 0 sub", "line(o_line(o label(1 0 0) sub))"),
        ("(DEBUG,a #<b> #5 # 6)", "line(item(active((DEBUG, a #<b>  #5 # 6 ))))"),
        ("G0 (a ; b) X1 ; (c", "line(item(word(G 0)) item((a ; b)) item(word(X 1)) ; (c)"),
        ("%", "line(%)"),
        ("G0 X1\f", "line(item(word(G 0)) item(word(X 1)))"),
    ],
)
def test_lines_are_read_as_the_reference_says(line: str, tree: str) -> None:
    assert shown(line) == tree


@pytest.mark.parametrize(
    ("line", "kind", "marked", "expected"),
    [
        ("G0 X1 (a (b) c)", "comment-nested", "(b)", ()),
        ("(DEBUG, a (b)", "comment-nested", "(b)", ()),
        ("X1 (oops", "comment-unclosed", "(oops", ()),
        ("X1,5", "bad-character", ",", ()),
        ("G0\fX1", "bad-character", "\f", ()),
        ("X1.2.3", "number-format", "1.2.3", ()),
        ("X", "value-missing", "X", ("a number", "a parameter `#`", "`[`", "`+` or `-`", "a function")),
        ("X[1+2", "expression-unclosed", "[1+2", ("`+` or `-`", "`]`", "an operator")),
        ("X[1 & 2]", "operator-unknown", "&", ("`+` or `-`", "`]`", "an operator")),
        ("o1 if[1]2", "o-extra-text", "2", ()),
        ("o1 endif\xa0", "o-extra-text", "\xa0", ()),
        ("o1 callsub [1]", "o-unknown", "callsub", ("`[`", "a comment")),
        ("G0 XO Y0", "value-missing", "X", ("a number", "a parameter `#`", "`[`", "`+` or `-`", "a function")),
        ("Z- F100", "value-missing", "-", ("a number", "a parameter `#`", "`[`", "`+` or `-`", "a function")),
        ("X1 side 2", "function-unknown", "side", ("a number", "a parameter `#`", "`[`", "`+` or `-`", "a function")),
        ("XFOO[1]", "function-unknown", "FOO", ("a number", "a parameter `#`", "`[`", "`+` or `-`", "a function")),
        ("o1 gosub", "o-unknown", "gosub", ("an O-word command", "a comment")),
        ("G0 N5", "line-number", "N", ("a parameter `#`", "a word", "a comment")),
        ("#1 5", "param-equal-missing", "#1 5", ("`=`",)),
        ("#4=#1+2", "operator-outside-brackets", "+", ("a parameter `#`", "a word", "a comment")),
        ("#4=#1/2", "operator-outside-brackets", "/", ("a parameter `#`", "a word", "a comment")),
        ("G0 /X1", "block-delete-position", "/", ("a parameter `#`", "a word", "a comment")),
        ("G0 %", "percent", "%", ()),
    ],
)
def test_faults_are_named_where_they_stand(line: str, kind: str, marked: str, expected: tuple[str, ...]) -> None:
    (problem,) = Document.parse(line, DIALECT).node(0).problems
    assert (problem.kind, line[problem.start : problem.end]) == (kind, marked)
    # `$END` is no sign that one could write, so a list that would name it alone says nothing.
    assert tuple(word for word in problem.expected if word != "the end of the line") == expected


def test_a_faulty_line_keeps_what_was_read_before_the_fault() -> None:
    assert shown("G0 X[1+2] & Y3").startswith("line(item(word(G 0))")


def readings(program: str) -> list[str]:
    document = Document.parse(program, DIALECT)
    return [document.node(line).reading.name for line in range(document.line_count)]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("G0 X1\nM2\ntext &", ["program", "program", "after-end"]),
        ("M02\ntext", ["program", "after-end"]),
        ("m 30 (end)\ntext", ["program", "after-end"]),
        ("M2.0\ntext", ["program", "after-end"]),
        ("M20\nG0 X1", ["program", "program"]),
        ("(M2)\nG0 X1", ["program", "program"]),
        ("M#1\nG0 X1", ["program", "program"]),
        ("o1 if [0]\nM2\no1 endif\nG0", ["program"] * 4),
        ("o1 sub\nM2\no1 endsub\nG0", ["program"] * 4),
        ("M2\no1 sub\nG0 X1\no1 endsub\ntext", ["program", "program", "program", "program", "after-end"]),
        ("M2\no1 endif\no1 if [1]", ["program", "after-end", "after-end"]),
        ("%\nG0\n%\no1 sub\ntext", ["program", "program", "program", "after-end", "after-end"]),
        ("%\nG0\nM2\ntext", ["program", "program", "program", "after-end"]),
        ("M2\n%\n%abc", ["program", "after-end", "after-end"]),
        ("%\nM2\n%\no1 sub\ntext", ["program", "program", "after-end", "after-end", "after-end"]),
        ("%abc\nG0\n%\ntext", ["program", "program", "program", "after-end"]),
        ("%\nG0\n%abc\ntext", ["program", "program", "program", "after-end"]),
    ],
)
def test_where_a_program_ends(program: str, expected: list[str]) -> None:
    assert readings(program) == expected


def test_a_while_ends_a_do_of_its_label_and_opens_a_loop_otherwise() -> None:
    document = Document.parse("o1 do\no2 while [0]\no2 endwhile\no1 while [0]\no1 while [1]", DIALECT)
    assert [(line, bracket.role.name, bracket.kind) for line, bracket in document.brackets()] == [
        (0, "OPEN", "do"),
        (1, "OPEN", "while"),
        (2, "CLOSE", "while"),
        (3, "CLOSE", "do"),
        (4, "OPEN", "while"),
    ]


@pytest.mark.parametrize(
    ("line", "label"),
    [
        ("o1 if [1]", "1"),
        ("O01.0 if [1]", "1"),
        ("o<1> if [1]", "1"),
        ("o< A b > if [1]", "ab"),
        ("o-100 if [1]", "-100"),
        ("o - 01.0 if [1]", "-1"),
        ("o--7 if [1]", "7"),
        ("o+7 if [1]", "7"),
        ("o-0 if [1]", "0"),
        ("o#1 if [1]", None),
        ("o-#1 if [1]", None),
        ("o[1+1] if [1]", None),
    ],
)
def test_labels_are_compared_as_the_interpreter_does(line: str, label: str | None) -> None:
    assert [bracket.label for _, bracket in Document.parse(line, DIALECT).brackets()] == [label]


@pytest.mark.parametrize(
    ("line", "role", "kind", "label"),
    [
        ("o1 wend", "CLOSE", "while", "1"),
        ("o<a> loop [3]", "OPEN", "repeat", "a"),
        ("o#1 loop [3]", "OPEN", "repeat", None),
        ("o1 endifs", "CLOSE", "if", "1"),
        ("o1 elif [2]", "MIDDLE", "if", "1"),
    ],
)
def test_a_misspelt_command_does_what_was_meant(line: str, role: str, kind: str, label: str | None) -> None:
    ((_, bracket),) = Document.parse(line, DIALECT).brackets()
    assert (bracket.role.name, bracket.kind, bracket.label) == (role, kind, label)


def test_what_nobody_can_have_meant_does_nothing() -> None:
    assert list(Document.parse("o1 foo\no1 gosub [1]\n", DIALECT).brackets()) == []


def test_codes_in_their_canonical_spelling() -> None:
    node = Document.parse("g01 G38.20 m 0 6 T1 M#1", DIALECT).node(0)
    assert [code for code, _ in codes(node)] == ["G1", "G38.2", "M6"]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (
            "M98 P100\nM30\ntext\no100\nG0 X1\nM99\ntext",
            ["program", "program", "after-end", "program", "program", "program", "after-end"],
        ),
        ("M2\no100\no1 if [1]\nM99\no1 endif\nG0\nM99\ntext", ["program"] * 7 + ["after-end"]),
        ("M2\no100\nM30\ntext", ["program", "program", "program", "after-end"]),
        ("/M2\nG0 X1", ["program", "program"]),
        ("G0\nM99\nG1", ["program", "program", "program"]),
    ],
)
def test_programs_that_m98_calls_are_read_behind_the_end(program: str, expected: list[str]) -> None:
    assert readings(program) == expected
