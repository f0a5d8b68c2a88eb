"""Calls, files and parameters of rs274: what cannot be certain, and the words of messages."""

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.host import Host, NoFiles
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("rs274")
FOO = "o<foo> sub\nG0 X1\no<foo> endsub\n"


def findings(program: str, file: str = "p.ngc", host: Host | None = None, **settings: object) -> list[Finding]:
    document = Document.parse(program, DIALECT)
    found = Analysis(document, RuleSet(DIALECT, settings), file, host or MemoryHost({file: program})).findings()
    return [finding for finding in found if finding.rule != "rs274.program-end-missing"]


def check_said(found: list[Finding], *expected: tuple[str, str, int]) -> None:
    said = [(each.rule.removeprefix("rs274."), each.severity.word, each.place.line + 1) for each in found]
    assert said == list(expected)


def test_text_of_its_own_is_not_said_to_lack_files() -> None:
    check_said(findings("o<foo> call\nM2\n", "", NoFiles()))
    check_said(findings("o<foo> call\nM2\n", "untitled", MemoryHost({})))


def test_text_of_its_own_still_has_its_subs() -> None:
    check_said(findings("o1 call\no1 sub\no1 endsub\nM2\n", "", NoFiles()), ("sub-before-definition", "error", 1))


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        ({}, [("sub-unknown", "warning", 1)]),
        ({"subroutine-path": ["lib"]}, []),
        ({"subroutine-path": ["other"]}, [("sub-unknown", "error", 1)]),
    ],
)
def test_files_in_a_folder_nearby(settings: dict[str, object], expected: list[tuple[str, str, int]]) -> None:
    program = "o<foo> call\nM2\n"
    host = MemoryHost({"/shop/p.ngc": program, "/shop/lib/foo.ngc": FOO})
    check_said(findings(program, "/shop/p.ngc", host, **settings), *expected)


def test_the_program_folder_comes_before_the_path() -> None:
    program = "o<foo> call\nM2\n"
    host = MemoryHost({"/a/p.ngc": program, "/a/foo.ngc": FOO, "/b/foo.ngc": "o<bar> sub\no<bar> endsub\n"})
    check_said(findings(program, "/a/p.ngc", host, **{"subroutine-path": ["/b"]}))
    host = MemoryHost({"/a/p.ngc": program, "/b/foo.ngc": FOO, "/c/foo.ngc": "o<bar> sub\no<bar> endsub\n"})
    check_said(findings(program, "/a/p.ngc", host, **{"subroutine-path": ["/b", "/c"]}))


def test_in_a_library_the_caller_may_have_what_is_missing() -> None:
    library = "o<foo> sub\no<bar> call\nG0 X#<_feed> Y#<given> Z#70\no<foo> endsub\n"
    found = findings(library, "foo.ngc")
    check_said(found, ("sub-unknown", "warning", 2), ("named-undefined", "warning", 3))
    assert "unless the program that calls it defines one" in found[0].message


def test_a_helper_above_the_sub_for_which_a_library_is_called() -> None:
    library = "o<bar> sub\nG0 Y1\no<bar> endsub\no<foo> sub\no<bar> call\no<foo> endsub\n"
    check_said(findings(library, "foo.ngc"), ("sub-unknown", "warning", 5))
    check_said(findings(library, "tools.ngc"))


def test_faults_of_a_called_file_are_shown_at_its_first_call() -> None:
    program = "o<foo> call\no<foo> call\nM2\n"
    host = MemoryHost({"p.ngc": program, "foo.ngc": "o<foo> sub\no<bar> call\no<foo> endsub\n", "bar.ngc": "G0 X1\n"})
    found = findings(program, host=host)
    check_said(found, ("sub-file", "error", 1))
    assert found[0].message.startswith("the control stops in `foo.ngc`, line 2: `bar.ngc` has no `o<bar> sub`")
    assert [(each.place.file, each.place.line) for each in found[0].related] == [("foo.ngc", 1)]


def test_files_that_call_each_other() -> None:
    program = "o<foo> call\nM2\n"
    files = {
        "foo.ngc": "o<foo> sub\no<bar> call\no<foo> endsub\n",
        "bar.ngc": "o<bar> sub\no<foo> call\no<bar> endsub\n",
    }
    check_said(findings(program, host=MemoryHost({"p.ngc": program, **files})))


def test_a_file_that_a_shell_would_change_is_never_asked_for() -> None:
    class Watched(MemoryHost):
        def read(self, path: str) -> str | None:
            raise AssertionError(path)

    program = "o<$(date)> call\nM2\n"
    host = Watched({"p.ngc": program, "$(date).ngc": FOO})
    check_said(findings(program, host=host), ("sub-name-unsafe", "error", 1))


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("#<depth>=1\nG0 X#<dept>\nM2\n", "did you mean `depth`?"),
        ("G0 X#<_motion_mod>\nM2\n", "did you mean `_motion_mode`?"),
        (
            "#<a>=1\no1 sub\nG0 X#<a>\no1 endsub\no1 call\nM2\n",
            "that of the main program is not seen here: use `#<_a>`",
        ),
        ("o1 sub\n#<a>=1\no1 endsub\no1 call\nG0 X#<a>\nM2\n", "that of `o1 sub` is not seen here"),
        ("G0 X#<a>\n#<a>=1\nM2\n", "only set further down, in line 2"),
        ("o<drill> sub\no<drill> endsub\no<drill> call\no<dril> call\nM2\n", "did you mean `drill`?"),
        ("o<dril> call\nM2\n", "setting `subroutine-path`"),
    ],
)
def test_messages_say_the_way_out(program: str, words: str) -> None:
    (found,) = findings(program)
    assert words in found.message


@pytest.mark.parametrize("line", ["#<a>=[1+", "G0 X1 X (#<a>", "#<a> 5"])
def test_a_line_that_cannot_be_read_may_set_what_it_names(line: str) -> None:
    assert [each.place.line for each in findings(f"{line}\nG0 X#<a>\nM2\n")] == [0]


def test_where_subs_begin_and_end_is_not_certain_nothing_is_said_of_what_is_in_them() -> None:
    check_said(findings("#<a>=1\no1 sub\nG0 X1\no1 call\nG0 X#<a>\nM2\n"), ("o-unclosed", "error", 2))


def test_numbered_parameters() -> None:
    check_said(
        findings("G0 X#77 Y#77 Z#12\nM2\n"), ("read-before-set", "warning", 1), ("read-before-set", "warning", 1)
    )
    check_said(findings("#[#1]=1\nG0 X#77\nM2\n"))
    check_said(findings("#1=40\n#[#1]=1\nG0 X#77\nM2\n"))
    check_said(findings("o<foo> call\nG0 X#77\nM2\n", "p.ngc", NoFiles()))
    check_said(findings("G0 X#5021 Y#5161\nM2\n"))
