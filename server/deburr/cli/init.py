"""`deburr init`: write a deburr.toml in which every key stands as a comment with its default."""

import argparse
from collections.abc import Iterator
from pathlib import Path

from deburr.cli.common import unable
from deburr.cli.config import toml
from deburr.configfile import FILE
from deburr.schema import TOP, Free, tables
from deburr_grammar.dialect import Kind, Setting

EXAMPLES = {
    ("files",): '"posts/**/*.txt" = "DIALECT"',
    ("check", "severity"): '"DIALECT.RULE" = "warning"',
    ("check", "per-file-ignores"): '"legacy/**" = ["DIALECT"]',
}
_UNSET = {Kind.NUMBER: 5}
"""What stands for a setting that has no default."""
_HEAD = "# Configuration of deburr. What is commented out is the default; `deburr config FILE` prints what holds for a file."


def parser() -> argparse.ArgumentParser:
    """The command's options: none."""
    return argparse.ArgumentParser(
        prog="deburr init", description=f"Write a commented {FILE} into this folder.", allow_abbrev=False
    )


def run(_arguments: argparse.Namespace) -> int:
    """Write the file; one that is there already is left alone."""
    try:
        with Path(FILE).open("x", encoding="utf-8", newline="\n") as out:
            out.write("\n".join(lines()) + "\n")
    except FileExistsError:
        return unable([f"{FILE} is there already; it is left as it is"])
    except OSError as error:
        return unable([f"{FILE}: {error.strerror}"])
    print(f"wrote {FILE}")
    return 0


def lines() -> Iterator[str]:
    """The file."""
    yield _HEAD
    yield from _settings(TOP)
    for path, schema in tables().items():
        if not schema:
            continue
        yield ""
        yield f"[{'.'.join(path)}]"
        if isinstance(schema, Free):
            yield f"# {schema.text}"
            yield f"# {EXAMPLES[path]}"
        else:
            yield from _settings(schema)


def _settings(schema: tuple[Setting, ...]) -> Iterator[str]:
    for setting in schema:
        choices = f": {', '.join(setting.choices)}" if setting.choices else ""
        yield f"# {setting.text}{choices}"
        yield f"# {setting.name} = {toml(_UNSET.get(setting.kind, []) if setting.default is None else setting.default)}"
