"""What must never stand in the source: dialects' names in conditions, open files and clocks in the core, prints, long files."""

import ast
from pathlib import Path

import pytest

from deburr_grammar.dialects import NAMES
from support.code import PACKAGES, ROOT, calls, conditions_on, imports, modules, named_after, writes

GRAMMAR, SERVER = PACKAGES
MODULES = modules()
AT_THE_EDGE = ("cli", "lsp", "dev")
"""Folders of the server that face the world: they may open files, print and ask what time it is."""
ON_THE_DISK = {GRAMMAR / "tables.py", SERVER / "paths.py"}
"""Single modules that read or write files: one writes the tables that ship, one is the host over a real disk."""


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def core() -> list[Path]:
    edges = [SERVER / folder for folder in AT_THE_EDGE]
    return [path for path in MODULES if path not in ON_THE_DISK and not any(edge in path.parents for edge in edges)]


@pytest.mark.parametrize("path", [path for path in MODULES if not named_after(path, NAMES)], ids=name_of)
def test_no_dialect_is_named_in_a_condition(path: Path) -> None:
    assert list(conditions_on(path.read_text(encoding="utf-8"), NAMES)) == []


@pytest.mark.parametrize(
    "planted",
    [
        "if dialect.name == 'rs274': pass",
        "x = 1 if name != 'cgt' else 2",
        "while 'z32' == name: pass",
        "y = name in ('rs274', 'metagcode')",
        "match name:\n    case 'cgt': pass",
        "match name:\n    case 'x' | 'cgt': pass",
        "match dialect:\n    case rs274.DIALECT: pass",
        "if dialect is rs274.DIALECT: pass",
        "if dialect.package == 'deburr_grammar.dialects.z32': pass",
        "if path.startswith('dialects/cgt/'): pass",
        "z = {'cgt': 1, 'z32': 2}[name]",
        "rules['rs274']",
        "rules.get('rs274')",
        "assert name == 'metagcode'",
        "x = [d for d in all_ if d.name == 'cgt']",
        "ok = special or name == 'cgt'",
        "ok = CGT and long",
        "if rule.name == 'rs274.limit': pass",
        "short = name.removeprefix('cgt.')",
    ],
)
def test_a_planted_condition_is_found(planted: str) -> None:
    assert list(conditions_on(planted, ("metagcode", "rs274", "cgt", "z32")))


@pytest.mark.parametrize(
    "plain",
    [
        "NAMES = ('metagcode', 'rs274')",
        "'''As `rs274` does.'''",
        "if name in NAMES: pass",
        "help(text='rs274: smithy')",
        "if kind == 'comment': pass",
    ],
)
def test_a_mere_mention_is_not(plain: str) -> None:
    assert not list(conditions_on(plain, ("metagcode", "rs274", "cgt", "z32")))


@pytest.mark.parametrize("path", [path for path in MODULES if named_after(path, NAMES)], ids=name_of)
def test_no_dialect_imports_another(path: Path) -> None:
    own = {name for name in NAMES if named_after(path, (name,))}
    for line, module in imports(path.read_text(encoding="utf-8")):
        others = set(module.split(".")) & set(NAMES) - own
        assert not others, f"line {line} imports {module}"


GRAMMAR_PARTS = {"codes", "dialect", "layout", "line", "problem", "shape", "structure", "text", "tree"}


@pytest.mark.parametrize(
    "path",
    [path for path in MODULES if GRAMMAR / "dialects" in path.parents and path.parent.name in NAMES],
    ids=name_of,
)
def test_a_grammar_folder_knows_lines_and_nothing_larger(path: Path) -> None:
    for line, module in imports(path.read_text(encoding="utf-8")):
        package, _, rest = module.partition(".")
        if package == GRAMMAR.name:
            assert rest.split(".")[0] in GRAMMAR_PARTS or rest.startswith(f"dialects.{path.parent.name}"), (
                f"line {line} imports {module}"
            )


@pytest.mark.parametrize("path", core(), ids=name_of)
def test_the_core_opens_no_file_and_reads_no_clock(path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    assert list(calls(source, ("open", "input", "print", "exec", "eval", "breakpoint"))) == []
    forbidden = {
        "datetime",
        "glob",
        "pathlib",
        "random",
        "shutil",
        "socket",
        "subprocess",
        "tempfile",
        "threading",
        "time",
        "urllib",
    }
    assert [(line, module) for line, module in imports(source) if module.split(".")[0] in forbidden] == []
    if "os" in {module for _, module in imports(source)}:
        used = {
            node.attr
            for node in ast.walk(ast.parse(source))
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "os"
        }
        assert used <= {"environ"}


WRITING = {SERVER / "cli" / "replacing.py"}
"""What writes files: each whole or not at all, which its test proves of every sort of file. What makes the package's own files is left out."""


@pytest.mark.parametrize(
    "path",
    [path for path in MODULES if path not in WRITING | {GRAMMAR / "tables.py"} and SERVER / "dev" not in path.parents],
    ids=name_of,
)
def test_files_are_written_in_one_place(path: Path) -> None:
    assert list(writes(path.read_text(encoding="utf-8"))) == []


@pytest.mark.parametrize(
    "planted",
    [
        "open(path, 'w')",
        "open(path, mode='ab')",
        "open(path, mode)",
        "Path(a).open('x')",
        "Path(a).open(mode='r+')",
        "path.write_text('a')",
        "Path(a).write_bytes(b'a')",
        "os.open(path, os.O_RDWR)",
        "os.replace(a, b)",
        "shutil.copyfile(a, b)",
        "tempfile.NamedTemporaryFile()",
        "NamedTemporaryFile('w')",
        "with open(path, 'rb') as one, open(other, 'wb') as two: pass",
    ],
)
def test_a_planted_write_is_found(planted: str) -> None:
    assert list(writes(planted)) == [1]


@pytest.mark.parametrize(
    "plain",
    [
        "open(path)",
        "open(path, 'rb')",
        "Path(a).open()",
        "os.open(os.devnull, os.O_WRONLY)",
        "text.replace('a', 'b')",
        "TemporaryFile()",
        "out.write('a')",
    ],
)
def test_what_writes_no_file_is_not(plain: str) -> None:
    assert list(writes(plain)) == []


def test_the_searches_find_what_they_look_for() -> None:
    assert list(calls("def f():\n    with open('x'): print(1)", ("open", "print"))) == [2, 2]
    assert list(imports("def f():\n    import time\n    from datetime import date")) == [(2, "time"), (3, "datetime")]


@pytest.mark.parametrize(
    "path", [path for path in MODULES if not any(SERVER / edge in path.parents for edge in AT_THE_EDGE)], ids=name_of
)
def test_libraries_do_not_print(path: Path) -> None:
    assert list(calls(path.read_text(encoding="utf-8"), ("print",))) == []


def files() -> list[Path]:
    folders = [ROOT / folder for folder in ("grammar", "server", "tests", "benchmarks")]
    return sorted(path for folder in folders for path in folder.rglob("*.py"))


def test_no_file_is_longer_than_a_person_reads() -> None:
    long = {
        name_of(path): size for path in files() if (size := len(path.read_text(encoding="utf-8").splitlines())) > 500
    }
    assert long == {}


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_every_module_opens_with_its_job(path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    assert not source.strip() or ast.get_docstring(ast.parse(source)), "an empty file or one with a docstring"
