"""One file from its bytes to an outcome, and many of them on several cores in the same order. Prints nothing."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from deburr import paths, source
from deburr.analysis import Analysis
from deburr.check import check
from deburr.cli.disk import Disk
from deburr.cli.files import STDIN, Target
from deburr.cli.inputs import inputs_for
from deburr.config import Config, RuleSets
from deburr.configfile import Configs
from deburr.detect import Answer, Hints, detect
from deburr.finding import Finding
from deburr.host import Host, NoFiles
from deburr.inputs import Inputs
from deburr.source import NotAProgram, Source
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import split_lines

AROUND = 2
"""Lines shown before and behind the line of a finding."""


class Outcome(NamedTuple):
    """What became of a file: findings, or why it was skipped (``dialect`` None), or why it could not be read (``failure``)."""

    file: str
    dialect: str | None = None
    reason: str = ""
    findings: tuple[Finding, ...] = ()
    fails: bool = False
    failure: str = ""
    origin: str = ""
    texts: tuple[tuple[tuple[str, int], str], ...] = ()
    misgiven: str = ""
    """What is wrong with a value that was given for the run; then nothing was run."""


class Options(NamedTuple):
    """What holds for all files: the dialect that was asked for, the name of standard input, whether lines are to be shown."""

    dialect: str | None = None
    stdin_name: str | None = None
    texts: bool = False
    inputs: Inputs = Inputs()
    values: str | None = None
    """The file that `--variables` names."""


class Checker:
    """Checks files one by one and keeps what they share: configurations, rule sets, files read."""

    def __init__(self, configs: Configs, options: Options) -> None:
        self._configs = configs
        self._options = options
        self._rulesets = RuleSets()
        self._disk = Disk()

    def outcome(self, target: Target) -> Outcome:
        """What becomes of a file."""
        if target.failure:
            return Outcome(target.file, failure=target.failure)
        file, name = target.file, target.file
        if file == STDIN:
            name = paths.absolute(self._options.stdin_name) if self._options.stdin_name else ""
            file = name or STDIN
        try:
            data = paths.bounded(sys.stdin.buffer) if target.file == STDIN else paths.data(file)
        except OSError as error:
            return Outcome(file, failure=error.strerror or "cannot be read")
        config = self._configs.of(name) if name else self._configs.in_folder(paths.working_folder())
        return self._checked(source.read(data), file, name, target.named, config)

    def _checked(self, found: Source | NotAProgram, file: str, name: str, named: bool, config: Config) -> Outcome:
        text = found.text if isinstance(found, Source) else ""
        answer = detect(name, text, hints(self._options.dialect, name, config))
        if isinstance(found, NotAProgram) and (named or answer.dialect):
            return Outcome(file, failure=found.reason)
        if answer.dialect is None or isinstance(found, NotAProgram):
            way_out = f"{answer.reason}; say which with --dialect ({', '.join(NAMES)})"
            return Outcome(file, reason=answer.reason, failure=way_out if named else "")
        dialect = by_name(answer.dialect)
        self._configs.require(config, dialect)
        host: Host = self._disk if name else NoFiles()
        ruleset = self._rulesets.of(dialect, config, name or file)
        run, inputs = _Runs(), inputs_for(self._options.inputs, self._options.values, dialect)
        runs = run if config.runs else None
        findings = check(found, dialect, ruleset, file, host, runs, inputs, mend=True)
        shown = texts(findings, file, found, host) if self._options.texts and findings else ()
        fails = any(finding.severity >= config.fail_on for finding in findings)
        return Outcome(
            file, dialect.name, answer.reason, tuple(findings), fails, "", config.origin, shown, run.misgiven
        )


class _Runs:
    """Runs a program. ``misgiven``: what is wrong with a value that was given for it."""

    def __init__(self) -> None:
        self.misgiven = ""

    def __call__(self, analysis: Analysis) -> list[Finding]:
        """What a run meets."""
        # Only programs without an error pay for the interpreters.
        from deburr.ran import Misgiven, ran

        try:
            return ran(analysis)
        except Misgiven as wrong:
            self.misgiven = str(wrong)
            return []


def hints(asked: str | None, file: str, config: Config) -> Hints:
    """What the command line and the configuration say of a file's dialect."""
    configured = config.dialect_of(file) if file else None
    if configured is None:
        return Hints(asked)
    name, glob = configured
    return Hints(asked, None, Answer(name, f"`{glob.pattern}` in [files] of {glob.origin}"))


def outcomes(checker: Checker, targets: Sequence[Target], jobs: int) -> Iterator[Outcome]:
    """The outcomes in the order of the targets, whatever the number of processes."""
    if jobs < 2 or len(targets) < 2 or any(target.file == STDIN for target in targets):
        yield from map(checker.outcome, targets)
        return
    from multiprocessing import Pool

    with Pool(min(jobs, len(targets)), _start, (checker,)) as pool:
        yield from pool.imap(_outcome, targets, max(1, min(4, len(targets) // (jobs * 32))))


_worker: list[Checker] = []


def _start(checker: Checker) -> None:
    """In a new process: an interrupt is the first process's to handle."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _worker[:] = [checker]


def _outcome(target: Target) -> Outcome:
    return _worker[0].outcome(target)


def texts(findings: Iterable[Finding], file: str, found: Source, host: Host) -> tuple[tuple[tuple[str, int], str], ...]:
    """The lines that a report of findings shows."""
    return tuple(dict(_texts(findings, file, found, host)).items())


def _texts(findings: Iterable[Finding], file: str, found: Source, host: Host) -> Iterator[tuple[tuple[str, int], str]]:
    """The lines that a report shows."""
    files: dict[str, list[str]] = {file: found.lines}
    for finding in findings:
        places = [finding.place, *(related.place for related in finding.related)]
        for place in places:
            if place.file not in files:
                files[place.file] = split_lines(host.read(place.file) or "")
            lines = files[place.file]
            for line in range(max(0, place.line - AROUND), min(len(lines), place.line + AROUND + 1)):
                yield (place.file, line), lines[line]
