"""Every trigger of spec/metagcode.md §6 that a text decides, as it stands there, and what snippet files do to a program."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.host import Host, NoFiles
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.dialects.metagcode.limits import LINES
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("metagcode")
RULES = RuleSet(DIALECT)
EXAMPLES = Path(__file__).parents[2] / "examples" / "metagcode"


def found(
    program: str,
    files: Mapping[str, str] | None = None,
    file: str = "main.mgc",
    host: Host | None = None,
    **settings: str,
) -> list[Finding]:
    """All findings. Files are named relative to the folder of snippets."""
    host = host or MemoryHost({f"Snippets/{name}": text for name, text in (files or {}).items()})
    rules = RuleSet(DIALECT, settings) if settings else RULES
    return Analysis(Document.parse(program, DIALECT), rules, file, host).findings()


def said(program: str, files: Mapping[str, str] | None = None, **more: str) -> list[str]:
    """The rules that speak and their lines, counted from 1: `block-unclosed 3`."""
    return [f"{each.rule.removeprefix('metagcode.')} {each.place.line + 1}" for each in found(program, files, **more)]


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


IF_A = "#IF1 |a| equalto 1 n"

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
        (f"{IF_A}\n#ENDFI1", ["unknown-directive 2"]),
        (f"{IF_A}\n#END1", ["unknown-directive 2"]),
        ("#LOOP1 |z| 1 c\nZ|z|\n#END1", ["unknown-directive 3"]),
        ("#LOPP1 |z| 1 c\nZ|z|\n#ENDLOOP1", ["unknown-directive 1"]),
        (f"{IF_A}\n#IFF2 |b| equalto 1 n\n#ENDIF2\n#ENDIF1", ["unknown-directive 2"]),
        (f"{IF_A}\n#ENDFI1\n{IF_A}\n#ENDIF1", ["unknown-directive 2"]),
        # What resembles none of ours opens and closes nothing.
        ("#FOR1 |z|\n#ENDFOR1", ["unknown-directive 1", "unknown-directive 2"]),
        (f"{IF_A}\n#ELSE1\n#ENDIF1", ["unknown-directive 2"]),
        (f"{IF_A}\n#STOP1", ["block-unclosed 1", "unknown-directive 2"]),
        # What it may have been to do is not missed either.
        ("#LOOP1 |z| 1 c\n#FLIE peck.txt\n#ENDLOOP1", ["unknown-directive 2"]),
    ],
)
def test_a_misspelt_directive_is_taken_for_what_was_meant(program: str, expected: list[str]) -> None:
    assert said(program) == expected


def test_a_misspelt_end_in_a_snippet_is_said_there() -> None:
    files = {"a.txt": f"{IF_A}\nG0\n#ENDFI1\n"}
    assert said("#FILE a.txt", files) == []
    assert said(files["a.txt"], files, file="Snippets/a.txt") == ["unknown-directive 3"]


@pytest.mark.parametrize(
    ("program", "files", "hint"),
    [
        (f"{IF_A}\n#ENDIF2", {}, "write `#ENDIF1`"),
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


IF, END = "#IF1 |a| equalto 1 n", "#ENDIF1"


@pytest.mark.parametrize(
    ("program", "files", "expected"),
    [
        (f"{IF}\n#FILE e\n", {"e": END}, ["block-crosses-file 2"]),
        (f"#FILE i\n{END}\n", {"i": IF}, ["block-crosses-file 1"]),
        ("#FILE i\n#FILE e\n", {"i": IF, "e": END}, ["block-crosses-file 2"]),
        (f"{IF}\n#FILE e\n#FILE i\n{END}", {"i": IF, "e": END}, ["block-crosses-file 2", "block-crosses-file 3"]),
        (f"{IF}\n#FILE ei\n{END}", {"ei": f"{END}\n{IF}"}, ["block-crosses-file 2"] * 2),
        (f"{IF}\n#FILE outer\n", {"outer": "#FILE e", "e": END}, ["block-crosses-file 2"]),
        # Opened and closed in snippets of one snippet: nothing of it is seen from outside.
        ("#FILE both\n", {"both": "#FILE i\n#FILE e", "i": IF, "e": END}, []),
        (f"{IF}\n#FILE e\n", {"e": "#ENDIF2"}, ["block-mismatch 2"]),
        (f"{IF}\n#FILE e\n", {"e": "#ENDLOOP1"}, ["block-mismatch 2"]),
        (f"{IF}\n#FILE e\n{END}", {"e": END}, ["block-crosses-file 2", "block-unopened 3"]),
        ("#FILE e\n", {"e": END}, ["block-unopened 1"]),
        ("#FILE i\n", {"i": IF}, ["block-unclosed 1"]),
        (f"{IF}\n#FILE i\n{END}", {"i": IF}, ["block-unclosed 1", "block-crosses-file 2"]),
        (f"{IF}\n#FILE i\n{END}", {"i": f"{IF}\n{END}"}, []),
    ],
)
def test_blocks_across_files(program: str, files: Mapping[str, str], expected: list[str]) -> None:
    assert sorted(said(program, files)) == sorted(expected)


def test_a_block_across_files_shows_both_ends() -> None:
    (finding,) = found(f"{IF}\nG0\n #FILE e.txt", {"e.txt": f"G0\n  {END}\n"})
    assert (finding.place.line, finding.place.col, finding.place.end_col) == (2, 1, 12)
    ends = [(each.place.file, each.place.line, each.place.col) for each in finding.related]
    assert ends == [("main.mgc", 0, 0), ("Snippets/e.txt", 1, 2)]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (f"{IF}\nG0\n", ["file-missing 3"]),
        (f"G0\n{END}\n", ["file-missing 3", "block-unopened 2"]),
    ],
)
def test_what_a_missing_snippet_may_hold_is_not_known(program: str, expected: list[str]) -> None:
    assert sorted(said(f"{program}#FILE gone.txt\n")) == sorted(expected)
    assert said(f"#FILE gone.txt\n{END}\n") == ["file-missing 1"]
    assert said(f"{IF}\n#FILE gone.txt\n#ENDIF2\n") == ["file-missing 2"]
    assert said(f"#FILE gone.txt\n{IF}\n#ENDIF2\n#FILE gone.txt\n") == [
        "file-missing 1",
        "block-mismatch 3",
        "file-missing 4",
    ]


@pytest.mark.parametrize("host", [NoFiles(), None])
def test_text_without_a_place_misses_no_file(host: Host | None) -> None:
    analysis = Analysis(Document.parse(f"{IF}\n#FILE a.txt\n#ENDLOOP1\n#FILE |s|", DIALECT), RULES, "", host)
    assert [finding.rule for finding in analysis.findings()] == ["metagcode.file-variable"]


SNIPPETS = {
    "a.txt": "#FILE b.txt\n",
    "b.txt": "G0\n",
    "mill/c.txt": "#FILE b.txt\n#FILE mill\\d.txt\n",
    "mill/d.txt": "G1\n",
}


@pytest.mark.parametrize("folder", ["", "/home/me/parts/", "C:/parts/", "a/Snippets/b/"])
def test_a_snippet_finds_the_others_from_where_it_lies(folder: str) -> None:
    host = MemoryHost({f"{folder}Snippets/{name}": text for name, text in SNIPPETS.items()})
    for name, text in SNIPPETS.items():
        assert found(text, file=f"{folder}Snippets/{name}", host=host) == []
    assert found("#FILE mill/c.txt\n#FILE a.txt", file=f"{folder}main.mgc", host=host) == []


@pytest.mark.parametrize("setting", ["parts", "./parts/", "../x/parts", "/x/parts"])
def test_the_folder_of_snippets_is_a_setting(setting: str) -> None:
    host = MemoryHost({"/x/parts/a.txt": "#FILE b.txt", "/x/parts/b.txt": END})
    settings = {"snippets-dir": setting}
    assert said(f"{IF}\n#FILE a.txt", file="/x/main.mgc", host=host, **settings) == ["block-crosses-file 2"]
    assert said("#FILE b.txt", file="/x/parts/a.txt", host=host, **settings) == ["block-crosses-file 1"]
    assert said(END, file="/x/parts/b.txt", host=host, **settings) == ["block-crosses-file 1"]


def test_a_snippet_by_itself_may_close_and_open_what_its_callers_do() -> None:
    for text in (END, IF, f"{END}\nG0\n{IF}", f"{END}\n{END}"):
        lines = [number for number, line in enumerate(text.split("\n"), 1) if line != "G0"]
        assert said(text, file="Snippets/part.txt") == [f"block-crosses-file {line}" for line in lines]
    assert said(f"{IF}\n#ENDIF2", file="Snippets/part.txt") == ["block-mismatch 2"]


def chain(length: int) -> dict[str, str]:
    """Snippets that name each other in a row: the first is at depth 1."""
    return {f"{at}": f"G0\n#FILE {at + 1}\n" if at < length else "G0\n" for at in range(1, length + 1)}


def test_twenty_snippets_deep_is_legal_and_one_more_is_not() -> None:
    assert found("#FILE 1", chain(20)) == []
    assert said("#FILE 2", chain(21)) == []
    (finding,) = found("G0\n#FILE 1", chain(21))
    assert (finding.rule, finding.place.line) == ("metagcode.snippet-depth", 1)
    assert [each.place.file for each in finding.related] == [f"Snippets/{at}" for at in range(1, 21)]
    assert {each.place.line for each in finding.related} == {1}


def test_depth_is_that_of_the_longest_chain_wherever_a_file_was_met_before() -> None:
    files = {**chain(20), "short": "#FILE 20\n#FILE 19\n", "long": "#FILE short\n#FILE 1\n"}
    assert said("#FILE 20\n#FILE short\n#FILE 1\n#FILE long", files) == ["snippet-depth 4"]


def test_a_chain_without_an_end_is_not_followed_to_it() -> None:
    host = Counting(chain(1000))
    assert [finding.rule for finding in found("#FILE 1", host=host)] == ["metagcode.snippet-depth"]
    assert max(host.asked.values()) == 1
    assert len(host.asked) <= 60


class Counting(MemoryHost):
    """Counts how often each file is read."""

    def __init__(self, files: Mapping[str, str]) -> None:
        super().__init__({f"Snippets/{name}": text for name, text in files.items()})
        self.asked: dict[str, int] = {}

    def read(self, path: str) -> str | None:
        self.asked[path] = self.asked.get(path, 0) + 1
        return super().read(path)


def test_each_file_is_read_once_however_often_it_is_named() -> None:
    files = {f"{at}": f"#FILE {at + 1}\n" * 3 for at in range(1, 12)} | {"12": "G0\n"}
    host = Counting(files)
    assert found("#FILE 1\n#FILE 3\n#FILE 1", host=host) == []
    assert sorted(host.asked.values()) == [1] * 12


@pytest.mark.parametrize(
    ("program", "files", "file", "links"),
    [
        ("#FILE a", {"a": "G0\n#FILE a"}, "main.mgc", [("Snippets/a", 1)]),
        (
            "#FILE a",
            {"a": "#FILE b", "b": "#FILE c", "c": "#FILE b"},
            "main.mgc",
            [("Snippets/a", 0), ("Snippets/b", 0), ("Snippets/c", 0)],
        ),
        (
            "#FILE a",
            {"a": "#FILE b\n#FILE A", "b": "G0", "A": "#FILE a"},
            "main.mgc",
            [("Snippets/a", 1), ("Snippets/A", 0)],
        ),
        ("#FILE a", {"a": "#FILE a"}, "Snippets/a", []),
        ("#FILE b", {"a": "#FILE b", "b": "#FILE a"}, "Snippets/a", [("Snippets/b", 0), ("Snippets/a", 0)]),
    ],
)
def test_circles_are_shown_from_where_they_begin(
    program: str, files: Mapping[str, str], file: str, links: list[tuple[str, int]]
) -> None:
    (finding,) = found(program, files, file)
    assert finding.rule == "metagcode.snippet-cycle"
    assert [(each.place.file, each.place.line) for each in finding.related] == links


@pytest.mark.parametrize(
    ("name", "files", "expected"),
    [
        ("a.txt", ["a.txt", "A.TXT"], []),
        ("A.txt", ["a.txt", "A.TXT"], ["file-missing 1"]),
        ("Sub/A.txt", ["sub/a.txt"], ["file-case 1"]),
        ("sub\\a.txt", ["sub/a.txt"], []),
        ("./sub//a.txt", ["sub/a.txt"], []),
        ("sub", ["sub/a.txt"], ["file-missing 1"]),
        ("a", ["a.txt"], ["file-missing 1"]),
        ("a b.txt  ", ["a b.txt"], []),
        ("a.txt extra", ["a.txt"], ["file-missing 1"]),
        ("sub/..\\a.txt", ["a.txt"], ["file-outside 1"]),
        ("...txt", ["...txt"], []),
        ("\\a.txt", ["a.txt"], ["file-outside 1"]),
        ("c:a.txt", ["a.txt"], ["file-outside 1"]),
        ("../|a|", ["a.txt"], ["file-variable 1"]),
        ("a\0.txt", ["a.txt"], ["file-missing 1"]),
        (".", ["a.txt"], ["file-missing 1"]),
    ],
)
def test_names_of_snippets(name: str, files: list[str], expected: list[str]) -> None:
    assert said(f"#FILE {name}", dict.fromkeys(files, "G0\n")) == expected


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
