"""`deburr check`: lint files, folders or standard input."""

import argparse
import os
import sys
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, TextIO

from deburr import paths
from deburr.cli import reporters
from deburr.cli.common import Help, add_config, add_dialect, complain, unable
from deburr.cli.files import STDIN, Target, targets
from deburr.cli.inputs import add_inputs, inputs_of, settings
from deburr.cli.main import UNABLE
from deburr.cli.result import Result
from deburr.cli.run import Checker, Fixes, Options, Outcome, outcomes
from deburr.cli.style import Style, style_for
from deburr.config import Config, ConfigError, from_command_line
from deburr.configfile import Configs
from deburr.schema import LEVELS
from deburr.selection import Selection, unknown
from deburr.suggest import suggestion

_WORTH_FORKING = 2_000_000
"""Bytes below which more processes cost more than they save."""


class Output(NamedTuple):
    """A form of report and the file that it goes to; "" is standard output."""

    form: str
    file: str


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = argparse.ArgumentParser(
        prog="deburr check",
        description="Lint files, folders or standard input.",
        formatter_class=Help,
        allow_abbrev=False,
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
    found.add_argument(
        "--fail-on", choices=LEVELS, help="the least severity for which the exit code is 1 (default: error)"
    )
    _add_output(found)
    return found


def _add_output(found: argparse.ArgumentParser) -> None:
    found.add_argument("--exit-zero", action="store_true", help="exit 0 whatever is found")
    found.add_argument(
        "--output-format",
        type=_output,
        action="append",
        metavar="FORMAT[=FILE]",
        help=f"{', '.join(reporters.names())} (default: full); repeatable, each with a file of its own",
    )
    found.add_argument("--output-file", metavar="FILE", help="where the report goes that has no file of its own")
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
    found.add_argument("--fix", action="store_true", help="mend what is safe to mend, and report what is left")
    found.add_argument("--unsafe-fixes", action="store_true", help="with --fix or --diff: also what is a guess")
    found.add_argument("--diff", action="store_true", help="write nothing; exit 1 and show what --fix would change")
    found.add_argument(
        "--statistics", action="store_true", help="count the findings of each rule instead of showing them"
    )
    found.add_argument(
        "-j", "--jobs", type=_jobs, metavar="N", help="processes (default: as many as cores, if there is work for them)"
    )
    loudness = found.add_mutually_exclusive_group()
    loudness.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    loudness.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="also say, on stderr, how each file was read and where its run stopped",
    )


def _add_rules(found: argparse.ArgumentParser, name: str, default: list[str] | None, text: str) -> None:
    found.add_argument(name, type=_rules, action="extend", default=default, metavar="RULES", help=text)


def run(arguments: argparse.Namespace) -> int:
    """Check and report."""
    try:
        outputs, inputs = _outputs(arguments), inputs_of(arguments)
        configs = Configs(_top(arguments), arguments.config)
        given = arguments.paths or ([STDIN] if arguments.stdin_filename else ["."])
        found = targets(given, configs)
        for target in found:
            # Here, so that a configuration that cannot be used is said before anything is reported.
            configs.of(target.file if target.file != STDIN else paths.absolute(arguments.stdin_filename or STDIN))
        _distinct(outputs, found)
        loud = any(each.form == "full" for each in outputs)
        fixes = Fixes(arguments.unsafe_fixes, arguments.diff) if arguments.fix or arguments.diff else None
        keys = any(getattr(reporters.by_name(each.form), "KEYED", False) for each in outputs)
        options = Options(arguments.dialect, arguments.stdin_filename, loud, inputs, arguments.variables, fixes, keys)
        result = Result(tuple(outcomes(Checker(configs, options), found, _processes(arguments.jobs, found))))
    except ConfigError as error:
        return unable(error.messages)
    if wrong := result.misgiven:
        return unable([wrong])
    if not found:
        complain("no programs found under the given paths", "warning")
    _say(result.outcomes, arguments.verbose)
    if arguments.diff:
        return _show(result, arguments.quiet)
    try:
        for output in outputs:
            _write(result, output, arguments)
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            raise
        return unable([f"{error.filename or 'standard output'}: {error.strerror}"])
    return result.code(arguments.exit_zero)


def _show(result: Result, quiet: bool) -> int:
    """What fixes would change; the exit code."""
    changed = [outcome for outcome in result.outcomes if outcome.change]
    sys.stdout.writelines(outcome.change for outcome in changed)
    if not quiet:
        print(result.would_fix(), file=sys.stderr)
    failed = any(outcome.failure for outcome in result.outcomes)
    return UNABLE if failed else int(bool(changed))


def _top(arguments: argparse.Namespace) -> Config:
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


def _outputs(arguments: argparse.Namespace) -> list[Output]:
    outputs = arguments.output_format or [Output("full", "")]
    outputs = [Output(each.form, each.file or arguments.output_file or "") for each in outputs]
    places = [each.file for each in outputs]
    twice = next((place for place in places if places.count(place) > 1), None)
    if twice is not None:
        raise ConfigError(f"--output-format: two reports go to {twice or 'standard output'}; write FORMAT=FILE")
    silent = [each.form for each in outputs if not hasattr(reporters.by_name(each.form), "statistics")]
    if arguments.statistics and silent:
        raise ConfigError(f"--statistics: {silent[0]} has no form for them")
    return outputs


def _distinct(outputs: Iterable[Output], found: Iterable[Target]) -> None:
    """Refuse to write a report over a program that is checked."""
    taken = {paths.real(target.file) for target in found if target.file != STDIN}
    for output in outputs:
        if output.file and paths.real(output.file) in taken:
            raise ConfigError(f"{output.file}: the report would be written over this program")


def _write(result: Result, output: Output, arguments: argparse.Namespace) -> None:
    if not output.file:
        piped = [outcome.data for outcome in result.outcomes if outcome.data]
        for data in piped:
            sys.stdout.buffer.write(data)
        # Where a program goes to standard output nothing else may.
        out = sys.stderr if piped else sys.stdout
        _report(result, output.form, arguments, out, style_for(out))
        return
    with open(output.file, "w", encoding="utf-8", newline="\n") as out:  # noqa: PTH123  pathlib is not loaded for this.
        _report(result, output.form, arguments, out, Style(False, paths.working_folder()))


def _report(result: Result, form: str, arguments: argparse.Namespace, out: TextIO, style: Style) -> None:
    reporter = reporters.by_name(form)
    if arguments.statistics:
        reporter.statistics(result.statistics(), out, style)
    else:
        reporter.report(result, out, style)
    if reporter.TEXT and not arguments.quiet:
        out.write(f"{result.summary()}\n")


def _say(found: Iterable[Outcome], verbose: bool) -> None:
    """Messages about files: what could not be checked, and, if wanted, how the others were read."""
    style = Style(False, paths.working_folder())
    for outcome in found:
        name = style.file(outcome.file)
        if outcome.failure:
            complain(f"{name}: {outcome.failure}")
        elif verbose and outcome.dialect is None:
            complain(f"{name}: skipped, {outcome.reason}", "")
        elif verbose:
            origin = style.file(outcome.origin) if outcome.origin else "no configuration"
            complain(f"{name}: {outcome.dialect} ({outcome.reason}), {origin}", "")
            if (stop := outcome.stopped) is not None:
                complain(f"{name}: run stopped at {style.file(stop.file)}:{stop.line + 1}: {stop.why}", "")


def _processes(asked: int | None, found: Sequence[Target]) -> int:
    if asked is not None or len(found) < 2:
        return asked or 1
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    size = sum(paths.size(target.file) for target in found if target.file != STDIN and not target.failure)
    return cores if size >= _WORTH_FORKING else 1


def _rules(said: str) -> list[str]:
    names = [name.strip() for name in said.split(",")]
    names = [name for name in names if name] or [""]
    if wrong := next((message for name in names if (message := unknown(name))), None):
        raise argparse.ArgumentTypeError(wrong)
    return names


def _output(said: str) -> Output:
    form, _, file = said.partition("=")
    if form not in reporters.names():
        raise argparse.ArgumentTypeError(f"`{form}` is no format{suggestion(form, reporters.names())}")
    return Output(form, file)


def _jobs(said: str) -> int:
    if not said.isascii() or not said.isdigit() or int(said) < 1:
        raise argparse.ArgumentTypeError(f"`{said}` is no number of processes")
    return int(said)
