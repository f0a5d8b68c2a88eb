"""Where reports go and in which form. Checks nothing."""

import argparse
import sys
from collections.abc import Sequence
from typing import NamedTuple, TextIO

from deburr import paths
from deburr.cli import reporters
from deburr.cli.result import Result
from deburr.cli.style import Style, style_for
from deburr.config import ConfigError
from deburr.suggest import suggestion


class Output(NamedTuple):
    """A form of report and the file that it goes to; "" is standard output."""

    form: str
    file: str


def add_output(found: argparse.ArgumentParser) -> None:
    """`--output-format` and `--output-file`."""
    found.add_argument(
        "--output-format",
        type=_output,
        action="append",
        metavar="FORMAT[=FILE]",
        help=f"{', '.join(reporters.names())} (default: full); repeatable, each with a file of its own",
    )
    found.add_argument("--output-file", metavar="FILE", help="where the report goes that has no file of its own")


def outputs_of(arguments: argparse.Namespace, *, statistics: bool = False) -> list[Output]:
    """The reports that are asked for; ConfigError if two go to one place, or one has no form for what it is to hold."""
    outputs = arguments.output_format or [Output("full", "")]
    outputs = [Output(each.form, each.file or arguments.output_file or "") for each in outputs]
    places = [each.file for each in outputs]
    twice = next((place for place in places if places.count(place) > 1), None)
    if twice is not None:
        raise ConfigError(f"--output-format: two reports go to {twice or 'standard output'}; write FORMAT=FILE")
    silent = [each.form for each in outputs if not hasattr(reporters.by_name(each.form), "statistics")]
    if statistics and silent:
        raise ConfigError(f"--statistics: {silent[0]} has no form for them")
    return outputs


def keyed(outputs: Sequence[Output]) -> bool:
    """Whether a report names fingerprints."""
    return any(getattr(reporters.by_name(each.form), "KEYED", False) for each in outputs)


def written(result: Result, outputs: Sequence[Output], *, statistics: bool = False, quiet: bool = False) -> str:
    """Write the reports; what is wrong if one cannot be written."""
    try:
        for output in outputs:
            _write(result, output, statistics, quiet)
    except OSError as error:
        return f"{error.filename or 'standard output'}: {error.strerror}"
    return ""


def _write(result: Result, output: Output, statistics: bool, quiet: bool) -> None:
    if not output.file:
        piped = [outcome.data for outcome in result.outcomes if outcome.data]
        for data in piped:
            sys.stdout.buffer.write(data)
        # Where a program goes to standard output nothing else may.
        out = sys.stderr if piped else sys.stdout
        _report(result, output.form, statistics, quiet, out, style_for(out))
        return
    from io import TextIOWrapper

    from deburr.cli.replacing import replacing

    with replacing(output.file) as raw, TextIOWrapper(raw, encoding="utf-8", newline="\n") as out:
        _report(result, output.form, statistics, quiet, out, Style(False, paths.working_folder()))


def _report(result: Result, form: str, statistics: bool, quiet: bool, out: TextIO, style: Style) -> None:
    reporter = reporters.by_name(form)
    if statistics:
        reporter.statistics(result.statistics(), out, style)
    else:
        reporter.report(result, out, style)
    if reporter.TEXT and not quiet:
        out.write(f"{result.summary()}\n")


def _output(said: str) -> Output:
    form, _, file = said.partition("=")
    if form not in reporters.names():
        raise argparse.ArgumentTypeError(f"`{form}` is no format{suggestion(form, reporters.names())}")
    return Output(form, file)
