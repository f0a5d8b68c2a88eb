"""`deburr expand`: the flat program that a control would execute."""

import argparse
import sys
from collections.abc import Mapping
from tempfile import TemporaryFile
from typing import Any

from deburr import paths
from deburr.cli.arguments import Parser
from deburr.cli.checkoptions import profile
from deburr.cli.common import add_config, add_dialect, complain, unable
from deburr.cli.files import STDIN
from deburr.cli.flat import Flat, Terms, flat_of, opened_programs
from deburr.cli.inputs import add_inputs, add_reached_only, inputs_for, inputs_of, known, named_files, settings
from deburr.config import Config, ConfigError, from_command_line
from deburr.configfile import Configs
from deburr.expand import Budget
from deburr.expand.job import EXACT
from deburr.selection import Selection

EOLS = {"lf": "\n", "crlf": "\r\n", "source": ""}


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr expand",
        description="Print the flat program that a control would execute. Several files are joined in order.",
    )
    found.add_argument(
        "files", nargs="+", metavar="FILE", help="a program, or - for standard input; a named pipe is refused"
    )
    found.add_argument("-o", "--output", metavar="FILE", help="where the flat program goes (default: standard output)")
    add_dialect(found)
    found.add_argument("--profile", metavar="P", help="whose manual decides, in dialects that have profiles")
    add_config(found)
    add_inputs(found)
    add_reached_only(found)
    found.add_argument("--source-map", metavar="FILE", help="write where each flat line comes from (Source Map v3)")
    found.add_argument("--partial", action="store_true", help="write what was produced before a fault, too")
    found.add_argument("--keep-n", action="store_true", help="keep line numbers")
    found.add_argument("--decimals", type=_decimals, metavar="N", help="at most so many in computed values, or `exact`")
    found.add_argument("--eol", choices=tuple(EOLS), default="source", help="line ends (default: as in the source)")
    limits = Budget()
    found.add_argument("--max-steps", type=count, default=limits.steps, metavar="N", help="executed lines; 0: no limit")
    found.add_argument("--max-blocks", type=count, default=limits.blocks, metavar="N", help="flat lines; 0: no limit")
    found.add_argument(
        "--stats",
        choices=("text", "json"),
        help="print bounds, lengths, estimated times and tools of the flat program in its place; with -o it is written, too",
    )
    found.add_argument("--diff", metavar="OTHER", help="compare the flat programs of both; exit 1 if they differ")
    found.add_argument("-q", "--quiet", action="store_true", help="no warnings")
    return found


def run(arguments: argparse.Namespace) -> int:
    """Expand and write."""
    try:
        terms = _terms(arguments)
        configs = Configs(configuration(arguments), arguments.config)
        programs = opened_programs(arguments.files, arguments.dialect, configs)
        others = opened_programs([arguments.diff], arguments.dialect, configs) if arguments.diff else ()
        known(arguments, programs[0].dialect)
        terms = terms._replace(inputs=inputs_for(terms.inputs, arguments.variables, programs[0].dialect))
        distinct(arguments, {"-o": arguments.output, "--source-map": arguments.source_map})
        if arguments.diff and (arguments.output or arguments.source_map):
            raise ConfigError("--diff writes no flat program: leave -o and --source-map out")
        if arguments.diff and arguments.stats:
            raise ConfigError("--diff and --stats both print in place of the flat program: choose one")
    except ConfigError as error:
        return unable(error.messages)
    try:
        with TemporaryFile() as lines, TemporaryFile() as other_lines:
            flat = flat_of(programs, terms, lines)
            if others:
                return _compared(flat, flat_of(others, terms, other_lines))
            return flat.written(arguments.output, arguments.source_map, arguments.stats)
    except ConfigError as error:
        return unable(error.messages)
    except OSError as error:
        return unable([f"{error.filename or 'the flat program'}: {error.strerror}"])


def configuration(arguments: argparse.Namespace) -> Config:
    """What the command line says above all configuration files."""
    values: Mapping[str, Any] = {**dict(settings(arguments)), **profile(arguments.profile)}
    return from_command_line(values, Selection(None, (), ()))


def _terms(arguments: argparse.Namespace) -> Terms:
    inputs = inputs_of(arguments)._replace(
        keep_n=arguments.keep_n,
        decimals=arguments.decimals,
        partial=arguments.partial,
        reached_only=arguments.reached_only,
    )
    budget = Budget(arguments.max_steps, arguments.max_blocks)
    mapped = bool(arguments.source_map or arguments.diff)
    return Terms(inputs, budget, EOLS[arguments.eol], arguments.quiet, mapped)


def distinct(arguments: argparse.Namespace, written: Mapping[str, str | None]) -> None:
    """Refuse to write over what is read, or two things into one file. ``written``: the files of options."""
    read = (*arguments.files, *named_files(arguments), arguments.config or STDIN)
    taken = {paths.real(file): file for file in read if file != STDIN}
    for option, path in written.items():
        if path is None:
            continue
        if not path:
            raise ConfigError(f"{option}: the name of the file is empty")
        if paths.real(path) in taken:
            raise ConfigError(f"{option} {path}: that would write over {taken[paths.real(path)]}")
        taken[paths.real(path)] = path


def _compared(one: Flat, other: Flat) -> int:
    from deburr.cli.difference import difference

    for flat in (one, other):
        if not flat.whole:
            return 1
    changed = False
    for line in difference(one, other):
        sys.stdout.write(f"{line}\n")
        changed = True
    if not changed:
        complain("the flat programs are the same", "")
    return int(changed)


def _decimals(said: str) -> int:
    if said == "exact":
        return EXACT
    if not said.isascii() or not said.isdigit() or int(said) > 15:
        raise argparse.ArgumentTypeError(f"`{said}` is neither a number from 0 to 15 nor `exact`")
    return int(said)


def count(said: str) -> int:
    """A number of lines from the command line."""
    if not said.isascii() or not said.isdigit():
        raise argparse.ArgumentTypeError(f"`{said}` is no number of lines")
    return int(said)
