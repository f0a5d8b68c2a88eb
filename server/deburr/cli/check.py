"""`deburr check`: lint files, folders or standard input."""

import argparse
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from deburr import paths
from deburr.cli.arguments import UNABLE
from deburr.cli.checkoptions import parser, top
from deburr.cli.common import complain, unable
from deburr.cli.files import STDIN, Target, targets
from deburr.cli.inputs import inputs_of
from deburr.cli.output import Output, keyed, outputs_of, written
from deburr.cli.result import Result
from deburr.cli.run import Checker, Fixes, Options, Outcome, outcomes
from deburr.cli.style import Style
from deburr.config import ConfigError
from deburr.configfile import Configs

if TYPE_CHECKING:
    from deburr.cli.cache import Cache

__all__ = ["parser", "run"]

_WORTH_FORKING = 2_000_000
"""Bytes below which more processes cost more than they save."""
_WORTH_KEEPING = 64_000
"""Bytes of a single program below which to look for its result costs about what a check costs."""


def run(arguments: argparse.Namespace) -> int:
    """Check and report; again and again if that is asked for."""
    try:
        _consistent(arguments)
        if arguments.watch:
            from deburr.cli.watch import watched

            return watched(arguments, partial(_checked, arguments))
        return _checked(arguments)
    except ConfigError as error:
        return unable(error.messages)


def _checked(arguments: argparse.Namespace, heard: Callable[[Sequence[Outcome]], None] | None = None) -> int:
    """Check and report once; the exit code. ``heard`` is told of the outcomes, and what they hang on."""
    outputs = outputs_of(arguments, statistics=arguments.statistics)
    configs = Configs(top(arguments), arguments.config)
    found = _targets(arguments, configs)
    _distinct(outputs, found)
    cache = _cache(arguments, found, configs)
    options = _options(arguments, outputs, cache)._replace(asked=heard is not None)
    work = outcomes(Checker(configs, options, cache), found, partial(_processes, arguments.jobs))
    if len(found) > 1 and not arguments.quiet and sys.stderr.isatty():
        from deburr.cli.progress import shown

        work = shown(work, len(found))
    made = tuple(work)
    if heard is not None:
        heard(made)
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
    if arguments.watch and (arguments.fix or arguments.diff or STDIN in arguments.paths or arguments.stdin_filename):
        raise ConfigError("--watch: watches files and changes none; leave out --fix, --diff and standard input")
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


def _options(arguments: argparse.Namespace, outputs: Sequence[Output], cache: "Cache | None") -> Options:
    loud = any(each.form == "full" for each in outputs)
    fixes = Fixes(arguments.unsafe_fixes, arguments.diff) if arguments.fix or arguments.diff else None
    # What is kept serves every form of report.
    keys = cache is not None or bool(arguments.baseline) or keyed(outputs)
    return Options(
        arguments.dialect, arguments.stdin_filename, loud, inputs_of(arguments), arguments.variables, fixes, keys
    )


def _cache(arguments: argparse.Namespace, found: Sequence[Target], configs: Configs) -> "Cache | None":
    """Where results are kept; nowhere if that costs more than it saves, or if programs are changed."""
    changes = arguments.fix or arguments.diff
    if arguments.no_cache or changes or any(target.file == STDIN for target in found):
        return None
    if len(found) < 2 and sum(paths.size(target.file) for target in found) < _WORTH_KEEPING:
        return None
    from deburr.cli.cache import opened

    here = paths.working_folder()
    home = paths.parent(configs.in_folder(here).origin)
    return opened(home if home and f"{here}/".startswith(f"{home.rstrip('/')}/") else here)


def _compared(made: tuple[Outcome, ...], arguments: argparse.Namespace) -> Result:
    """The result without what a baseline holds, which is written anew if that is asked for."""
    result = Result(made, shard=arguments.shard)
    if not arguments.baseline:
        return result
    from deburr.cli.baseline import compared

    return compared(result, arguments)


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
            kept = ", known from an earlier check" if outcome.kept else ""
            complain(f"{name}: {outcome.dialect} ({outcome.reason}), {origin}{kept}", "")
            for aside in outcome.asides:
                complain(f"{name}: {aside.what} {style.file(aside.file)}:{aside.line + 1}: {aside.why}", "")


def _processes(asked: int | None, found: Sequence[Target]) -> int:
    if asked is not None or len(found) < 2:
        return asked or 1
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    size = sum(paths.size(target.file) for target in found if target.file != STDIN and not target.failure)
    return cores if size >= _WORTH_FORKING else 1
