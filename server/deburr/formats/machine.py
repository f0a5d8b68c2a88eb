"""The machine file of a code generator: formats, words, tables, arc style (spec/cgt.md §11, *Machine file*). Never opens a file, never knows a template."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from deburr.formats import Fault
from deburr.formats.toml import line_of
from deburr.suggest import suggestion
from deburr_grammar.text import Span, split_lines

FORMAT = re.compile(r"[DFTLPZE][+!]?[0-9]+\.[0-9]+")
"""A number format: type, sign, digits before and behind the point (spec/cgt.md §3)."""
CLASSES = ("F_Decimal", "F_Integer", "F_BlockNumber", "F_Offset")
TYPES = ("decimal", "integer", "offset", "text", "table")
"""What a word of `[words]` can be."""


@dataclass(frozen=True)
class Machine:
    """What a machine file says; what is wrong in it counts as not said."""

    arc_center: str = "incremental"
    first_tool: str = ""
    block_start: int = 10
    block_step: int = 10
    formats: Mapping[str, str] = field(default_factory=dict)
    tables: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)
    faults: tuple[Fault, ...] = ()
    lost: bool = False
    """Whether whole tables cannot be read: then nobody knows which words and tables there are."""
    doubtful: frozenset[str] = frozenset()
    """Names of words and tables that are given, but not as they should be."""


_GREATEST = 999_999
"""No control has block numbers beyond."""
_Path = tuple[str, ...]
_Wrong = Callable[[str, Any], str]


def read(text: str) -> Machine:
    """The machine that a text describes."""
    if not text.strip():
        return Machine()
    import tomllib

    try:
        data = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        return Machine(faults=(_syntax(text, str(error)),), lost=True)
    wrong = list(_faults(data))
    good = _good(data, {path for path, _ in wrong})
    return Machine(
        good.get("arc-center", "incremental"),
        good.get("first-tool", ""),
        good.get("block-start", 10),
        good.get("block-step", 10),
        good.get("formats", {}),
        {name: tuple(rows) for name, rows in good.get("tables", {}).items()},
        good.get("words", {}),
        tuple(Fault(*place(text, path), message) for path, message in wrong),
        any(len(path) == 1 and (path[0] in _TABLES or isinstance(data[path[0]], dict)) for path, _ in wrong),
        frozenset(path[-1] for path, _ in wrong if len(path) == 2),
    )


def place(text: str, path: _Path) -> tuple[int, Span]:
    """Where a key stands: its line and columns, as far as it is spelled plainly; else the first line with text."""
    lines = split_lines(text)
    number = line_of("\n".join(lines), path)
    line = number - 1 if number else next((at for at, said in enumerate(lines) if said.strip()), 0)
    said = lines[line]
    match = re.search(rf"(?<![\w-])[\"']?{re.escape(path[-1])}(?![\w-])[\"']?", said)
    if match:
        return line, Span(*match.span())
    return line, Span(len(said) - len(said.lstrip()), max(1, len(said.rstrip())))


def _good(data: Mapping[str, Any], wrong: set[_Path]) -> dict[str, Any]:
    """What is left without the keys that are wrong."""
    kept = {key: value for key, value in data.items() if (key,) not in wrong}
    return {
        key: {name: each for name, each in value.items() if (key, name) not in wrong}
        if isinstance(value, dict)
        else value
        for key, value in kept.items()
    }


def _faults(data: Mapping[str, Any]) -> Iterator[tuple[_Path, str]]:
    for key, value in data.items():
        if key in _TABLES:
            if not isinstance(value, dict):
                yield (key,), f"`{key}` must be a table, `[{key}]` with a line for each name"
                continue
            for name, inner in value.items():
                if message := _TABLES[key](name, inner):
                    yield (key, name), message
        elif key in _VALUES:
            if message := _VALUES[key](key, value):
                yield (key,), message
        else:
            yield (key,), f"there is no key `{key}`{suggestion(key, (*_VALUES, *_TABLES))}"


def _one_of(*choices: str) -> _Wrong:
    said = " or ".join(f'"{choice}"' for choice in choices)

    def wrong(key: str, value: Any) -> str:
        if isinstance(value, str) and value in choices:
            return ""
        return f"`{key}` must be {said}{suggestion(value, choices) if isinstance(value, str) else ''}"

    return wrong


def _whole(least: int) -> _Wrong:
    def wrong(key: str, value: Any) -> str:
        good = type(value) is int and least <= value <= _GREATEST
        return "" if good else f"`{key}` must be a whole number from {least} on, at most {_GREATEST:,}"

    return wrong


def _format(name: str, value: Any) -> str:
    if name not in CLASSES:
        return f"there is no class of formats `{name}`{suggestion(name, CLASSES)}"
    if isinstance(value, str) and FORMAT.fullmatch(value):
        return ""
    close = FORMAT.fullmatch(value.upper()) if isinstance(value, str) else None
    hint = f"; did you mean `{close[0]}`?" if close else ""
    return f'`{name}` must be a format such as "D4.4"{hint}'


def _table(name: str, value: Any) -> str:
    if not re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name):
        return f"`{name}` is no name of a table; write it without `#` and `@`"
    if isinstance(value, list) and all(isinstance(row, str) and len(split_lines(row)) == 1 for row in value):
        return ""
    return f'`{name}` must be a list of texts, one for each row from 0 on: `{name} = ["G00", "G01"]`'


def _word(name: str, value: Any) -> str:
    if not re.fullmatch("[A-Z][A-Z0-9_]*", name):
        return f"`{name}` is no system word; write it in capitals and without `#`"
    if isinstance(value, str) and value in TYPES:
        return ""
    hint = suggestion(value, TYPES) if isinstance(value, str) else ""
    return f"`{name}` must be one of {', '.join(TYPES)}{hint}"


_VALUES: dict[str, _Wrong] = {
    "arc-center": _one_of("incremental", "absolute"),
    "first-tool": _one_of("start", "toolchg"),
    "block-start": _whole(0),
    "block-step": _whole(1),
}
_TABLES: dict[str, _Wrong] = {"formats": _format, "tables": _table, "words": _word}


def _syntax(text: str, error: str) -> Fault:
    """A fault of TOML itself, at the place that its message ends with."""
    match = re.search(r" \(at line ([0-9]+), column ([0-9]+)\)$", error)
    lines = split_lines(text)
    last = max((at for at, said in enumerate(lines) if said.strip()), default=0)
    line = min(int(match[1]) - 1, last) if match else last
    end = max(0, len(lines[line].rstrip()) - 1)
    col = min(int(match[2]) - 1, end) if match else end
    said = error[: match.start()] if match else error.removesuffix(" (at end of document)")
    return Fault(line, Span(col, col + 1), f"this is no TOML: {said[:1].lower()}{said[1:]}")
