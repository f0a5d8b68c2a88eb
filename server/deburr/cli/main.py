"""The entry point: finds the command and runs it. Loads no other command."""

import argparse
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import NoReturn

from deburr import __version__
from deburr.cli import streams
from deburr.cli.arguments import UNABLE, Parser

COMMANDS = {
    "check": "lint files, folders or standard input",
    "merge": "one report of the reports of several checks",
    "expand": "print the flat program that a control would execute",
    "plot": "draw the toolpath: SVG, PNG, or a page to turn and click on",
    "format": "lay out files, folders or standard input; what they say is never changed",
    "rule": "what a rule means, with a bad and a good example",
    "explain-dialect": "which dialect a file is written in, and why",
    "config": "the effective configuration of a file and where each value comes from",
    "server": "the language server, for editors",
    "init": "write a commented deburr.toml into this folder",
}
INTERRUPTED = 130


def run() -> NoReturn:
    """Run the command of this process and end it at once: to take apart what a check has built would be a seventh of a small check.

    A reader who goes early changes no exit code: it is still that of what was found.
    """
    streams.prepare()
    try:
        code = main()
    except SystemExit as leaving:
        code = int(leaving.code or 0)
    if lost := streams.failure():
        print(f"deburr: error: {lost}", file=sys.stderr, flush=True)
        code = UNABLE
    os._exit(code)


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; the exit code."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    # Modules and trees are made to be kept: to look for garbage among them would take a tenth of a small check.
    gc.set_threshold(100_000, 20, 20)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        code = _run(arguments)
        sys.stdout.flush()
        return code
    except KeyboardInterrupt:
        return INTERRUPTED


def _run(arguments: list[str]) -> int:
    if arguments and arguments[0] in COMMANDS:
        command = import_module(f"deburr.cli.{arguments[0].replace('-', '_')}")
        code: int = command.run(command.parser().parse_args(arguments[1:]))
        return code
    parser = _parser()
    if not arguments:
        parser.print_help(sys.stderr)
        return UNABLE
    if not arguments[0].startswith("-"):
        from deburr.suggest import suggestion

        parser.error(f"unknown command `{arguments[0]}`{suggestion(arguments[0], COMMANDS)}")
    parser.parse_args(arguments)
    return UNABLE


def _parser() -> argparse.ArgumentParser:
    width = max(map(len, COMMANDS))
    commands = "\n".join(f"  {name:<{width}}  {text}" for name, text in COMMANDS.items())
    parser = Parser(
        prog="deburr",
        usage="deburr COMMAND ...",
        description="Takes the burrs off parametric CNC code.",
        epilog=f"commands:\n{commands}\n\n`deburr COMMAND --help` says more.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"deburr {__version__}")
    return parser
