"""What snippet files do to a MetaGCODE program: blocks across files, folders, chains, circles, names (spec/metagcode.md §5.1)."""

from collections.abc import Mapping

import pytest

from deburr.analysis import Analysis
from deburr.host import Host, NoFiles
from deburr_grammar.document import Document
from support.metagcode import DIALECT, RULES, found, said
from support.pages import MemoryHost

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
