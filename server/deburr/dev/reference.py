"""Pages of the documentation site that are made from the code when it is built: configuration, command line, tables. Never writes a file."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from importlib import import_module
from typing import Any

from deburr.cli.main import COMMANDS
from deburr.schema import TOP, Free, tables
from deburr_grammar.codes import Entry
from deburr_grammar.dialect import Setting
from deburr_grammar.dialects import NAMES, by_name

FOLDER = "reference"


def reference() -> dict[str, str]:
    """The pages: path below the site's folder, and content."""
    return {
        f"{FOLDER}/configuration.md": configuration(),
        f"{FOLDER}/command-line.md": command_line(),
        **{f"{FOLDER}/{name}.md": dialect(name) for name in NAMES},
    }


def configuration() -> str:
    """Every key of `deburr.toml` with its type and default."""
    parts = [
        "# Configuration",
        "Settings stand in `deburr.toml`, or under `[tool.deburr]` in `pyproject.toml`; the nearest above a file wins. "
        "`deburr config FILE` prints those in force, `deburr init` writes a file that names them all.",
        _settings(TOP),
    ]
    for path, known in tables().items():
        if isinstance(known, Free):
            parts += [f"## [{'.'.join(path)}]", f"A table whose keys are yours: {known.text}."]
        elif known:
            parts += [f"## [{'.'.join(path)}]", _settings(known)]
    return "\n\n".join(parts) + "\n"


def command_line() -> str:
    """Every command with its options."""
    parts = ["# Command line", "Exit codes: 0 nothing to report, 1 findings, 2 it could not run."]
    for name, said in COMMANDS.items():
        parser: argparse.ArgumentParser = import_module(f"deburr.cli.{name.replace('-', '_')}").parser()
        parts += [f"## deburr {name}", f"{said[0].upper()}{said[1:]}.", *_options(parser)]
    return "\n\n".join(parts) + "\n"


def dialect(name: str) -> str:
    """The tables of a dialect: what hovers say of each code, word, function and variable."""
    language = by_name(name)
    ends = ", ".join(f"`{each}`" for each in language.extensions)
    parts = [f"# Tables of {language.title}", f"Id `{name}`; files {ends}. Hovers and completion say the same."]
    for table in dict.fromkeys(entry.table for entry in language.codes):
        rows = (
            f"| {_code(entry.name)} | {_cell(entry.title)} | {_cell(_text(entry))} |"
            for entry in language.codes.table(table)
        )
        parts += [f"## {table}", "\n".join(["| name | what it is | more |", "|---|---|---|", *rows])]
    return "\n\n".join(parts) + "\n"


def _settings(settings: tuple[Setting, ...]) -> str:
    rows = (f"| `{each.name}` | {_type(each)} | {_default(each.default)} | {_cell(each.text)} |" for each in settings)
    return "\n".join(["| key | type | default | meaning |", "|---|---|---|---|", *rows])


def _type(setting: Setting) -> str:
    return ", ".join(f"`{each}`" for each in setting.choices) if setting.choices else setting.kind.value


def _default(value: Any) -> str:
    if value in (None, ""):
        return "none"
    plain = dict(value) if hasattr(value, "items") else list(value) if isinstance(value, tuple) else value
    return _code(json.dumps(plain))


def _options(parser: argparse.ArgumentParser) -> Iterator[str]:
    """A parser's arguments as a table. argparse lays help out by the width of a terminal, so the parts are taken and not the text."""
    yield _cell(parser.description or "")
    rows = [f"| {_named(each)} | {_help(parser, each)} |" for each in parser._actions]
    yield "\n".join(["| option | meaning |", "|---|---|", *rows])


def _named(action: argparse.Action) -> str:
    shown = action.metavar if isinstance(action.metavar, str) else None
    if not action.option_strings:
        return _code(shown or action.dest)
    choices = "{" + ",".join(map(str, action.choices)) + "}" if action.choices else action.dest.upper()
    value = "" if action.nargs == 0 else f" {shown or choices}"
    return ", ".join(_code(each + value) for each in action.option_strings)


def _help(parser: argparse.ArgumentParser, action: argparse.Action) -> str:
    said = (action.help or "") % {**vars(action), "prog": parser.prog}
    return _cell(said)


def _text(entry: Entry) -> str:
    signature = entry.more.get("signature")
    return f"`{signature}`: {entry.text}" if signature else entry.text


def _code(text: str) -> str:
    """Text as it is, in a cell of a table."""
    escaped = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("|", "&#124;")
    return f"<code>{escaped}</code>"


def _cell(text: str) -> str:
    return " ".join(text.replace("<", "&lt;").replace("|", "&#124;").split())
