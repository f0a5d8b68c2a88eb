"""`deburr merge`: one report of the reports of several checks, such as the parts that `deburr check --shard` makes."""

import argparse
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from deburr import paths
from deburr.catalogue import rule_names
from deburr.cli.common import Help, unable
from deburr.cli.disk import Disk
from deburr.cli.output import add_output, outputs_of, written
from deburr.cli.result import Result
from deburr.cli.run import Outcome, texts
from deburr.config import ConfigError
from deburr.finding import Finding, Fix, Place, Related, Severity
from deburr.schema import LEVELS
from deburr.source import Source
from deburr_grammar.dialects import NAMES
from deburr_grammar.text import Edit, Pos


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = argparse.ArgumentParser(
        prog="deburr merge",
        description="Make one report of the reports of several checks. What they have in common is said once; the exit code is that of one check with these findings. A part that could not be checked has ended with 2, which its report does not hold.",
        epilog="example: deburr check --shard 1/2 --output-format json=1.json; deburr check --shard 2/2 --output-format json=2.json; deburr merge 1.json 2.json",
        formatter_class=Help,
        allow_abbrev=False,
    )
    found.add_argument("reports", nargs="+", metavar="REPORT", help="reports in the forms json or json-lines")
    found.add_argument(
        "--fail-on",
        choices=LEVELS,
        default="error",
        help="the least severity for which the exit code is 1 (default: error)",
    )
    found.add_argument("--exit-zero", action="store_true", help="exit 0 whatever is found")
    add_output(found)
    found.add_argument("--statistics", action="store_true", help="count the findings of each rule")
    found.add_argument("--baseline", metavar="FILE", help="pass over the findings that this file holds")
    found.add_argument(
        "--update-baseline",
        action="store_true",
        help="write all findings into the file of --baseline; the exit code is 0",
    )
    loudness = found.add_mutually_exclusive_group()
    loudness.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    loudness.add_argument("-v", "--verbose", action="store_true", help="also say what of the baseline is no more")
    return found


def run(arguments: argparse.Namespace) -> int:
    """Read, join and report."""
    try:
        outputs = outputs_of(arguments, statistics=arguments.statistics)
        if arguments.update_baseline and not arguments.baseline:
            raise ConfigError("--update-baseline: say with --baseline which file")
        result = _merged(arguments.reports, Severity[arguments.fail_on.upper()], any(e.form == "full" for e in outputs))
        if arguments.baseline:
            from deburr.cli.baseline import compared

            result = compared(result, arguments, whole=True)
    except ConfigError as error:
        return unable(error.messages)
    wrong = written(result, outputs, statistics=arguments.statistics, quiet=arguments.quiet)
    return unable([wrong]) if wrong else result.code(arguments.exit_zero)


def _merged(reports: Iterable[str], fail_on: Severity, loud: bool) -> Result:
    """The findings of all reports, each program's together. ``loud``: with the lines that are to be shown, as far as the programs lie here."""
    names = list(reports)
    found: dict[tuple[str, str], list[tuple[Finding, str]]] = {}
    for name in names:
        for said in _objects(name):
            try:
                finding, dialect, key = _finding(said), said["dialect"], said["fingerprint"].rpartition(":")[0]
            except (AttributeError, KeyError, TypeError, ValueError):
                raise ConfigError(_none(name)) from None
            if finding.rule not in _rules(dialect):
                raise ConfigError(f"{name}: `{finding.rule}` is no rule of this version of deburr")
            found.setdefault((finding.place.file, dialect), []).append((finding, key))
    disk = Disk()
    outcomes = []
    for (file, dialect), pairs in sorted(found.items()):
        findings, keys = zip(*pairs)
        shown = texts(findings, file, Source(disk.read(file) or ""), disk) if loud else ()
        outcomes.append(Outcome(file, dialect, "", findings, fail_on, texts=shown, keys=keys))
    return Result(tuple(outcomes), origin=f"{len(names)} report{'' if len(names) == 1 else 's'}")


@cache
def _rules(dialect: str) -> frozenset[str]:
    return frozenset(rule_names(dialect) if dialect in NAMES else ())


def _objects(name: str) -> list[Any]:
    """What a report holds, a list or an object a line."""
    from json import loads

    try:
        text = paths.data(name).decode("utf-8-sig")
        found = (
            loads(text) if text.lstrip().startswith("[") else [loads(line) for line in text.split("\n") if line.strip()]
        )
    except OSError as error:
        raise ConfigError(f"{name}: {error.strerror}") from None
    except (ValueError, RecursionError):
        raise ConfigError(_none(name)) from None
    if not isinstance(found, list):
        raise ConfigError(_none(name))
    return found


def _none(name: str) -> str:
    return f"{name}: no report of `deburr check --output-format json` or json-lines"


def _finding(said: Any) -> Finding:
    """A finding as a report has it; an error of a builtin kind if it has none."""
    related = tuple(
        Related(_place(each, each["filename"]), str(each["message"]), bool(each["entered"])) for each in said["related"]
    )
    fix, severity = said["fix"], Severity[said["severity"].upper()]
    return Finding(
        str(said["rule"]),
        severity,
        str(said["message"]),
        _place(said, said["filename"]),
        related,
        None if fix is None else Fix(str(fix["message"]), tuple(_edits(fix["edits"])), fix["applicability"] == "safe"),
    )


def _edits(said: Iterable[Any]) -> Iterator[Edit]:
    for each in said:
        _, line, col, end_line, end_col = _place(each, "")
        yield Edit(Pos(line, col), Pos(end_line, end_col), str(each["content"]))


def _place(said: Any, file: str) -> Place:
    start, end = said["location"], said["end_location"]
    numbers = (start["row"], start["column"], end["row"], end["column"])
    if not isinstance(file, str) or any(type(number) is not int or number < 1 for number in numbers):
        raise ValueError
    return Place(file, *(number - 1 for number in numbers))
