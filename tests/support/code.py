"""The source tree as syntax: what the architecture tests look for in it. Each search takes text, so that planted faults can be searched too."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGES = (ROOT / "grammar" / "deburr_grammar", ROOT / "server" / "deburr")


def modules() -> list[Path]:
    """All Python files of the two packages."""
    return sorted(path for package in PACKAGES for path in package.rglob("*.py"))


def named_after(path: Path, names: Sequence[str]) -> bool:
    """Whether a file is a dialect's own: it, or a folder around it, has the dialect's name."""
    return not {*path.relative_to(ROOT).parts[:-1], path.stem}.isdisjoint(names)


def conditions_on(source: str, names: Sequence[str]) -> Iterator[int]:
    """The lines on which a condition or a lookup asks for one of the names."""
    for node in ast.walk(ast.parse(source)):
        for asked in _asked(node):
            if any(_names(part, names) for part in ast.walk(asked)):
                yield asked.lineno


def _asked(node: ast.AST) -> Iterator[ast.expr | ast.pattern]:
    match node:
        case ast.Compare() | ast.BoolOp():
            yield node
        case ast.If() | ast.While() | ast.IfExp() | ast.Assert():
            yield node.test
        case ast.comprehension():
            yield from node.ifs
        case ast.Match():
            yield node.subject
            yield from (case.pattern for case in node.cases)
            yield from (case.guard for case in node.cases if case.guard is not None)
        case ast.Dict():
            yield from (key for key in node.keys if key is not None)
        case ast.Subscript():
            yield node.slice
        case ast.Call(
            func=ast.Attribute(attr="get" | "pop" | "setdefault" | "startswith" | "endswith" | "removeprefix"),
            args=[first, *_],
        ):
            yield first


def _names(part: ast.AST, names: Sequence[str]) -> bool:
    match part:
        case ast.Constant(value=str(said)):
            # A rule's name, a module's and a path begin or end with the dialect's.
            return any(name in said.replace("/", ".").split(".") for name in names)
        case ast.Name(id=said) | ast.Attribute(attr=said):
            return said.lower() in names
        case ast.MatchStar() | ast.MatchAs():
            return False
    return False


def calls(source: str, functions: Sequence[str]) -> Iterator[int]:
    """The lines on which one of the functions is called by its bare name."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Call(func=ast.Name(id=name)) if name in functions:
                yield node.lineno


def imports(source: str) -> Iterator[tuple[int, str]]:
    """Imported modules with their lines, wherever they are imported."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Import(names=found):
                yield from ((node.lineno, alias.name) for alias in found)
            case ast.ImportFrom(module=str(module), level=0):
                yield node.lineno, module
            case ast.ImportFrom():
                yield node.lineno, "." * node.level + (node.module or "")


_OF_PATHS = frozenset(("write_text", "write_bytes", "touch", "rename", "hardlink_to", "symlink_to"))
_OF_MODULES = {
    "os": frozenset(("replace", "rename", "renames", "link", "symlink", "truncate", "mkfifo", "mknod")),
    "shutil": frozenset(("copy", "copy2", "copyfile", "copytree", "move", "make_archive", "unpack_archive")),
    "tempfile": frozenset(("mkstemp", "NamedTemporaryFile", "SpooledTemporaryFile")),
}


def writes(source: str) -> Iterator[int]:
    """The lines on which a file that has a name is opened to be written, written, or given its name."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and _writes(node):
            yield node.lineno


def _writes(call: ast.Call) -> bool:
    match call.func:
        case ast.Name("open"):
            return _to_write(call, 1)
        case ast.Attribute(ast.Name("os"), "open"):
            # What is thrown away is written nowhere.
            return ast.unparse(call.args[0]) != "os.devnull"
        case ast.Attribute(_, "open"):
            return _to_write(call, 0)
        case ast.Attribute(ast.Name(module), name) if module in _OF_MODULES:
            return name in _OF_MODULES[module]
        case ast.Name(name):
            return name in _OF_MODULES["tempfile"]
        case ast.Attribute(_, name):
            return name in _OF_PATHS
    return False


def _to_write(call: ast.Call, at: int) -> bool:
    """Whether the mode is one to write, or is not known."""
    modes = [call.args[at]] if len(call.args) > at else [each.value for each in call.keywords if each.arg == "mode"]
    return any(not isinstance(mode, ast.Constant) or set(str(mode.value)) & set("wax+") for mode in modes)
