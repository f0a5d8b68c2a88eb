"""A dialect is a folder and a name in a list. The shipped ones are complete, and one made up on the spot works at once."""

import shutil
import textwrap
import tomllib
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest
from pathspec import GitIgnoreSpec

import deburr_grammar.dialects
from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr_grammar import Document, Edit, Pos
from deburr_grammar.codes import CodeTable
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.grammar import Grammar
from deburr_grammar.structure import Fault
from deburr_grammar.tree import tokens
from support.code import PACKAGES, ROOT
from support.equality import check
from support.strategies import fixed_cases

GRAMMAR = PACKAGES[0]
DIALECTS = GRAMMAR / "dialects"
NEEDED = ("__init__.py", "line.lark", "line.tables", "codes.toml", "variables.toml", "codes.tables")


def test_every_dialect_folder_is_listed_and_none_else() -> None:
    folders = {path.parent.name for path in DIALECTS.glob("*/__init__.py")}
    assert folders == set(NAMES)
    assert len(set(NAMES)) == len(NAMES)
    with pytest.raises(KeyError):
        by_name("klingon")


@pytest.mark.parametrize("name", NAMES)
def test_a_dialect_has_what_it_needs(name: str) -> None:
    dialect = by_name(name)
    assert {path.name for path in (DIALECTS / name).iterdir()} >= set(NEEDED)
    assert (dialect.name, dialect.package) == (name, f"deburr_grammar.dialects.{name}")
    assert dialect.title
    assert dialect.extensions
    assert all(extension.startswith(".") for extension in dialect.extensions)
    assert dialect.frame.count("{}") == 1
    assert dialect.starts
    assert len({reading.name for reading in dialect.readings}) == len(dialect.readings)
    assert len({setting.name for setting in dialect.settings}) == len(dialect.settings)
    assert list(dialect.codes)
    assert hash(dialect) == hash(by_name(name))


@pytest.mark.parametrize("name", NAMES)
def test_outlines_and_foldings_are_sound(name: str) -> None:
    dialect = by_name(name)
    facts = dialect.outline.facts("")
    assert facts == frozenset()
    start = dialect.outline.start(facts)
    assert hash(start) is not None
    assert dialect.outline.reading(start) in dialect.readings
    assert not dialect.marks.search(""), "an empty line carries no mark"
    assert dialect.folding.fold("") == ""
    for reading in dialect.readings:
        if reading.start is not None:
            assert dialect.grammar.parse(reading.start, "").fault is None, "an empty line is no fault in any reading"


@pytest.mark.parametrize("name", NAMES)
def test_words_name_terminals_of_the_grammar(name: str) -> None:
    dialect = by_name(name)
    terminals = {terminal.name for terminal in dialect.grammar.build().terminals}
    assert set(dialect.words) - terminals <= {"$END"}


@pytest.mark.parametrize("name", NAMES)
def test_the_tables_that_ship_are_fresh(name: str) -> None:
    """`python -m deburr_grammar.tables` writes them, the same bytes each time. They begin with all that they are made from."""
    grammar = by_name(name).grammar
    assert grammar.fresh, "run `python -m deburr_grammar.tables`"
    assert grammar.tables() == (DIALECTS / name / "line.tables").read_bytes()


@pytest.mark.parametrize("name", NAMES)
def test_the_codes_that_ship_are_fresh(name: str) -> None:
    """What is loaded is what the TOML files say, entry for entry."""
    package = by_name(name).package
    assert CodeTable(package).fresh, "run `python -m deburr_grammar.tables`"
    built = CodeTable("deburr_grammar.dialects")
    built.__dict__["_texts"] = CodeTable(package)._texts
    assert not built.fresh
    assert list(CodeTable(package)) == list(built)


@pytest.fixture
def toy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Dialect]:
    """A fifth dialect: its folder, and its name in the list."""
    folder = tmp_path / "toy"
    folder.mkdir()
    for file, text in TOY.items():
        (folder / file).write_text(textwrap.dedent(text), encoding="utf-8")
    monkeypatch.setattr(deburr_grammar.dialects, "NAMES", (*NAMES, "toy"))
    monkeypatch.setattr(deburr_grammar.dialects, "__path__", [*deburr_grammar.dialects.__path__, str(tmp_path)])
    monkeypatch.delitem(import_module("sys").modules, "deburr_grammar.dialects.toy", raising=False)
    yield by_name("toy")
    monkeypatch.delitem(import_module("sys").modules, "deburr_grammar.dialects.toy", raising=False)


TOY = {
    "line.lark": """
        line: (word | BEGIN | END)*
        word: LETTER NUMBER
        BEGIN: "{"
        END: "}"
        LETTER: /[A-Z]/
        NUMBER: /[0-9]+/
        %ignore " "
    """,
    "codes.toml": """
        [[code]]
        name = "G1"
        title = "straight move"
    """,
    "__init__.py": '''
        """A language of words and braces."""

        from deburr_grammar.dialect import Bracket, Dialect, Reading, Role, Step
        from deburr_grammar.problem import Problem
        from deburr_grammar.shape import Folding
        from deburr_grammar.text import Span

        LINE = Reading("line", "line")
        ROLES = {"{": Role.OPEN, "}": Role.CLOSE}


        class Outline:
            marks = "[{}]"
            needs_depth = ""

            def facts(self, text):
                return frozenset()

            def start(self, facts):
                return None

            def reading(self, state):
                return LINE

            def step(self, state, depth, facts, read):
                text = read(LINE).text
                found = (Bracket(ROLES[sign], "brace", sign, None, Span(at, at + 1)) for at, sign in enumerate(text) if sign in ROLES)
                return Step(LINE, tuple(found), None)


        DIALECT = Dialect(
            name="toy",
            title="Toy",
            package="deburr_grammar.dialects.toy",
            extensions=(".toy",),
            readings=(LINE,),
            folding=Folding(),
            outline=Outline(),
            diagnose=lambda fault: Problem("bad", max(0, fault.start - (fault.found == "$END")), fault.end),
            words={"NUMBER": "a number"},
            comments=(),
            frame="{}",
        )
    ''',
}


def test_a_new_dialect_is_one_folder_and_one_name(toy: Dialect) -> None:
    document = Document.parse("G1 X22 {\n  Y3\n}\n}\n?\n", toy, 3)
    assert [(line, bracket.word) for line, bracket in document.brackets()] == [(0, "{"), (2, "}"), (3, "}")]
    assert [(fault.fault, fault.at.line) for fault in document.faults] == [(Fault.UNOPENED, 3)]
    (first, bracket), (last, other), _ = document.brackets()
    assert document.partner(first, bracket) == (last, other)
    assert [(token.kind, token.start, token.end) for token in tokens(document.node(0).tree)] == [
        ("LETTER", 0, 1),
        ("NUMBER", 1, 2),
        ("LETTER", 3, 4),
        ("NUMBER", 4, 6),
        ("BEGIN", 7, 8),
    ]
    assert [(line, problem.kind) for line, problem in document.problems()] == [(4, "bad")]
    assert document.edit(Edit(Pos(3, 0), Pos(4, 1), "")).faults == ()
    assert Analysis(document, RuleSet(toy)).scopes
    assert [entry.title for entry in toy.codes] == ["straight move"]


def test_a_new_dialect_keeps_all_promises_at_once(toy: Dialect) -> None:
    for case in fixed_cases(toy, 80):
        check(toy, case)


def test_tables_that_are_missing_damaged_or_of_another_grammar_are_built_anew(
    toy: Dialect, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "toy" / "line.tables"
    wanted = toy.grammar.parse("line", "G1 {")
    assert not toy.grammar.fresh

    def reads() -> bool:
        return Grammar(toy.package, toy.starts).parse("line", "G1 {") == wanted

    assert reads()
    path.write_bytes(toy.grammar.tables())
    assert toy.grammar.fresh
    built = []
    monkeypatch.setattr(Grammar, "build", lambda self, build=Grammar.build: built.append(self) or build(self))
    assert reads()
    assert not built, "fresh tables are loaded"
    whole = path.read_bytes()
    for broken in (
        whole.replace(b"BEGIN: ", b"BEGIN : ", 1),
        b"",
        whole[:100],
        whole[:-200],
        toy.grammar._key,
        toy.grammar._key + b"no tables",
        whole.replace(b"(1, ", b"(2, ", 1),
    ):
        path.write_bytes(broken)
        assert reads()
    assert len(built) == 7
    (tmp_path / "toy" / "line.lark").write_text("line: /.+/", encoding="utf-8")
    path.write_bytes(whole)
    assert not toy.grammar.fresh
    assert not reads()
    shutil.rmtree(tmp_path / "toy")


def test_the_wheel_carries_all_that_is_read_at_run_time() -> None:
    """Hatch takes whole packages but for what git ignores."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    wheel = project["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert sorted(wheel["packages"]) == sorted(str(package.relative_to(ROOT)) for package in PACKAGES)
    assert not {"include", "exclude", "only-include", "artifacts"} & (
        wheel.keys() | project["tool"]["hatch"]["build"].keys()
    )
    ignored = GitIgnoreSpec.from_lines((ROOT / ".gitignore").read_text(encoding="utf-8").splitlines())
    data = [
        path
        for package in PACKAGES
        for path in package.rglob("*")
        if path.suffix in (".lark", ".tables", ".toml", ".typed")
    ]
    assert len(data) >= 4 * 4 + 2
    assert [path for path in data if ignored.match_file(path.relative_to(ROOT))] == []
