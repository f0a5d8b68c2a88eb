"""Every trigger of spec/metagcode.md §6 that a text decides, as it stands there, and what snippet files do to a program."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from deburr_grammar.dialects.metagcode.limits import LINES
from support.metagcode import found, said
from support.pages import MemoryHost

EXAMPLES = Path(__file__).parents[2] / "examples" / "metagcode"


TRIGGERS = [
    ("unknown-directive", 1, "#WHILE1 |a| lessthan 3 n", {}),
    ("label-missing", 1, "#IF |a| equalto 1 n\n#ENDIF1", {}),
    ("block-unclosed", 1, "#IF1 |a| equalto 1 n", {}),
    ("block-mismatch", 2, "#IF1 |a| equalto 1 n\n#ENDIF2", {}),
    ("block-unopened", 1, "#ENDLOOP1", {}),
    ("label-reuse", 2, "#IF1 |a| equalto 1 n\n#IF1 |a| equalto 1 n\n#ENDIF1\n#ENDIF1", {}),
    ("block-crosses-file", 2, "#IF1 |a| equalto 1 n\n#FILE end.txt", {"end.txt": "#ENDIF1"}),
    ("if-syntax", 1, "#IF1 |a| equalto 1\n#ENDIF1", {}),
    ("if-operator", 1, "#IF1 |a| = 1 n\n#ENDIF1", {}),
    ("if-type", 1, "#IF1 |a| equalto 1 text\n#ENDIF1", {}),
    ("type-odd", 1, "#IF1 |a| equalto 1 never\n#ENDIF1", {}),
    ("not-numeric", 1, "#IF1 Steel equalto 1 n\n#ENDIF1", {}),
    ("alpha-case", 1, "#IF1 steel equalto Steel a\n#ENDIF1", {}),
    ("alpha-number", 1, "#IF1 9 greaterthan 10 a\n#ENDIF1", {}),
    ("or-double", 4, "#IF1 |A| equalto 1 n\nM8\n#ENDIF1\n#IF1 |B| equalto 1 n\nM8\n#ENDIF1", {}),
    ("loop-syntax", 1, "#LOOP1 |z| 2\n#ENDLOOP1", {}),
    ("loop-var-literal", 1, "#LOOP1 Z 2 c\n#ENDLOOP1", {}),
    ("loop-var-twice", 1, "#LOOP1 |z| 2 c |z| 1 r\n#ENDLOOP1", {}),
    ("loop-step-type", 1, "#LOOP1 |z| 2 x\n#ENDLOOP1", {}),
    ("loop-step-zero", 1, "#LOOP1 |z| 0 c\n#ENDLOOP1", {}),
    ("loop-step-negative", 1, "#LOOP1 |z| -2 c\n#ENDLOOP1", {}),
    ("loop-var-shadow", 2, "#LOOP1 |z| 2 c\n#LOOP2 |z| 1 c\nZ|z|\n#ENDLOOP2\n#ENDLOOP1", {}),
    ("loop-var-unused", 1, "#LOOP1 |z| 2 c\nG0\n#ENDLOOP1", {}),
    ("unterminated-variable", 1, "G0 X|a", {}),
    ("empty-variable-name", 1, "G0 X||", {}),
    ("file-missing", 1, "#FILE nothere.txt", {}),
    ("file-name-empty", 1, "#FILE", {}),
    ("file-variable", 1, "#FILE |s|", {}),
    ("file-outside", 1, "#FILE ..\\x.txt", {}),
    ("file-case", 1, "#FILE DRILL.TXT", {"drill.txt": "G0"}),
    ("snippet-cycle", 1, "#FILE a.txt", {"a.txt": "#FILE a.txt"}),
    ("directive-not-first", 1, "G0 X1 #FILE a.txt", {}),
    ("non-ascii", 1, "G0 X1°", {}),
]


@pytest.mark.parametrize(("rule", "line", "program", "files"), TRIGGERS, ids=[each[0] for each in TRIGGERS])
def test_each_trigger_gives_its_rule_and_no_other(rule: str, line: int, program: str, files: Mapping[str, str]) -> None:
    assert said(program, files) == [f"{rule} {line}"]
    assert said(program.replace("\n", "\r\n") + "\r\n", files) == [f"{rule} {line}"]


IF, END = "#IF1 |a| equalto 1 n", "#ENDIF1"

# The worked examples of the reference, §8.
WORKED = [
    ("#LOOP1 |Depth| 5 c\nG1 Z-|Depth|\n#ENDLOOP1", {}),
    ("#LOOP1 |Depth| 5 r\nG1 Z-|Depth|\n#ENDLOOP1\n(total |Depth|)", {}),
    ("#LOOP1 |D| 5 c\nZ|D|\n#ENDLOOP1", {}),
    ("#LOOP1 |D| 3.5 r\nZ|D|\n#ENDLOOP1", {}),
    ("#LOOP1 |Z| 2 c\nG1 Z|Z|\n#ENDLOOP1", {}),
    ("#LOOP1 |X| 5 c |Z| 1 r\nG1 X|X| Z|Z|\n#ENDLOOP1", {}),
    ("#LOOP1 |Y| 10 c\nG0 Y|Y|\n#LOOP2 |Z| 2 c\nG1 Z|Z|\n#ENDLOOP2\nG0 Z5\n#ENDLOOP1", {}),
    ("#IF1 |Dia| greaterthan 0.5 n\n#IF2 |Mat| EqualTo Steel a\nS800 (|Mat| |Dia|)\n#ENDIF2\n#ENDIF1", {}),
    ("G0 Z5\n#FILE peck.txt\nM9", {"peck.txt": "#LOOP1 |Z| 2 c\nG1 Z|Z|\n#ENDLOOP1"}),
    ("#3=6 G1 X#3", {}),
]


@pytest.mark.parametrize(("program", "files"), WORKED)
def test_the_worked_examples_are_clean(program: str, files: Mapping[str, str]) -> None:
    assert said(program, files) == []


def test_the_or_of_two_conditions_is_legal() -> None:
    (finding,) = found("#IF1 |A| equalto 1 n\nM8\n#ENDIF1\n#IF1 |B| equalto 1 n\nM8\n#ENDIF1")
    assert (finding.rule, finding.severity.word) == ("metagcode.or-double", "info")


@pytest.mark.parametrize(
    ("line", "rules"),
    [
        ("#IF1 |a| = 1 text", ["if-operator", "if-type"]),
        ("#IF |a| = 1 text", ["label-missing", "if-operator", "if-type"]),
        ("#IF1 Steel = Iron never", ["not-numeric", "if-operator", "not-numeric", "type-odd"]),
        ("#IF1 || = 1 n", ["empty-variable-name", "if-operator"]),
        ("#IF -1", ["label-missing", "if-syntax"]),
        ("#IF-1", ["label-missing"]),
        ("#IF 1 |a| equalto 1 n", ["label-missing"]),
        ("#IF1 |a equalto 1 n°", ["unterminated-variable"]),
        ("#IF1 Mild Steel equalto x a", ["if-syntax"]),
    ],
)
def test_all_faults_of_a_condition_are_reported(line: str, rules: list[str]) -> None:
    assert said(f"{line}\n#ENDIF1") == [f"{rule} 1" for rule in rules]


@pytest.mark.parametrize(
    ("line", "rules"),
    [
        ("#LOOP1 Z 0 x", ["loop-var-literal", "loop-step-zero", "loop-step-type"]),
        ("#LOOP1 |z| two c |z| -1 r1", ["not-numeric", "loop-var-twice", "loop-step-negative", "loop-step-type"]),
        ("#LOOP |z| 1e3 c", ["label-missing", "not-numeric"]),
        ("#LOOP 1 |z| 2 c", ["label-missing"]),
        ("#LOOP1 |z| -0.0 c", ["loop-step-zero"]),
        ("#LOOP1 |z| |m| c", []),
    ],
)
def test_all_faults_of_a_loop_header_are_reported(line: str, rules: list[str]) -> None:
    assert said(f"{line}\n#ENDLOOP1") == [f"{rule} 1" for rule in rules]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("#IF1 |a| equalto 1 n\n#LOOP2 |z| 1 c\nZ|z|\n#ENDLOOP2\n#ENDIF1", []),
        ("#IF1 |a| equalto 1 n\n#ENDIF01", ["block-mismatch 2"]),
        ("#IF1 |a| equalto 1 n\n#ENDLOOP1", ["block-mismatch 2"]),
        ("#IF1 |a| equalto 1 n\n#ENDIF", ["label-missing 2"]),
        ("#IF1 |a| equalto 1 n\n#IF2 |a| equalto 1 n\n#ENDIF1\n#ENDIF2", ["block-mismatch 3"]),
        ("#IF1 |a| equalto 1 n\n#LOOP1 |z| 1 c\nZ|z|\n#ENDLOOP1\n#ENDIF1", []),
        ("#LOOP1 |z| 1 c\n#IF2 |z| equalto 1 n\n#ENDLOOP1", ["block-unclosed 2"]),
        ("#ENDIF1\n#IF1 |a| equalto 1 n\n", ["block-unopened 1", "block-unclosed 2"]),
    ],
)
def test_blocks_of_one_file(program: str, expected: list[str]) -> None:
    assert said(program) == expected


def written(words: str) -> str:
    """Blocks in short: `L1` and `I1` open, `l1` and `i1` close."""
    lines = {"L": "#LOOP{} |{}| 1 c\nZ|{}|", "I": "#IF{} |a| equalto {} n", "l": "#ENDLOOP{}", "i": "#ENDIF{}"}
    return "\n".join(lines[word[0]].replace("{}", word[1:]) for word in words.split())


@pytest.mark.parametrize(
    ("blocks", "expected"),
    [
        # An end too few, however deep it stands: the blocks around it are not blamed for it.
        ("L1 L2 I1 l2 l1", ["block-unclosed 5"]),
        ("L1 I1 I2 i1 l1 L1 l1", ["block-unclosed 4"]),
        ("I1 I2 I3 i1", ["block-unclosed 2", "block-unclosed 3"]),
        # An end too many.
        ("L1 L2 I1 i1 i1 l2 l1", ["block-unopened 7"]),
        ("I1 l7 i1", ["block-unopened 2"]),
        # A number or a word that is wrong.
        ("L1 L2 I1 i9 l2 l1", ["block-mismatch 6"]),
        ("L1 I1 l1 l1", ["block-mismatch 4"]),
        ("L1 I9 i1 l1 I1 i1", ["block-mismatch 4"]),
        # Blocks that overlap.
        ("L1 L2 l1 l2", ["block-mismatch 5"]),
        ("I5 L1 I1 l1 i1 i5", ["block-mismatch 5"]),
        # Two mistakes are two findings.
        ("I1 i2 I3 i4", ["block-mismatch 2", "block-mismatch 4"]),
        ("i1 I1 i1 I2", ["block-unopened 1", "block-unclosed 4"]),
    ],
)
def test_one_mistake_in_the_ends_is_one_finding(blocks: str, expected: list[str]) -> None:
    assert said(written(blocks)) == expected


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (f"{IF}\n#ENDFI1", ["unknown-directive 2"]),
        (f"{IF}\n#END1", ["unknown-directive 2"]),
        ("#LOOP1 |z| 1 c\nZ|z|\n#END1", ["unknown-directive 3"]),
        ("#LOPP1 |z| 1 c\nZ|z|\n#ENDLOOP1", ["unknown-directive 1"]),
        (f"{IF}\n#IFF2 |b| equalto 1 n\n#ENDIF2\n#ENDIF1", ["unknown-directive 2"]),
        (f"{IF}\n#ENDFI1\n{IF}\n#ENDIF1", ["unknown-directive 2"]),
        # What resembles none of ours opens and closes nothing.
        ("#FOR1 |z|\n#ENDFOR1", ["unknown-directive 1", "unknown-directive 2"]),
        (f"{IF}\n#ELSE1\n#ENDIF1", ["unknown-directive 2"]),
        (f"{IF}\n#STOP1", ["block-unclosed 1", "unknown-directive 2"]),
        # What it may have been to do is not missed either.
        ("#LOOP1 |z| 1 c\n#FLIE peck.txt\n#ENDLOOP1", ["unknown-directive 2"]),
    ],
)
def test_a_misspelt_directive_is_taken_for_what_was_meant(program: str, expected: list[str]) -> None:
    assert said(program) == expected


def test_a_misspelt_end_in_a_snippet_is_said_there() -> None:
    files = {"a.txt": f"{IF}\nG0\n#ENDFI1\n"}
    assert said("#FILE a.txt", files) == []
    assert said(files["a.txt"], files, file="Snippets/a.txt") == ["unknown-directive 3"]


@pytest.mark.parametrize(
    ("program", "files", "hint"),
    [
        (f"{IF}\n#ENDIF2", {}, "write `#ENDIF1`"),
        (written("L1 I2 l1 i2"), {}, "so `#ENDIF2` must come first"),
        (written("L1 I2 l1"), {}, "`#ENDIF2` is missing before `#ENDLOOP1`"),
        ("#ENDLOP7", {}, "did you mean `#ENDLOOP7`?"),
        ("#FILES a", {}, "did you mean `#FILE`?"),
        ("#WHILE1", {}, "repeat lines with `#LOOP`"),
        ("#XYZ", {}, "there are `#FILE`, `#IF`"),
        ("#IF1 |a| lesthan 1 n\n#ENDIF1", {}, "did you mean `lessthan`?"),
        ("#IF1 |a| <> 1 n\n#ENDIF1", {}, "did you mean `notequalto`?"),
        ("#IF1 |a| <= 1 n\n#ENDIF1", {}, "with `lessthan` and in one with `equalto`"),
        ("#IF1 |a| 1 equalto n\n#ENDIF1", {}, "`equalto` belongs between the two values"),
        ("#IF1 |a| not equal to 1 n\n#ENDIF1", {}, "write `notequalto`"),
        ("#IF1 |a| equalto 1 n or |b| equalto 1 n\n#ENDIF1", {}, "for an or write"),
        ("#IF1 |a| equalto 1 a a\n#ENDIF1", {}, "the items are a value, an operator, a second value, a type"),
        ("#IF1 |a| equalto 1\n#ENDIF1", {}, "a type (`a` for text, `n` for numbers)"),
        ("#IF1 1.5mm lessthan 2 n\n#ENDIF1", {}, "did you mean `1.5`?"),
        ("#IF1 x1 lessthan 2 n\n#ENDIF1", {}, "write `a` for the type"),
        ("#LOOP1 |z| 1e-3 c\nZ|z|\n#ENDLOOP1", {}, "write `0.001`"),
        ("#LOOP1 |z| 1e999999999 c\nZ|z|\n#ENDLOOP1", {}, "nothing to calculate with"),
        ("#LOOP1 |z| rel |max|\nZ|z|\n#ENDLOOP1", {}, "write `|max| rel`"),
        ("#LOOP1 |z| 1 c\nZ|Z|\n#ENDLOOP1", {}, "did you mean `Z`?"),
        ("#FILE Drlil.txt", {"drill.txt": ""}, "did you mean `drill.txt`?"),
        ("#FILE b", {"b.txt": "", "a.txt": ""}, "no extension is added, write `b.txt`"),
        ("#FILE mill/b", {"mill/b.txt": ""}, "write `mill/b.txt`"),
        ("#FILE b.txt", {"mill/b.txt": ""}, "did you mean `mill/b.txt`?"),
        ("#FILE Snippets/mill\\b.txt", {"mill/b.txt": ""}, "did you mean `mill/b.txt`?"),
        ("#FILE b.txt", {}, "set `snippets-dir`"),
        ("#FILE C:\\x\\b.txt", {}, "write `b.txt`"),
        ("#FILE ..", {}, "name a file in it"),
        (
            "#FILE a",
            {"a": "#FILE b", "b": "#FILE c", "c": "#FILE b"},
            "leads to `b`, which includes itself by way of `c`",
        ),
        ("#FILE a", {"a": "#FILE a"}, "leads to `a`, which includes itself; this"),
    ],
)
def test_messages_say_how_to_mend_it(program: str, files: Mapping[str, str], hint: str) -> None:
    (finding,) = found(program, files)
    assert hint in finding.message, finding.message


def nested(depth: int) -> str:
    opened = "".join(f"#IF{at} |a| equalto {at} n\n" for at in range(depth))
    return opened + "".join(f"#ENDIF{at}\n" for at in reversed(range(depth)))


def test_two_hundred_blocks_deep_is_legal_and_one_more_is_not() -> None:
    assert said(nested(200)) == []
    assert said(nested(201)) == ["limit 201"]
    assert said(nested(5000)) == ["limit 201"]
    files = {"in.txt": nested(100)}
    assert said(nested(100).replace("#ENDIF99\n", "#FILE in.txt\n#ENDIF99\n"), files) == []
    assert said(nested(101).replace("#ENDIF100\n", "#FILE in.txt\n#ENDIF100\n"), files) == ["limit 102"]


def test_a_million_lines_with_all_snippets_are_legal_and_one_more_is_not() -> None:
    million = {f"{at}": f"#FILE {at + 1}\n" * 10 for at in range(1, 6)} | {"6": "G0\n" * 10}
    assert said("#FILE 1\n", million) == []
    assert said("#FILE 1\nG0", million) == ["limit 1"]
    assert said("G0\n#FILE 1\n", million) == ["limit 2"]


def test_a_million_lines_of_its_own_are_legal_and_one_more_is_not() -> None:
    assert said("\n" * LINES) == []
    assert said("\n" * LINES + "G0") == [f"limit {LINES + 1}"]


def test_a_snippet_of_one_mebibyte_is_legal_and_one_byte_more_is_not() -> None:
    assert said("#FILE a", {"a": "x" * (1 << 20)}) == []
    assert said("#FILE a", {"a": "é" * (1 << 19)}) == []
    assert said("#FILE a", {"a": "x" * (1 << 20) + "x"}) == ["limit 1"]
    assert said("#FILE a", {"a": "é" * (1 << 19) + "x"}) == ["limit 1"]


def test_snippets_that_open_and_close_without_end_are_counted_not_unrolled() -> None:
    doubling = {f"{at}": f"#FILE {at + 1}\n" * 2 for at in range(1, 20)}
    assert said("#FILE 1", {**doubling, "20": IF}) == ["limit 1"]
    assert said("#FILE 1", {**doubling, "20": END}) == ["block-unopened 1"]
    assert said("#FILE 1", {**doubling, "20": "G0\nG1\n"}) == ["limit 1"]


@pytest.mark.parametrize(
    ("program", "files", "expected"),
    [
        ("#LOOP1 |z| 1 c\n#FILE a\n#ENDLOOP1", {"a": "#FILE b", "b": "G0 Z|z|"}, []),
        ("#LOOP1 |z| 1 c\n#FILE a\n#ENDLOOP1", {"a": "#FILE b", "b": "G0 Z|Z|"}, ["loop-var-unused 1"]),
        ("#LOOP1 |z| 1 c\n#FILE a\n#ENDLOOP1", {"a": "#FILE gone"}, []),
        ("#LOOP1 |z| 1 c\n#IF1 |z| equalto 1 n\nM1\n#ENDIF1\n#ENDLOOP1", {}, []),
        ("#LOOP1 |z| 1 c\n#LOOP2 |y| |z| c\nY|y|\n#ENDLOOP2\n#ENDLOOP1", {}, []),
        ("#LOOP1 |z| 1 c\n(| z |)\n#ENDLOOP1", {}, []),
        ("Z|z|\n#LOOP1 |z| 1 c\nG0\n#ENDLOOP1\nZ|z|", {}, ["loop-var-unused 2"]),
        ("#LOOP1 |z| 1 c\n\n#ENDLOOP1", {}, []),
        ("#LOOP1 |z| 1 c\nG0\n#FILE e", {"e": "#ENDLOOP1"}, ["block-crosses-file 3"]),
    ],
)
def test_whether_a_loop_variable_is_used(program: str, files: Mapping[str, str], expected: list[str]) -> None:
    assert said(program, files) == expected


def test_a_use_far_down_a_long_loop_is_found() -> None:
    filler = "G1 X1.2345 Y2.3456 F|feed|\n" * 4000
    assert said(f"#LOOP1 |z| 1 c\n{filler}Z|z|\n{filler}#ENDLOOP1\n") == []
    assert said(f"Z|z|\n#LOOP1 |z| 1 c\n{filler}#ENDLOOP1\nZ|z|\n{filler}") == ["loop-var-unused 2"]


@pytest.mark.parametrize(
    ("program", "files", "expected"),
    [
        (
            "#LOOP1 |z| 1 c\n#IF1 |a| equalto 1 n\n#LOOP2 |y| 1 c | z | 2 c\nZ|z|Y|y|\n#ENDLOOP2\n#ENDIF1\n#ENDLOOP1",
            {},
            ["loop-var-shadow 3"],
        ),
        ("#LOOP1 |z| 1 c\n#LOOP2 |Z| 1 c\nZ|z|Y|Z|\n#ENDLOOP2\n#ENDLOOP1", {}, []),
        (
            "#LOOP1 |z| 1 c\nZ|z|\n#FILE a\n#ENDLOOP1",
            {"a": "#FILE b", "b": "#LOOP1 |z| 1 c\nZ|z|\n#ENDLOOP1"},
            ["loop-var-shadow 3"],
        ),
        (
            "#FILE a\n#LOOP2 |z| 1 c\nZ|z|\n#ENDLOOP2\n#ENDLOOP1",
            {"a": "#LOOP1 |z| 1 c"},
            ["block-crosses-file 1", "loop-var-shadow 2"],
        ),
        ("#LOOP1 |z| 1 c\nZ|z|\n#ENDLOOP1\n#FILE a", {"a": "#LOOP1 |z| 1 c\nZ|z|\n#ENDLOOP1"}, []),
    ],
)
def test_loops_over_the_variable_of_a_loop_around(program: str, files: Mapping[str, str], expected: list[str]) -> None:
    assert said(program, files) == expected


@pytest.mark.parametrize(
    ("one", "two", "doubled"),
    [
        ("|a| equalto 1 n", "|b| equalto 1 n", True),
        ("|a| equalto 1 n", "|a| equalto 2 n", False),
        ("|a| equalto 1 n", "|a| equalto 1.0 n", True),
        ("|a| equalto x a", "|a| equalto X a", False),
        ("|a| equalto 1 n", "|a| notequalto 1 n", False),
        ("|a| notequalto 1 n", "|a| notequalto 2 n", True),
        ("|a| LessThan 5 n", "|a| GreaterThan 5 num", False),
        ("|a| lessthan 6 n", "|a| greaterthan 5 n", True),
        ("|a| equalto 5 n", "|a| greaterthan 5 n", False),
        ("|a| equalto 6 n", "|a| greaterthan 5 n", True),
        ("|a| lessthan 5 n", "|a| equalto 5 n", False),
        ("|a| lessthan 5 n", "|a| equalto 4 n", True),
        ("|a| lessthan 5 n", "|a| lessthan 6 n", True),
        ("|a| equalto 1 n", "|a| equalto 2 a", True),
        ("|a| equalto |b| n", "|a| equalto |c| n", True),
    ],
)
def test_conditions_that_exclude_each_other_double_nothing(one: str, two: str, doubled: bool) -> None:
    program = f"#IF1 {one}\n  M8\n#ENDIF1\n\n#IF2 {two}\nM8\n#ENDIF2"
    assert said(program) == (["or-double 5"] if doubled else [])


@pytest.mark.parametrize(
    "program",
    [
        f"{IF}\nM8\n{END}\nM9\n#IF2 |b| equalto 1 n\nM8\n#ENDIF2",
        f"{IF}\nM8\n{END}\n#IF2 |b| equalto 1 n\nM9\n#ENDIF2",
        f"{IF}\nM8\n{END}\n#IF2 |b| equalto 1 n\nM8\nM8\n#ENDIF2",
        f"{IF}\n\n{END}\n#IF2 |b| equalto 1 n\n\n#ENDIF2",
        f"{IF}\nM8\n#IF2 |b| equalto 1 n\nM8\n#ENDIF2\n{END}",
    ],
)
def test_bodies_that_differ_or_are_apart_double_nothing(program: str) -> None:
    assert said(program) == []


@pytest.mark.parametrize(
    "path", sorted(path for path in EXAMPLES.rglob("*") if path.is_file()), ids=lambda path: path.name
)
def test_the_examples_are_clean(path: Path) -> None:
    files = {str(each.relative_to(EXAMPLES)): each.read_text("utf-8") for each in EXAMPLES.rglob("*") if each.is_file()}
    assert found(path.read_text("utf-8"), file=str(path.relative_to(EXAMPLES)), host=MemoryHost(files)) == []
