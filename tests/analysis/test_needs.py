"""What depends on a changed file is checked again, and only that; findings are always those of a fresh check."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr import source
from deburr.check import check
from deburr.finding import Finding
from deburr.host import Host
from deburr.needs import Needs
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import by_name


class Program(NamedTuple):
    """A program as it is to be checked."""

    source: source.Source
    dialect: Dialect
    ruleset: RuleSet


class Project:
    """The least that can be built on needs: programs under their paths. ``host`` gives the present state of all files, open ones as they are in the editor."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._programs: dict[str, Program] = {}
        self._kept: dict[str, tuple[tuple[Finding, ...], Needs]] = {}

    def put(self, file: str, program: Program) -> None:
        """A program that is new, or changed in its text, its dialect or its configuration. One that is as it was stays known."""
        if self._programs.get(file) != program:
            self._programs[file] = program
            self._kept.pop(file, None)

    def remove(self, file: str) -> None:
        """A program that is of no interest any more."""
        self._programs.pop(file, None)
        self._kept.pop(file, None)

    def findings(self, file: str) -> tuple[Finding, ...]:
        """All findings of a program, as if it were checked now."""
        kept = self._kept.get(file)
        if kept is None:
            needs = Needs(self._host)
            source, dialect, ruleset = self._programs[file]
            kept = self._kept[file] = tuple(check(source, dialect, ruleset, file, needs)), needs
        return kept[0]

    def changed(self, paths: Iterable[str]) -> tuple[str, ...]:
        """The programs whose findings may be others now that these files were written, made or taken away."""
        changed = tuple(paths)
        concerned = tuple(
            file
            for file, (_, needs) in self._kept.items()
            if any(needs.concerned(path, self._host) for path in changed)
        )
        for file in concerned:
            del self._kept[file]
        return concerned


class Files:
    """Files that a test changes, and how often each was read."""

    def __init__(self, files: Mapping[str, str] | None = None) -> None:
        self.texts = dict(files or {})
        self.read_count = 0

    def read(self, path: str) -> str | None:
        self.read_count += 1
        return self.texts.get(path)

    def names(self, folder: str) -> Sequence[str]:
        return sorted(path.rpartition("/")[2] for path in self.texts if path.rpartition("/")[0] == folder.rstrip("/"))


RULESETS = {name: RuleSet(by_name(name)) for name in ("metagcode", "rs274", "cgt", "z32")}


def program(text: str, dialect: str, ruleset: RuleSet | None = None) -> Program:
    read = source.read(text.encode())
    assert isinstance(read, source.Source)
    return Program(read, by_name(dialect), ruleset or RULESETS[dialect])


def rules(findings: Sequence[Finding]) -> list[str]:
    return [finding.rule for finding in findings]


PECK, DEEP, OTHER = (f"/w/Snippets/{name}.txt" for name in ("peck", "deep", "other"))
MAIN = "G0 Z5\n#FILE peck.txt\nM9\n"


def test_a_changed_snippet_is_seen_by_those_that_include_it() -> None:
    files = Files({PECK: "#FILE deep.txt\n", DEEP: "G1 Z-1\n", OTHER: "M8\n"})
    project = Project(files)
    project.put("/w/main.mgc", program(MAIN, "metagcode"))
    project.put("/w/alone.mgc", program("G0 X1\n", "metagcode"))
    assert not project.findings("/w/main.mgc") and not project.findings("/w/alone.mgc")
    files.texts[DEEP] = "#FILE peck.txt\n"
    assert project.changed([DEEP]) == ("/w/main.mgc",)
    assert rules(project.findings("/w/main.mgc")) == ["metagcode.snippet-cycle"]
    files.texts[OTHER] = "M9\n"
    assert project.changed([OTHER]) == ()


def test_a_file_written_as_it_was_concerns_nobody() -> None:
    files = Files({PECK: "G1 Z-1\n"})
    project = Project(files)
    project.put("/w/main.mgc", program(MAIN, "metagcode"))
    project.findings("/w/main.mgc")
    assert project.changed([PECK]) == ()
    asked = files.read_count
    project.findings("/w/main.mgc")
    project.put("/w/main.mgc", program(MAIN, "metagcode"))
    project.findings("/w/main.mgc")
    assert files.read_count == asked, "what is known is not asked for again"


def test_a_missing_file_that_appears_is_seen() -> None:
    files = Files()
    project = Project(files)
    project.put("/w/main.mgc", program(MAIN, "metagcode"))
    assert rules(project.findings("/w/main.mgc")) == ["metagcode.file-missing"]
    files.texts[PECK] = "M8\n"
    assert project.changed([PECK]) == ("/w/main.mgc",)
    assert project.findings("/w/main.mgc") == ()
    del files.texts[PECK]
    assert project.changed([PECK]) == ("/w/main.mgc",)
    assert rules(project.findings("/w/main.mgc")) == ["metagcode.file-missing"]


def test_a_changed_configuration_is_seen_by_its_programs_alone() -> None:
    files = Files()
    project = Project(files)
    linuxcnc, smithy = RULESETS["rs274"], RuleSet(by_name("rs274"), {"profile": "smithy"})
    text = "#5500=1\nM2\n"
    for name in ("one", "two"):
        project.put(f"/w/{name}.ngc", program(text, "rs274", linuxcnc))
        assert project.findings(f"/w/{name}.ngc") == ()
    project.put("/w/one.ngc", program(text, "rs274", smithy))
    assert "rs274.param-range" in rules(project.findings("/w/one.ngc"))
    assert project.findings("/w/two.ngc") == ()


def test_a_removed_program_is_forgotten() -> None:
    project = Project(Files())
    project.put("/w/main.mgc", program(MAIN, "metagcode"))
    project.findings("/w/main.mgc")
    project.remove("/w/main.mgc")
    assert project.changed([PECK]) == ()
    with pytest.raises(KeyError):
        project.findings("/w/main.mgc")


MAINS = ("/w/a.mgc", "/w/b.mgc")
NAMES = (*MAINS, "/w/Snippets/s.txt", "/w/Snippets/t.txt", "/w/Snippets/S.txt")
TEXTS = st.sampled_from(
    [None, "M8\n", "#FILE s.txt\n", "#FILE t.txt\n#FILE s.txt\n", "#FILE S.txt\n", "#FILE t.txt\n", "#FOO\n", "|x\n"]
)


@given(st.lists(st.tuples(st.sampled_from(NAMES), TEXTS), min_size=1, max_size=12))
def test_any_changes_leave_what_a_fresh_check_finds(changes: list[tuple[str, str | None]]) -> None:
    files = Files()
    project = Project(files)
    for name, text in changes:
        files.texts.pop(name, None)
        if text is not None:
            files.texts[name] = text
        project.changed([name])
        for file in MAINS:
            held = program(files.texts.get(file, ""), "metagcode")
            project.put(file, held)
            fresh = check(held.source, held.dialect, held.ruleset, file, files)
            assert project.findings(file) == tuple(fresh)
