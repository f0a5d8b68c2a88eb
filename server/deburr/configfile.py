"""Configuration files: the nearest `deburr.toml` or `[tool.deburr]` above a program, and all that it extends.

Paths in a configuration file are relative to its own folder and are made absolute here.
What is wrong with a file is said with its place, all of it at once.
"""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from deburr import paths
from deburr.config import Config, ConfigError, Glob, Graded, Value
from deburr.finding import Severity
from deburr.schema import Fault, Free, faults, tables
from deburr.selection import Selection
from deburr_grammar.dialect import Dialect, Kind, Setting

FILE = "deburr.toml"
PROJECT = "pyproject.toml"


class Configs:
    """The configurations of files, each read once. ``top`` (the command line) is laid over all; ``only``: this file for all of them."""

    def __init__(self, top: Config | None = None, only: str | None = None) -> None:
        self._top = top or Config()
        self._only = None if only is None else self._top.over(read(paths.absolute(only)))
        self._folders: dict[str, Config] = {}
        self._complete: set[tuple[int, str]] = set()

    def of(self, file: str) -> Config:
        """The configuration of a file, given by its absolute path."""
        return self.in_folder(paths.parent(file))

    def in_folder(self, folder: str) -> Config:
        """The configuration of the files in a folder."""
        if self._only is not None:
            return self._only
        if folder not in self._folders:
            self._folders[folder] = self._found(folder)
        return self._folders[folder]

    def require(self, config: Config, dialect: Dialect) -> None:
        """ConfigError if a configuration of this session names files or folders for a dialect that are not there; asked once for each."""
        if (id(config), dialect.name) not in self._complete:
            self._complete.add((id(config), dialect.name))
            if missing := tuple(_absent(config, dialect)):
                raise ConfigError(*missing)
            if wrong := tuple(_unreadable(config, dialect)):
                raise ConfigError(*wrong)

    def _found(self, folder: str) -> Config:
        for name in (FILE, PROJECT):
            path = paths.join(folder, name)
            if paths.is_file(path) and (name == FILE or _has_table(path)):
                return self._top.over(read(path))
        outer = paths.parent(folder)
        return self._top if outer == folder else self.in_folder(outer)


def read(path: str) -> Config:
    """A configuration file with all that it extends; ConfigError if it cannot be used."""
    found, seen = Config(), list[str]()
    following: str | None = path
    while following is not None:
        if following in seen:
            raise ConfigError(_extending(seen[-1], "goes round in a circle"))
        try:
            data = _data(following)
        except OSError as error:
            why = error.strerror or "cannot be read"
            wrong = _extending(seen[-1], f"names `{following}`: {why}") if seen else f"{following}: {why}"
            raise ConfigError(wrong) from None
        seen.append(following)
        found = found.over(_config(data, following))
        following = _beside(following, data["extend"]) if data.get("extend") else None
    return found


def given(data: Mapping[str, Any], folder: str, said_by: str) -> Config:
    """A configuration that stands in no file, such as an editor's settings; paths in it are seen from a folder."""
    wrong = [f"{said_by}: {fault.message}" for fault in faults(data)]
    if wrong:
        raise ConfigError(*wrong)
    return _config(data, paths.join(folder, said_by))


def _absent(config: Config, dialect: Dialect) -> Iterator[str]:
    """What is said of each file or folder that is not there."""
    for setting in dialect.settings:
        value, origin = config.get(dialect.name, setting)
        if origin and setting.kind in (Kind.PATH, Kind.PATHS):
            for path in (value,) if setting.kind is Kind.PATH else value:
                if path and not paths.exists(path):
                    fault = Fault(
                        (dialect.name, setting.name), f"`{setting.name}` names `{path}`, which does not exist"
                    )
                    yield _message(origin, _text(origin), _prefix(origin), fault)


def _unreadable(config: Config, dialect: Dialect) -> Iterator[str]:
    """What is said of each file that is none of the sort that its setting names: the first fault in it."""
    from deburr import formats

    for setting in dialect.settings:
        path, _ = config.get(dialect.name, setting)
        if setting.kind is Kind.PATH and path and paths.is_file(path):
            fault = next(formats.faults(setting.name, paths.data(path).decode("utf-8", "replace")), None)
            if fault is not None:
                yield f"{path}:{fault.line + 1}: {fault.message}"


def _text(path: str) -> str:
    """The text of a configuration that was read before; none if it stands in no file."""
    try:
        return paths.data(path).decode("utf-8-sig")
    except OSError:
        return ""


def _prefix(path: str) -> tuple[str, ...]:
    """The tables in which a file's keys stand."""
    return ("tool", "deburr") if path.endswith(f"/{PROJECT}") else ()


def _extending(path: str, wrong: str) -> str:
    """What is said of a file's `extend`, with its place."""
    return _message(path, _text(path), _prefix(path), Fault(("extend",), f"`extend` {wrong}"))


def _data(path: str) -> dict[str, Any]:
    """What a file says; OSError if it cannot be read, ConfigError if it cannot be used."""
    import tomllib

    try:
        text = paths.data(path).decode("utf-8-sig")
        data: Any = tomllib.loads(text)
    except UnicodeDecodeError:
        raise ConfigError(f"{path}: not UTF-8, as TOML must be") from None
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(_placed(path, str(error))) from None
    except RecursionError:
        raise ConfigError(f"{path}: values are nested too deep to be a configuration") from None
    prefix = _prefix(path)
    if prefix:
        data = data.get("tool", {}).get("deburr", {})
    wrong = list(faults(data)) if isinstance(data, dict) else [Fault((), "`tool.deburr` must be a table")]
    if wrong:
        raise ConfigError(*(_message(path, text, prefix, fault) for fault in wrong))
    found: dict[str, Any] = data
    return found


def _config(data: Mapping[str, Any], path: str) -> Config:
    folder = paths.parent(path)
    check = data.get("check", {})
    select = check.get("select")
    layer = Selection(
        None if select is None else tuple(select), tuple(check.get("extend-select", ())), tuple(check.get("ignore", ()))
    )
    return Config(
        values=dict(_values(data, path)),
        layers=(layer,),
        files=tuple((Glob(folder, pattern, path), name) for pattern, name in data.get("files", {}).items()),
        ignores=tuple(
            (Glob(folder, pattern, path), tuple(names)) for pattern, names in check.get("per-file-ignores", {}).items()
        ),
        severities={
            name: Graded(None if word == "off" else Severity[word.upper()], path)
            for name, word in check.get("severity", {}).items()
        },
        origin=path,
    )


def _values(data: Mapping[str, Any], path: str) -> Iterator[tuple[str, Value]]:
    """The settings of the fixed and the dialects' tables, paths made absolute."""
    for names, schema in tables().items():
        given: Any = data
        for name in names:
            given = given.get(name, {})
        for setting in schema if not isinstance(schema, Free) else ():
            if setting.name in given:
                key = ".".join((*names, setting.name))
                yield key, Value(_useful(setting, given[setting.name], path), path)


def _useful(setting: Setting, value: Any, path: str) -> Any:
    """The value with lists as tuples and paths made absolute; an empty path stays empty."""
    if setting.kind is Kind.PATH:
        return _beside(path, value) if value else value
    if setting.kind is Kind.PATHS:
        return tuple(_beside(path, each) for each in value)
    return tuple(value) if setting.kind is Kind.LIST else value


def _beside(path: str, said: str) -> str:
    return paths.absolute(said, paths.parent(path))


def _has_table(path: str) -> bool:
    """Whether a project's file speaks of deburr at all; one that is not TOML is another tool's to complain about."""
    import tomllib

    try:
        data = paths.data(path)
        tool = tomllib.loads(data.decode()).get("tool") if b"deburr" in data else None
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(tool, dict) and "deburr" in tool


def _placed(path: str, error: str) -> str:
    """A TOML error with its place in front."""
    match = re.search(r" \(at line ([0-9]+), column ([0-9]+)\)$", error)
    if match is None:
        return f"{path}: {error}"
    return f"{path}:{match[1]}:{match[2]}: {error[: match.start()]}"


def _message(path: str, text: str, prefix: tuple[str, ...], fault: Fault) -> str:
    from deburr.formats.toml import line_of

    line = line_of(text, (*prefix, *fault.path))
    return f"{path}{f':{line}' if line else ''}: {fault.message}"
