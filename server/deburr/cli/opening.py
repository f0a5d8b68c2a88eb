"""A file that is named or found, read: its bytes as text, its configuration, the dialect that it is written in. Prints nothing."""

import sys
from typing import NamedTuple

from deburr import paths, source
from deburr.cli.files import STDIN, Target
from deburr.config import Config
from deburr.configfile import Configs
from deburr.detect import Answer, Hints, detect
from deburr.source import NotAProgram, Source
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name


class Opening(NamedTuple):
    """A program that was read, and what it is written in; ``name``: its absolute path, "" if it has none."""

    file: str
    name: str
    config: Config
    source: Source
    dialect: Dialect
    reason: str


class Unopened(NamedTuple):
    """Why a file was skipped (``reason``), or why that is a failure."""

    file: str
    reason: str = ""
    failure: str = ""


class Opener:
    """Reads files one by one. ``asked``: the dialect that the command line names; ``stdin_name``: the name of standard input."""

    def __init__(self, configs: Configs, asked: str | None, stdin_name: str | None = None) -> None:
        self._configs = configs
        self._asked = asked
        self._stdin_name = stdin_name

    def opened(self, target: Target) -> Opening | Unopened:
        """A file, read; ConfigError if its configuration names what is not there."""
        if target.failure:
            return Unopened(target.file, failure=target.failure)
        file, name = target.file, target.file
        if file == STDIN:
            name = paths.absolute(self._stdin_name) if self._stdin_name else ""
            file = name or STDIN
        try:
            data = paths.bounded(sys.stdin.buffer) if target.file == STDIN else paths.data(file)
        except OSError as error:
            return Unopened(file, failure=error.strerror or "cannot be read")
        config = self._configs.of(name) if name else self._configs.in_folder(paths.working_folder())
        return self._read(source.read(data), file, name, target.named, config)

    def _read(
        self, found: Source | NotAProgram, file: str, name: str, named: bool, config: Config
    ) -> Opening | Unopened:
        text = found.text if isinstance(found, Source) else ""
        answer = detect(name, text, hints(self._asked, name, config))
        if isinstance(found, NotAProgram) and (named or answer.dialect):
            return Unopened(file, failure=found.reason)
        if answer.dialect is None or isinstance(found, NotAProgram):
            way_out = f"{answer.reason}; say which with --dialect ({', '.join(NAMES)})"
            return Unopened(file, answer.reason, way_out if named else "")
        dialect = by_name(answer.dialect)
        self._configs.require(config, dialect)
        return Opening(file, name, config, found, dialect, answer.reason)


def hints(asked: str | None, file: str, config: Config) -> Hints:
    """What the command line and the configuration say of a file's dialect."""
    configured = config.dialect_of(file) if file else None
    if configured is None:
        return Hints(asked)
    name, glob = configured
    return Hints(asked, None, Answer(name, f"`{glob.pattern}` in [files] of {glob.origin}"))
