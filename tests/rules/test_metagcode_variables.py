"""The configured values of variables: what the file may hold, which lines are surely generated with them, and where a miss is said."""

from collections.abc import Mapping
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.formats.variables import read_values
from deburr.host import Host, NoFiles
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("metagcode")
VALUES = "Depth=6\nZero=0\nOne=1\nMat = Mild Steel\nWord=x\n"


def found(
    program: str,
    files: Mapping[str, str] | None = None,
    values: str = VALUES,
    host: Host | None = None,
    file: str = "/x/main.mgc",
    variables: str = "part.vars",
) -> list[Finding]:
    """All findings; snippets are named relative to their folder."""
    snippets = {f"/x/Snippets/{name}": text for name, text in (files or {}).items()}
    host = host or MemoryHost({**snippets, "/x/part.vars": values})
    rules = RuleSet(DIALECT, {"variables": variables})
    return Analysis(Document.parse(program, DIALECT), rules, file, host).findings()


def said(program: str, files: Mapping[str, str] | None = None, values: str = VALUES, **more: Any) -> list[str]:
    """The rules that speak and their lines, counted from 1."""
    return [
        f"{each.rule.removeprefix('metagcode.')} {each.place.line + 1}"
        for each in found(program, files, values, **more)
    ]


def block(opener: str) -> str:
    """A use without a value on the second line, in a block."""
    word = "LOOP" if "LOOP" in opener else "IF"
    return f"{opener}\nX|nope| Z|Depth||Zero|\n#END{word}1\n"


@pytest.mark.parametrize(
    ("condition", "judged"),
    [
        ("|One| equalto 1 n", True),
        ("|One| equalto 1.0 n", True),
        ("|One| equalto 1.0 a", False),
        ("|One| notequalto 1 n", False),
        ("|Depth| GreaterThan 5 n", True),
        ("|Depth| greaterthan 6 n", False),
        ("|Depth| lessthan 10 n", True),
        ("|Depth| lessthan 10 a", False),
        ("|Mat| equalto |Mat| a", True),
        ("yes equalto no a", False),
        # Nobody knows: an error of its own, or another rule's.
        ("|Word| greaterthan 1 n", False),
        ("|Depth| = 6 n", None),
        ("|Depth| greaterthan 5", None),
    ],
)
def test_only_conditions_that_hold_are_looked_into(condition: str, judged: bool | None) -> None:
    rules = said(block(f"#IF1 {condition}"))
    assert ("undefined-variable 2" in rules) is bool(judged)
    assert len(rules) == (1 if judged is not False else 0)


@pytest.mark.parametrize(
    ("header", "judged"),
    [
        ("|Depth| 2 c", True),
        ("|Zero| 2 c", False),
        ("|Zero| 2 c |Depth| |One| r", True),
        ("|Depth| |Zero| c", False),
        ("|Depth| |Word| c", False),
        ("|Mat| 2 c |Depth| 2 c", False),
    ],
)
def test_only_loops_with_a_pass_are_looked_into(header: str, judged: bool) -> None:
    assert ("undefined-variable 2" in said(block(f"#LOOP1 {header}"))) is judged


def test_a_name_without_a_value_leaves_its_block_open() -> None:
    assert said(block("#IF1 |nope| equalto 1 n")) == ["undefined-variable 1"]
    assert said(block("#LOOP1 |Depth| |nope| c")) == ["undefined-variable 1"]
    assert said("#IF1 yes equalto no a\n#LOOP1 |nope| 2 c\nZ|nope|\n#ENDLOOP1\n#ENDIF1\nX|no|") == [
        "undefined-variable 6"
    ]


def test_what_a_loop_counts_is_not_known_inside_it() -> None:
    program = "#LOOP1 |Depth| 2 c\n#IF1 |Depth| equalto 6 n\nX|nope|\n#ENDIF1\nZ|Depth|\n#ENDLOOP1\n"
    assert said(program) == []
    assert said(program + "#IF1 |Depth| equalto 6 n\nX|nope|\n#ENDIF1") == ["undefined-variable 8"]


@pytest.mark.parametrize(
    ("line", "count"),
    [
        ("G0 X|nope| Y|nope|", 2),
        ("(part |nope|) ; |nope|", 2),
        ("#IF1 |nope| equalto |nope| a\n#ENDIF1", 2),
        ("X| Depth |", 0),
        ("X|depth|", 1),
    ],
)
def test_each_use_is_marked(line: str, count: int) -> None:
    assert [each.rule for each in found(line)] == ["metagcode.undefined-variable"] * count


@pytest.mark.parametrize("line", ["X||", "X|nope| Y|", "#FILE |nope|", "#ENDIF1 |nope|", "#IFF1 |nope|"])
def test_what_other_rules_refuse_is_not_judged_too(line: str) -> None:
    assert "metagcode.undefined-variable" not in {each.rule for each in found(line)}


def test_a_snippet_is_judged_where_it_is_included() -> None:
    files = {"a.txt": "X|Depth|\n#FILE b.txt\nY|no|\nZ|no|", "b.txt": "  Y|nope|"}
    findings = found("#FILE b.txt\n#IF1 |Zero| equalto 1 n\n#FILE a.txt\n#ENDIF1\n  #FILE a.txt", files)
    places = [(each.place.line, each.place.col, each.place.end_col) for each in findings]
    assert places == [(0, 0, 11), (4, 2, 13), (4, 2, 13)]
    ends = [(each.related[0].place.file, each.related[0].place.line, each.related[0].place.col) for each in findings]
    assert ends == [("/x/Snippets/b.txt", 0, 3), ("/x/Snippets/b.txt", 0, 3), ("/x/Snippets/a.txt", 2, 1)]


def test_a_snippet_by_itself_is_not_judged() -> None:
    assert said("X|nope|", {"a.txt": "X|nope|"}, file="/x/Snippets/a.txt", variables="/x/part.vars") == []
    assert said("X|nope|", {"a.txt": "X|nope|"}, file="/x/Snippets/a.txt", variables="/x/gone.vars") == []


def test_a_block_may_begin_in_a_snippet() -> None:
    files = {"no.txt": "#IF1 |Zero| equalto 1 n", "yes.txt": "#IF1 |Zero| equalto 0 n"}
    assert said("#FILE no.txt\nX|nope|\n#ENDIF1", files) == ["block-crosses-file 1"]
    assert said("#FILE yes.txt\nX|nope|\n#ENDIF1", files) == ["block-crosses-file 1", "undefined-variable 2"]


def test_snippets_that_grow_without_end_are_left() -> None:
    files = {f"{at}": f"#FILE {at + 1}\n" * 3 for at in range(1, 20)} | {"20": "X|Depth|"}
    assert said("#FILE 1\nX|nope|", files) == ["limit 1"]
    assert said("#FILE a\nX|nope|", {"a": "#FILE a"}) == ["snippet-cycle 1", "undefined-variable 2"]


def test_nothing_is_known_without_files_and_nothing_asked_without_the_setting() -> None:
    assert found("X|nope|", host=NoFiles()) == []
    assert said("X|nope|", variables="") == []


@pytest.mark.parametrize("variables", ["part.vars", "./part.vars", "/x/part.vars", "../x/part.vars"])
def test_the_file_lies_beside_the_program_unless_its_path_is_absolute(variables: str) -> None:
    assert said("X|nope|", variables=variables) == ["undefined-variable 1"]


def test_a_file_that_cannot_be_read_is_said_once() -> None:
    (finding,) = found("\nX|nope| Y|no|", variables="gone.vars")
    assert (finding.rule, finding.place.line, finding.place.end_col) == ("metagcode.variables-file", 0, 1)
    assert "/x/gone.vars" in finding.message


@pytest.mark.parametrize(
    ("values", "why"),
    [
        ("a=1\n\nb", "line 3 of the file of values `part.vars` cannot be used: `b` has no `=`"),
        ("=5", "without a name"),
        ("a|b=5", "no name"),
        ("a=1\nb=2\na=3", "`a` has another value on line 1"),
        ('{"a": 1\n "b": 2}', "line 2"),
        ('{"a": [1]}', "`a` is neither"),
        ('{"a": true}', "`a` is neither"),
        ('{"a": NaN}', "`a` is neither"),
        ('{"a": {"b": 1}, "c|": 2}', ", and 1 more"),
        ("{" * 100_000, "JSON"),
    ],
)
def test_a_file_that_cannot_be_understood_is_said_once_and_misses_nothing(values: str, why: str) -> None:
    (finding,) = found("X|nope| Y|no|", values=values) if "another" not in why else found("X|b|", values=values)
    assert finding.rule == "metagcode.variables-file"
    assert why in finding.message
    assert finding.related[0].place.file == "/x/part.vars"


def test_values_are_texts_as_they_are_written() -> None:
    lines = read_values("\ufeffa=1.500\r\n; c=1\r# d=2\n\n  b c =\t= x  \na=1.500", "p.vars")
    assert {name: value.text for name, value in lines.known.items()} == {"a": "1.500", "b c": "= x"}
    assert lines.defects == ()
    json = read_values('{"a": 1.500, " b ": " x ",\n "c\\u0041": 12345678901234567890}', "p.vars")
    assert {name: value.text for name, value in json.known.items()} == {
        "a": "1.500",
        "b": " x ",
        "cA": "12345678901234567890",
    }
    assert [(value.line, *value.span) for value in json.known.values()] == [(0, 1, 4), (0, 13, 18), (1, 1, 10)]
    assert not read_values("a=1", "p.JSON").whole


def test_keys_of_inner_objects_and_texts_that_look_like_keys_are_no_places() -> None:
    text = '{"a": "\\"b\\": 1",\n "x": {"b": 1},\n "b": "2"}'
    read = read_values(text, "p.json")
    assert [(name, value.line) for name, value in read.known.items()] == [("a", 0), ("b", 2)]
    assert [defect.line for defect in read.defects] == [1]


@pytest.mark.parametrize(
    ("values", "rule"),
    [
        ("a=1|2\n", "value-has-bar"),
        ("a=|\n", "value-has-bar"),
        ('{"a": "1|"}', "value-has-bar"),
        ('{"a": "1\\n"}', "value-has-line-end"),
        ('{"a": "\\rM3"}', "value-has-line-end"),
    ],
)
def test_values_that_none_may_have(values: str, rule: str) -> None:
    assert said("G0\nG1\n", values=values) == [f"{rule} 1"]
    assert said("G0\nX1 (|a|) Y|a|\nZ|a|", values=values) == [f"{rule} 2"]
    assert said("G0\n#FILE s", {"s": "#FILE t", "t": "X|a|"}, values=values) == [f"{rule} 2"]
    (finding,) = found("G0\nX1 (|a|) Y|a|\nZ|a|", values=values)
    assert (finding.place.col, finding.place.end_col) == (4, 7)
    assert finding.related[0].place.file == "/x/part.vars"
    assert said("#IF1 |a| equalto 1 n\nX|nope|\n#ENDIF1", values=values) == [f"{rule} 1"]


def test_a_name_that_differs_in_case_only_is_offered_first() -> None:
    (finding,) = found("X|DEPTH|", values="Depth=1\nDEPT=2")
    assert finding.message.endswith("did you mean `Depth`?")
