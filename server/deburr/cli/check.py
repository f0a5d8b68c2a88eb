"""`deburr check`: lint files, folders or standard input."""

import argparse
import os
import sys
from collections.abc import Iterable, Sequence

from deburr import paths
from deburr.cli.checkoptions import parser, top
from deburr.cli.common import complain, unable
from deburr.cli.files import STDIN, Target, targets
from deburr.cli.inputs import inputs_of
from deburr.cli.main import UNABLE
from deburr.cli.output import Output, keyed, outputs_of, written
from deburr.cli.result import Result
from deburr.cli.run import Checker, Fixes, Options, Outcome, outcomes
from deburr.cli.style import Style
from deburr.config import ConfigError
from deburr.configfile import Configs

__all__ = ["parser", "run"]

_WORTH_FORKING = 2_000_000
"""Bytes below which more processes cost more than they save."""


def run(arguments: argparse.Namespace) -> int:
    """Check and report."""
    try:
        return _checked(arguments)
    except ConfigError as error:
        return unable(error.messages)


def _checked(arguments: argparse.Namespace) -> int:
    outputs = outputs_of(arguments, statistics=arguments.statistics)
    _consistent(arguments)
    configs = Configs(top(arguments), arguments.config)
    found = _targets(arguments, configs)
    _distinct(outputs, found)
    options = _options(arguments, outputs)
    made = tuple(outcomes(Checker(configs, options), found, _processes(arguments.jobs, found)))
    if wrong := Result(made).misgiven:
        return unable([wrong])
    if not found:
        complain("no programs found under the given paths", "warning")
    _say(made, arguments.verbose)
    if arguments.diff:
        return _show(Result(made), arguments.quiet)
    result = _compared(made, arguments)
    wrong = written(result, outputs, statistics=arguments.statistics, quiet=arguments.quiet)
    return unable([wrong]) if wrong else result.code(arguments.exit_zero)


def _consistent(arguments: argparse.Namespace) -> None:
    """Refuse options that say nothing without another, or that contradict each other."""
    if arguments.update_baseline and not arguments.baseline:
        raise ConfigError("--update-baseline: say with --baseline which file")
    if arguments.update_baseline and arguments.shard:
        raise ConfigError("--update-baseline: a part does not know what the others found; give it to `deburr merge`")
    if arguments.baseline:
        from deburr.cli.baseline import load

        # Here, so that nobody waits for a check that has nothing to be compared with.
        load(arguments.baseline, new=arguments.update_baseline)


def _targets(arguments: argparse.Namespace, configs: Configs) -> list[Target]:
    given = arguments.paths or ([STDIN] if arguments.stdin_filename else ["."])
    found = targets(given, configs)
    if arguments.shard:
        found = found[arguments.shard.number - 1 :: arguments.shard.of]
    for target in found:
        # Here, so that a configuration that cannot be used is said before anything is reported.
        configs.of(target.file if target.file != STDIN else paths.absolute(arguments.stdin_filename or STDIN))
    return found


def _options(arguments: argparse.Namespace, outputs: Sequence[Output]) -> Options:
    loud = any(each.form == "full" for each in outputs)
    fixes = Fixes(arguments.unsafe_fixes, arguments.diff) if arguments.fix or arguments.diff else None
    keys = bool(arguments.baseline) or keyed(outputs)
    return Options(
        arguments.dialect, arguments.stdin_filename, loud, inputs_of(arguments), arguments.variables, fixes, keys
    )


def _compared(made: tuple[Outcome, ...], arguments: argparse.Namespace) -> Result:
    """The result without what a baseline holds, which is written anew if that is asked for."""
    if not arguments.baseline:
        return Result(made)
    from deburr.cli.baseline import compared

    return compared(Result(made), arguments)


def _show(result: Result, quiet: bool) -> int:
    """What fixes would change; the exit code."""
    changed = [outcome for outcome in result.outcomes if outcome.change]
    sys.stdout.writelines(outcome.change for outcome in changed)
    if not quiet:
        print(result.would_fix(), file=sys.stderr)
    failed = any(outcome.failure for outcome in result.outcomes)
    return UNABLE if failed else int(bool(changed))


def _distinct(outputs: Iterable[Output], found: Iterable[Target]) -> None:
    """Refuse to write a report over a program that is checked."""
    taken = {paths.real(target.file) for target in found if target.file != STDIN}
    for output in outputs:
        if output.file and paths.real(output.file) in taken:
            raise ConfigError(f"{output.file}: the report would be written over this program")


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
