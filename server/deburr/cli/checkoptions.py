"""The options of `deburr check`, and what they lay over all configuration. Checks nothing."""

import argparse
from typing import Any

from deburr.cli.arguments import Parser
from deburr.cli.common import Help, add_config, add_dialect
from deburr.cli.inputs import add_inputs, settings
from deburr.cli.output import add_output
from deburr.cli.result import Shard
from deburr.config import Config, ConfigError, from_command_line
from deburr.schema import LEVELS
from deburr.selection import Selection, unknown
from deburr.suggest import suggestion


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr check",
        description="Lint files, folders or standard input.",
        formatter_class=Help,
    )
    found.add_argument(
        "paths",
        nargs="*",
        metavar="PATH",
        help="files, folders (searched through, .gitignore respected) or - for standard input; a named pipe is refused, /dev/stdin and <(...) are read; default: this folder",
    )
    add_dialect(found)
    found.add_argument(
        "--profile", metavar="P", help="whose manual decides, in dialects that have profiles (rs274: linuxcnc, smithy)"
    )
    add_config(found)
    _add_rules(found, "--select", None, "rules or prefixes that are on, comma separated; ALL for all")
    _add_rules(found, "--extend-select", [], "rules or prefixes that are on besides")
    _add_rules(found, "--ignore", [], "rules or prefixes that are off")
    _add_report(found)
    _add_runs(found)
    _add_fixes(found)
    _add_archives(found)
    loudness = found.add_mutually_exclusive_group()
    loudness.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    loudness.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="also say, on stderr, how each file was read, where its run stopped, and what of its moves [machine] cannot judge",
    )
    return found


def _add_report(found: argparse.ArgumentParser) -> None:
    found.add_argument(
        "--fail-on", choices=LEVELS, help="the least severity for which the exit code is 1 (default: error)"
    )
    found.add_argument("--exit-zero", action="store_true", help="exit 0 whatever is found")
    add_output(found)
    found.add_argument(
        "--statistics", action="store_true", help="count the findings of each rule instead of showing them"
    )


def _add_runs(found: argparse.ArgumentParser) -> None:
    runs = found.add_mutually_exclusive_group()
    runs.add_argument(
        "--run",
        action="store_true",
        default=None,
        help="also report what a bounded run meets (default; `run` in [check])",
    )
    runs.add_argument("--no-run", action="store_false", dest="run", help="static analysis only")
    add_inputs(found)
    found.add_argument("--stdin-filename", metavar="PATH", help="the name that standard input goes by")


def _add_fixes(found: argparse.ArgumentParser) -> None:
    found.add_argument("--fix", action="store_true", help="mend what is safe to mend, and report what is left")
    found.add_argument("--unsafe-fixes", action="store_true", help="with --fix or --diff: also what is a guess")
    found.add_argument("--diff", action="store_true", help="write nothing; exit 1 and show what --fix would change")


def _add_archives(found: argparse.ArgumentParser) -> None:
    """What large and old archives need."""
    found.add_argument("--baseline", metavar="FILE", help="pass over the findings that this file holds")
    found.add_argument(
        "--update-baseline",
        action="store_true",
        help="write what is found into the file of --baseline, without what is mended; the exit code is 0",
    )
    found.add_argument(
        "--shard",
        type=_shard,
        metavar="K/N",
        help="only the K-th of N parts of the programs; `deburr merge` makes one report of the parts' reports (json or json-lines), which say of which part they are",
    )
    found.add_argument(
        "--no-cache",
        action="store_true",
        help="keep no results, and look up none; else they lie in .deburr_cache, or where DEBURR_CACHE_DIR says",
    )
    found.add_argument(
        "--watch",
        action="store_true",
        help="check again whenever a file changes, until interrupted (needs the library watchfiles)",
    )
    found.add_argument(
        "-j", "--jobs", type=_jobs, metavar="N", help="processes (default: as many as cores, if there is work for them)"
    )


def _add_rules(found: argparse.ArgumentParser, name: str, default: list[str] | None, text: str) -> None:
    found.add_argument(name, type=_rules, action="extend", default=default, metavar="RULES", help=text)


def top(arguments: argparse.Namespace) -> Config:
    """What the command line lays over all configuration."""
    values: dict[str, Any] = dict(settings(arguments))
    if arguments.fail_on is not None:
        values["check.fail-on"] = arguments.fail_on
    if arguments.run is not None:
        values["check.run"] = arguments.run
    select = None if arguments.select is None else tuple(arguments.select)
    selection = Selection(select, tuple(arguments.extend_select), tuple(arguments.ignore))
    return from_command_line({**values, **profile(arguments.profile)}, selection)


def profile(name: str | None) -> dict[str, str]:
    """The setting `profile` in each dialect that knows the one that was asked for."""
    if name is None:
        return {}
    from deburr_grammar.dialects import NAMES, by_name

    choices = {each: s.choices for each in NAMES for s in by_name(each).settings if s.name == "profile"}
    found = {f"{each}.profile": name for each, known in choices.items() if name in known}
    if not found:
        known = [word for each in choices.values() for word in each]
        raise ConfigError(f"--profile: no dialect has a profile `{name}`{suggestion(name, known)}")
    return found


def _rules(said: str) -> list[str]:
    names = [name.strip() for name in said.split(",")]
    names = [name for name in names if name] or [""]
    if wrong := next((message for name in names if (message := unknown(name))), None):
        raise argparse.ArgumentTypeError(wrong)
    return names


def _shard(said: str) -> Shard:
    number, _, count = said.partition("/")
    if not all(each.isascii() and each.isdigit() for each in (number, count)) or not 1 <= int(number) <= int(count):
        raise argparse.ArgumentTypeError(f"`{said}` is no part of several; write K/N, as 1/4")
    return Shard(int(number), int(count))


def _jobs(said: str) -> int:
    if not said.isascii() or not said.isdigit() or int(said) < 1:
        raise argparse.ArgumentTypeError(f"`{said}` is no number of processes")
    return int(said)
