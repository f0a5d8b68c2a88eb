"""What may stand in `deburr.toml`: the fixed tables, the dialects' own, and what is wrong with a given file. Never reads one."""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from deburr.machine import MACHINE
from deburr.selection import unknown
from deburr.suggest import suggestion
from deburr_grammar.dialect import Kind, Setting
from deburr_grammar.dialects import NAMES, by_name

LEVELS = ("error", "warning", "info")

TOP = (Setting("extend", Kind.PATH, "", "another configuration file, over which this one is laid"),)
CHECK = (
    Setting("select", Kind.LIST, None, "rules or prefixes that are on, `ALL` for all; absent: the default set"),
    Setting("extend-select", Kind.LIST, (), "rules or prefixes that are on besides"),
    Setting("ignore", Kind.LIST, (), "rules or prefixes that are off"),
    Setting("fail-on", Kind.CHOICE, "error", "the least severity for which `deburr check` exits 1", LEVELS),
    Setting("run", Kind.FLAG, True, "also report what a bounded run of the program meets"),
)

HINTS = (
    Setting("passes", Kind.FLAG, True, "how often a loop goes round, and its step"),
    Setting("values", Kind.FLAG, True, "what a variable or a constant expression comes to"),
    Setting("rows", Kind.FLAG, True, "the row of a table that a number means"),
    Setting("alias", Kind.FLAG, True, "the axis for which an alias stands"),
)
LENSES = (
    Setting("expand", Kind.FLAG, True, "the way to the flat program"),
    Setting("references", Kind.FLAG, True, "how often a subprogram or section is called"),
    Setting("passes", Kind.FLAG, True, "how often a loop goes round"),
)
FORMAT = (
    Setting("indent", Kind.WIDTH, 2, "blanks by which the lines in a block are indented"),
    Setting("indent-style", Kind.CHOICE, "space", "blanks, or a tab for each level", ("space", "tab")),
    Setting(
        "case",
        Kind.CHOICE,
        "keep",
        "letters as they are, or as the dialect's manual writes them",
        ("keep", "canonical"),
    ),
)
WIDEST = 16
"""The most that a setting of a width can be."""


Path = tuple[str, ...]


class Fault(NamedTuple):
    """What is wrong at a key of the file."""

    path: Path
    message: str


class Free(NamedTuple):
    """A table whose keys are the user's: what they are, and what is wrong with a key and its value (nothing: "")."""

    text: str
    wrong: Callable[[str, Any], str]


def tables() -> dict[Path, tuple[Setting, ...] | Free]:
    """All tables that there can be."""
    found: dict[Path, tuple[Setting, ...] | Free] = {
        ("files",): Free("which dialect the files of a pattern are written in", _file),
        ("check",): CHECK,
        ("check", "severity"): Free("the severity of single rules: error, warning, info or off", _severity),
        ("check", "per-file-ignores"): Free("rules or prefixes that are off for the files of a pattern", _ignores),
    }
    found |= {("format",): FORMAT}
    found |= {(name,): by_name(name).settings for name in NAMES}
    found |= {("machine",): MACHINE}
    editor = {("editor",): (), ("editor", "inlay-hints"): HINTS, ("editor", "code-lens"): LENSES}
    return found | editor


def faults(data: Mapping[str, Any]) -> Iterator[Fault]:
    """What is wrong with a configuration, in its own order."""
    known = tables()
    below = {path[0] for path in known}
    for key, value in data.items():
        if (key,) in known:
            yield from _table((key,), value, known)
        else:
            yield from _setting((), key, value, TOP, (*(setting.name for setting in TOP), *sorted(below)))


def _table(path: Path, value: Any, known: Mapping[Path, tuple[Setting, ...] | Free]) -> Iterator[Fault]:
    if not isinstance(value, Mapping):
        yield Fault(path, f"`{'.'.join(path)}` must be a table, not {_kind(value)}")
        return
    schema = known[path]
    for key, inner in value.items():
        if (*path, key) in known:
            yield from _table((*path, key), inner, known)
        elif isinstance(schema, Free):
            message = schema.wrong(key, inner)
            yield from [Fault((*path, key), message)] if message else []
        else:
            below = [each[-1] for each in known if each[:-1] == path]
            yield from _setting(path, key, inner, schema, (*(setting.name for setting in schema), *below))


def _setting(path: Path, key: str, value: Any, schema: tuple[Setting, ...], names: tuple[str, ...]) -> Iterator[Fault]:
    setting = next((each for each in schema if each.name == key), None)
    if setting is None:
        where = f" in [{'.'.join(path)}]" if path else ""
        yield Fault((*path, key), f"unknown key `{key}`{where}{suggestion(key, names)}")
        return
    message = wrong(setting, value)
    if message:
        yield Fault((*path, key), f"`{key}` {message}")
    elif path == ("check",) and setting.kind is Kind.LIST:
        yield from (Fault((*path, key), said) for name in value if (said := unknown(name)))
    elif setting.kind is Kind.TEXT:
        said = setting.each(key, value) if setting.each is not None else ""
        yield from [Fault((*path, key), said)] if said else []
    elif setting.each is not None:
        pairs = value.items() if isinstance(value, Mapping) else ((name, None) for name in value)
        yield from (Fault((*path, key, name), said) for name, of in pairs if (said := setting.each(name, of)))


def wrong(setting: Setting, value: Any) -> str:
    """What is wrong with a setting's value, or nothing."""
    match setting.kind:
        case Kind.CHOICE:
            if value in setting.choices and isinstance(value, str):
                return ""
            hint = suggestion(value, setting.choices) if isinstance(value, str) else ""
            return f"must be {_or(setting.choices)}, not {_said(value)}{hint}"
        case Kind.LIST | Kind.PATHS:
            good = isinstance(value, list) and all(isinstance(each, str) for each in value)
            return "" if good else f"must be a list of texts, not {_kind(value)}"
        case Kind.TABLE:
            return "" if isinstance(value, Mapping) else f"must be a table, not {_kind(value)}"
        case Kind.FLAG:
            return "" if isinstance(value, bool) else f"must be true or false, not {_said(value)}"
        case Kind.WIDTH:
            good = isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= WIDEST
            return "" if good else f"must be a number from 0 to {WIDEST}, not {_said(value)}"
        case Kind.NUMBER:
            good = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
            return "" if good else f"must be a number, not {_said(value)}"
        case Kind.TEXT | Kind.PATH:
            return "" if isinstance(value, str) else f"must be a text, not {_kind(value)}"


def _file(pattern: str, value: Any) -> str:
    if said := _pattern(pattern):
        return said
    if isinstance(value, str) and value in NAMES:
        return ""
    return f"{_said(value)} is no dialect{suggestion(value, NAMES) if isinstance(value, str) else ''}"


def _severity(name: str, value: Any) -> str:
    if said := unknown(name, whole=True):
        return said
    levels = (*LEVELS, "off")
    return "" if isinstance(value, str) and value in levels else f"`{name}` must be {_or(levels)}, not {_said(value)}"


def _pattern(said: str) -> str:
    from deburr.patterns import is_pattern

    return "" if is_pattern(said.removeprefix("!")) else f"`{said}` is no pattern of paths; write it as in `.gitignore`"


def _ignores(pattern: str, value: Any) -> str:
    if said := _pattern(pattern):
        return said
    if not isinstance(value, list) or not all(isinstance(each, str) for each in value):
        return f"`{pattern}` must be a list of rules, not {_kind(value)}"
    return next((said for name in value if (said := unknown(name))), "")


def _or(words: tuple[str, ...]) -> str:
    quoted = [f'"{word}"' for word in words]
    return quoted[0] if len(quoted) == 1 else f"{', '.join(quoted[:-1])} or {quoted[-1]}"


def _said(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) else _kind(value) if isinstance(value, Mapping | list) else f"{value}"


def _kind(value: Any) -> str:
    names = {bool: "true or false", str: "a text", int: "a number", float: "a number", list: "a list", dict: "a table"}
    if isinstance(value, list) and any(not isinstance(each, str) for each in value):
        return "a list with something else in it"
    return names.get(type(value), "a date or time")
