"""`deburr merge`: one report of the reports of several checks, such as the parts that `deburr check --shard` makes."""

import argparse
from collections.abc import Sequence

from deburr import paths
from deburr.catalogue import known_rules
from deburr.cli.arguments import Parser
from deburr.cli.common import Help, unable
from deburr.cli.disk import Disk
from deburr.cli.output import add_output, outputs_of, written
from deburr.cli.reports import Part, Report, read
from deburr.cli.result import Result
from deburr.cli.run import Outcome, texts
from deburr.config import ConfigError
from deburr.finding import Finding, Severity
from deburr.schema import LEVELS
from deburr.source import Source


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(
        prog="deburr merge",
        description="Make one report of the reports of several checks. What they have in common is said once; the exit code is that of one check with these findings. Reports of the parts of a check (--shard) say which parts they are and what could not be checked; if anything is missing, nothing is merged and the exit code is 2.",
        epilog="example: deburr check --shard 1/2 --output-format json=1.json; deburr check --shard 2/2 --output-format json=2.json; deburr merge 1.json 2.json",
        formatter_class=Help,
    )
    found.add_argument("reports", nargs="+", metavar="REPORT", help="reports in the forms json or json-lines")
    found.add_argument(
        "--fail-on",
        choices=LEVELS,
        default="error",
        help="the least severity for which the exit code is 1 (default: error)",
    )
    found.add_argument(
        "--incomplete",
        action="store_true",
        help="merge also where the report of a part is missing, or a part could not check all its programs",
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
        _distinct(arguments.reports)
        reports = [read(name) for name in arguments.reports]
        lacking = _lacking([part for each in reports for part in each.parts])
        if lacking and not arguments.incomplete:
            raise ConfigError(*lacking, "--incomplete merges what there is")
        result = merged(reports, Severity[arguments.fail_on.upper()], any(e.form == "full" for e in outputs))
        if arguments.baseline:
            from deburr.cli.baseline import compared

            result = compared(result, arguments, whole=True)
    except ConfigError as error:
        return unable(error.messages)
    wrong = written(result, outputs, statistics=arguments.statistics, quiet=arguments.quiet)
    return unable([wrong]) if wrong else result.code(arguments.exit_zero)


def _distinct(names: Sequence[str]) -> None:
    """Refuse a report that is given twice: another one was meant, or the count of reports would be wrong."""
    files = [paths.real(name) for name in names]
    twice = next((name for at, name in enumerate(names) if files[at] in files[:at]), None)
    if twice is not None:
        raise ConfigError(f"{twice}: this report is given twice")


def merged(reports: Sequence[Report], fail_on: Severity, loud: bool) -> Result:
    """The findings of all reports, each program's together. ``loud``: with the lines that are to be shown, as far as the programs lie here."""
    found: dict[tuple[str, str], list[tuple[Finding, str]]] = {}
    for report in reports:
        for finding, dialect, key in report.findings():
            if finding.rule not in known_rules(dialect):
                raise ConfigError(f"{report.name}: `{finding.rule}` is no rule of this version of deburr")
            found.setdefault((finding.place.file, dialect), []).append((finding, key))
    disk = Disk()
    outcomes = []
    for (file, dialect), pairs in sorted(found.items()):
        findings, keys = zip(*pairs)
        shown = texts(findings, file, Source(disk.read(file) or ""), disk) if loud else ()
        outcomes.append(Outcome(file, dialect, "", findings, fail_on, texts=shown, keys=keys))
    return Result(tuple(outcomes), origin=f"{len(reports)} report{'' if len(reports) == 1 else 's'}")


def _lacking(parts: Sequence[Part]) -> list[str]:
    """What the reports of parts do not hold of the whole check."""
    if not parts:
        return []
    counts = sorted({part.shard.of for part in parts})
    if len(counts) > 1:
        several = " and ".join(f"of {count} parts" for count in counts)
        return [f"the reports are of different checks: {several}"]
    there = {part.shard.number for part in parts}
    missing = [f"{number}/{counts[0]}" for number in range(1, counts[0] + 1) if number not in there]
    wrong = [f"the report of part {part} is missing; `deburr check --shard {part}` makes it" for part in missing]
    return wrong + [f"part {part.shard} could not check {why}" for part in parts for why in part.failed]
