"""What several commands share: options, and messages on stderr."""

import argparse
import os
import sys
from collections.abc import Iterable
from functools import cache

from deburr.cli.arguments import UNABLE
from deburr.suggest import suggestion
from deburr_grammar.dialects import NAMES


class Help(argparse.HelpFormatter):
    """Lays out help for the terminal there is. argparse's own loads four compressors to ask how wide it is, once for each option."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=_width())


@cache
def _width() -> int:
    try:
        return int(os.environ.get("COLUMNS", "")) - 2
    except ValueError:
        pass
    try:
        return os.get_terminal_size(sys.stdout.fileno()).columns - 2
    except (AttributeError, OSError, ValueError):
        return 78


def add_dialect(parser: argparse.ArgumentParser) -> None:
    """`--dialect`."""
    parser.add_argument("--dialect", type=_dialect, metavar="D", help=f"the language: {', '.join(NAMES)}")


def add_config(parser: argparse.ArgumentParser) -> None:
    """`--config`."""
    parser.add_argument("--config", metavar="FILE", help="this configuration file instead of the nearest one")


def complain(message: str, kind: str = "error") -> None:
    """A message on stderr."""
    print(f"deburr: {kind}: {message}" if kind else f"deburr: {message}", file=sys.stderr)


def unable(messages: Iterable[str]) -> int:
    """Say why the command cannot run; the exit code for that."""
    for message in messages:
        complain(message)
    return UNABLE


def _dialect(said: str) -> str:
    if said not in NAMES:
        raise argparse.ArgumentTypeError(f"`{said}` is no dialect{suggestion(said, NAMES)}")
    return said
