"""`deburr config`: the effective configuration of a file, as TOML with where each value comes from."""

import argparse
from collections.abc import Iterator, Mapping
from typing import Any

from deburr import paths
from deburr.cli.arguments import Parser
from deburr.cli.common import add_config, unable
from deburr.config import Config, ConfigError, Value
from deburr.configfile import Configs
from deburr.schema import Free, tables
from deburr_grammar.dialect import Setting


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr config",
        description="Print the effective configuration of a file and where each value comes from.",
    )
    found.add_argument("file", metavar="FILE", help="a program, or a folder for the programs in it")
    add_config(found)
    return found


def run(arguments: argparse.Namespace) -> int:
    """Print the configuration."""
    if not paths.exists(arguments.file):
        return unable([f"{arguments.file}: no such file or folder"])
    file = paths.absolute(arguments.file)
    try:
        configs = Configs(only=arguments.config)
        config = configs.in_folder(file) if paths.is_folder(file) else configs.of(file)
    except ConfigError as error:
        return unable(error.messages)
    print("\n".join(lines(config)))
    return 0


def lines(config: Config) -> Iterator[str]:
    """The configuration, one key a line, its origin in a comment behind it."""
    yield f"# {config.origin}" if config.origin else "# no configuration file: all values are defaults"
    for path, schema in tables().items():
        rows = list(_free(path, config) if isinstance(schema, Free) else _settings(path, schema, config))
        if rows:
            yield ""
            yield f"[{'.'.join(path)}]"
            yield from rows


def toml(value: Any) -> str:
    """A value as it is written in TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + "".join(_ESCAPES.get(char, char) for char in value) + '"'
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(toml, value))}]"
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{key(each)} = {toml(inner)}' for each, inner in value.items())} }}" if value else "{}"
    return str(value)


def key(name: str) -> str:
    """A key as it is written in TOML."""
    bare = name.isascii() and name.replace("-", "").replace("_", "").isalnum()
    return name if bare else toml(name)


_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}


def _settings(path: tuple[str, ...], schema: tuple[Setting, ...], config: Config) -> Iterator[str]:
    for setting in schema:
        found = _rules(setting, config) if path == ("check",) else None
        value, origin = found or config.get(".".join(path), setting)
        if value is None:
            yield f"# {setting.name}: {'the default set' if path == ('check',) else 'not set'}"
        else:
            yield f"{setting.name} = {toml(value)}  # {origin or 'default'}"


def _rules(setting: Setting, config: Config) -> Value | None:
    """What the files say together: a `select` puts aside all that stands below it."""
    if setting.name not in ("select", "extend-select", "ignore"):
        return None
    tops = [number for number, layer in enumerate(config.layers) if layer.select is not None]
    layers = config.layers[tops[-1] if tops else 0 :]
    origin = config.values.get(f"check.{setting.name}", Value(None, "")).origin
    if setting.name == "select":
        return Value(layers[0].select if tops else None, origin)
    names = (layer.extend if setting.name == "extend-select" else layer.ignore for layer in layers)
    return Value(tuple(dict.fromkeys(name for each in names for name in each)), origin)


def _free(path: tuple[str, ...], config: Config) -> Iterator[str]:
    """The tables whose keys are the user's."""
    if path == ("files",):
        yield from (f"{toml(glob.pattern)} = {toml(name)}  # {glob.origin}" for glob, name in config.files)
    elif path[-1] == "severity":
        for name, (severity, origin) in config.severities.items():
            yield f"{toml(name)} = {toml(severity.word if severity else 'off')}  # {origin}"
    else:
        yield from (f"{toml(glob.pattern)} = {toml(names)}  # {glob.origin}" for glob, names in config.ignores)
