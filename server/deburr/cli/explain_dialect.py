"""`deburr explain-dialect`: which dialect a file is written in, and why."""

import argparse
import sys

from deburr import paths, source
from deburr.cli.arguments import Parser
from deburr.cli.common import add_config, add_dialect, unable
from deburr.cli.files import STDIN
from deburr.cli.opening import hints
from deburr.config import ConfigError
from deburr.configfile import Configs
from deburr.detect import Answer, detect
from deburr.source import NotAProgram


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr explain-dialect",
        description="Say which dialect a file is written in, and why. Exits 1 if none answers.",
    )
    found.add_argument("file", metavar="FILE", help="the file, or - for standard input")
    add_dialect(found)
    add_config(found)
    return found


def run(arguments: argparse.Namespace) -> int:
    """Print the answer."""
    said = arguments.file
    try:
        data = paths.bounded(sys.stdin.buffer) if said == STDIN else paths.data(said)
        answer = _answer(said, data, arguments)
    except OSError as error:
        return unable([f"{said}: {error.strerror or 'cannot be read'}"])
    except ConfigError as error:
        return unable(error.messages)
    if answer is None:
        return 2
    print(f"{said}: {answer.dialect or 'no dialect'} ({answer.reason})")
    return 0 if answer.dialect else 1


def _answer(said: str, data: bytes, arguments: argparse.Namespace) -> Answer | None:
    found = source.read(data)
    if isinstance(found, NotAProgram):
        unable([f"{said}: {found.reason}"])
        return None
    file = "" if said == STDIN else paths.absolute(said)
    configs = Configs(only=arguments.config)
    return detect(file, found.text, hints(arguments.dialect, file, configs.of(file or paths.absolute(STDIN))))
