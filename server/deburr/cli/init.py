"""`deburr init`: write a deburr.toml in which every key stands as a comment with its default, or with what was found for it in the folder."""

import argparse
from collections.abc import Iterator

from deburr.cli.arguments import Parser
from deburr.cli.common import unable
from deburr.cli.config import toml
from deburr.cli.replacing import replacing
from deburr.cli.surroundings import Surroundings, surroundings
from deburr.configfile import FILE
from deburr.schema import TOP, Free, tables
from deburr_grammar.dialect import Kind, Setting
from deburr_grammar.dialects import NAMES

EXAMPLES = {
    ("files",): '"posts/**/*.txt" = "DIALECT"',
    ("check", "severity"): '"DIALECT.RULE" = "warning"',
    ("check", "per-file-ignores"): '"legacy/**" = ["DIALECT"]',
}
_UNSET = {Kind.NUMBER: 5}
"""What stands for a setting that has no default."""
_HEAD = "# Configuration of deburr. What is commented out is the default; `deburr config FILE` prints what holds for a file."
_FOUND = "found here; take the # away to use it"
_MOST = 5
"""Files that are named for one setting."""


def parser() -> argparse.ArgumentParser:
    """The command's options: none."""
    return Parser(
        prog="deburr init",
        description=f"Write a {FILE} into this folder: every key as a comment with its default, or with a file that was found for it. It changes nothing before it is edited.",
    )


def run(_arguments: argparse.Namespace) -> int:
    """Write the file; one that is there already is left alone."""
    found = surroundings(".")
    try:
        with replacing(FILE, new=True) as out:
            out.write(("\n".join(lines(found)) + "\n").encode())
    except FileExistsError:
        return unable([f"{FILE} is there already; it is left as it is"])
    except OSError as error:
        return unable([f"{FILE}: {error.strerror}"])
    counted = ", ".join(f"{count} {name}" for name, count in sorted(found.languages.items()))
    print(
        f"wrote {FILE}"
        + (f" ({counted} program{'' if found.languages.total() == 1 else 's'} found)" if counted else "")
    )
    return 0


def lines(found: Surroundings) -> Iterator[str]:
    """The file. Tables of languages of which there is no program here are left out, unless there is none of any."""
    yield _HEAD
    yield from _settings((), TOP, found)
    left_out = []
    for path, schema in tables().items():
        if not schema:
            continue
        if found.languages and path[0] in NAMES and path[0] not in found.languages:
            left_out.append(path[0])
            continue
        yield ""
        yield f"[{'.'.join(path)}]"
        if isinstance(schema, Free):
            yield f"# {schema.text}"
            yield f"# {EXAMPLES[path]}"
            yield from _languages(found) if path == ("files",) else ()
        else:
            yield from _settings(path, schema, found)
    if left_out:
        yield ""
        yield f"# No programs were found here for [{'], ['.join(dict.fromkeys(left_out))}]."


def _languages(found: Surroundings) -> Iterator[str]:
    """What stands under `[files]`: endings that many languages share, if some of their files tell nothing."""
    for ending, count in sorted(found.silent.items()):
        shown = found.shown.get(ending)
        name = shown.most_common(1)[0][0] if shown else "DIALECT"
        told = f", {shown.total()} with one" if shown else ""
        yield f"# {ending} files here: {count} without a sign of their language, skipped{told}"
        yield f'# "**/*{ending}" = "{name}"'


def _settings(path: tuple[str, ...], schema: tuple[Setting, ...], found: Surroundings) -> Iterator[str]:
    for setting in schema:
        choices = f": {', '.join(setting.choices)}" if setting.choices else ""
        yield f"# {setting.text}{choices}"
        yield f"# {setting.name} = {toml(_UNSET.get(setting.kind, []) if setting.default is None else setting.default)}"
        beside = found.beside.get((path[0], setting.name), []) if len(path) == 1 else []
        if beside and setting.kind is Kind.PATHS:
            yield f"# {setting.name} = {toml(beside[:_MOST])}  # {_FOUND}"
        else:
            for each in beside[:_MOST]:
                yield f"# {setting.name} = {toml(each)}  # {_FOUND}"
