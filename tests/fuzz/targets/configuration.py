"""Configuration: files, an editor's settings, patterns of paths. It is used or refused with its place, and patterns cost little."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from deburr import paths
from deburr.cli.config import lines
from deburr.config import Config, ConfigError, Glob, made, settings_of
from deburr.configfile import FILE, PROJECT, Configs, given, read
from deburr.lsp.client import client_of
from deburr.patterns import spec
from deburr_grammar.dialects import NAMES, by_name
from fuzz.choices import Choices, joined

_PROGRAM = "posts/old/part 1.ngc"


@cache
def _folder() -> TemporaryDirectory[str]:
    return TemporaryDirectory(prefix="deburr-fuzz-")


def run(data: bytes) -> None:
    """What is configured, and how."""
    choices = Choices(data)
    way = choices.pick((_file, _project, _settings, _patterns, _initialize))
    way(choices)


def _file(choices: Choices, name: str = FILE) -> None:
    path = Path(_folder().name).resolve() / name.partition(".")[0] / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(choices.rest())
    place = path.as_posix()
    try:
        config = read(place)
    except ConfigError as error:
        assert error.messages
        assert all(message.startswith(place) for message in error.messages), error.messages
        return
    _used(config)
    assert name == PROJECT or Configs().in_folder(paths.parent(place)).origin == place


def _project(choices: Choices) -> None:
    _file(choices, PROJECT)


def _settings(choices: Choices) -> None:
    """What an editor says, as JSON."""
    try:
        said = json.loads(choices.rest())
    except (ValueError, RecursionError):
        return
    if isinstance(said, dict):
        try:
            _used(given(said, _folder().name, "the editor"))
        except ConfigError as error:
            assert all(message.startswith("the editor: ") for message in error.messages)


def _used(config: Config) -> None:
    """All that is configured can be asked for."""
    file = paths.join(_folder().name, _PROGRAM)
    assert config.fail_on
    config.dialect_of(file)
    ignored = config.ignored(file)
    for name in NAMES:
        dialect = by_name(name)
        made(dialect, config, ignored)
        assert settings_of(dialect, config).keys() == {setting.name for setting in dialect.settings}
    tomllib.loads("\n".join(lines(config)))


def _patterns(choices: Choices) -> None:
    """Lines of a `.gitignore`, all together and each as a pattern of a configuration; paths that they are tried on."""
    said = choices.text().split("\n")
    tried = [_PROGRAM, *filter(None, choices.text().split("\n"))]
    found = spec(said)
    for path in tried:
        found.match_file(path)
    for line in said:
        assert Glob("/job", line, "").matches(f"/job/{_PROGRAM}") in (True, False)


def _initialize(choices: Choices) -> None:
    """What a client says of itself, as JSON."""
    try:
        said = json.loads(choices.rest())
    except (ValueError, RecursionError):
        return
    assert client_of(said).encoding in ("utf-8", "utf-16", "utf-32")


_FULL = """extend = ""
[files]
"posts/**/*.ngc" = "rs274"
"!*.txt" = "cgt"
[check]
select = ["ALL"]
ignore = ["rs274.comment-nested", "z32"]
fail-on = "warning"
run = false
[check.severity]
"rs274.limit" = "off"
[check.per-file-ignores]
"posts/**" = ["rs274"]
[format]
indent = 4
indent-style = "tab"
[machine]
limits = { X = [0, 300], Z = [-20, 50.5] }
z-safe = 5
rapid = { X = 1000 }
unit = "inch"
[editor.inlay-hints]
values = false
[rs274]
subroutines = ["a", "../b"]
[metagcode]
variables = "a.vars"
[cgt]
input = "a.cl"
[z32]
file-root = "/"
"""


def seeds() -> Iterator[bytes]:
    """A file with every table, the same with faults, as a project's, as an editor's settings; patterns."""
    yield joined((0,), _FULL)
    yield joined((0,), _FULL.replace("=", "= -", 9).replace("select", "selct"))
    yield joined((0,), b"\xef\xbb\xbf[check]\nrun = 1\n[machine]\nlimits = { Q = [3, 1], X = 7 }\n")
    yield joined((1,), "[tool.deburr.check]\nselect = []\n[tool.other]\na = 1\n")
    yield joined((1,), "[tool]\ndeburr = 3\n")
    yield joined((2,), json.dumps(tomllib.loads(_FULL)))
    yield joined(
        (3,), "*.ngc\n!part*\n/posts/**/old\n[a-z]*.t?t\n\\#x\n# words\na/**\n**/b/\n***a*b*", "posts/a.txt\na/b/c"
    )
    yield joined(
        (4,),
        '{"capabilities": {"general": {"positionEncodings": ["utf-8"]}, "textDocument": {"diagnostic": {}}}, "workspaceFolders": [{"uri": "file:///a", "name": "a"}], "processId": 1, "trace": "verbose", "initializationOptions": {"deburr": {"check": {}}}}',
    )
