"""One file from its bytes to an outcome, and many of them on several cores in the same order. Prints nothing."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from deburr import paths, source
from deburr.analysis import Analysis
from deburr.check import check
from deburr.cli.disk import Disk
from deburr.cli.files import STDIN, Target
from deburr.cli.inputs import inputs_for
from deburr.cli.opening import Opener, Opening, Unopened
from deburr.cli.style import Style
from deburr.config import ConfigError, RuleSets
from deburr.configfile import Configs
from deburr.finding import Finding, Severity
from deburr.host import Host, NoFiles
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr_grammar.dialects import by_name
from deburr_grammar.text import split_lines

if TYPE_CHECKING:
    from deburr.cli.cache import Cache
    from deburr.cli.kept import Keeper
    from deburr.ran import Aside

AROUND = 2
"""Lines shown before and behind the line of a finding."""

_ENDED = "a process that checked files was ended from outside, perhaps for want of memory; `-j 1` needs less of it"


class Outcome(NamedTuple):
    """What became of a file: findings, or why it was skipped (``dialect`` None), or why it could not be read (``failure``)."""

    file: str
    dialect: str | None = None
    reason: str = ""
    findings: tuple[Finding, ...] = ()
    fail_on: Severity = Severity.ERROR
    """The least severity that counts."""
    failure: str = ""
    origin: str = ""
    texts: tuple[tuple[tuple[str, int], str], ...] = ()
    misgiven: str = ""
    """What is wrong with a value that was given for the run; then nothing was run."""
    fixed: int = 0
    """Findings that fixes took away."""
    change: str = ""
    """What they would change, where that is only shown."""
    data: bytes = b""
    """Of standard input the program behind its fixes."""
    asides: "tuple[Aside, ...]" = ()
    """Where its run ended before the end, if it did in silence, and what of its moves is not certain."""
    keys: tuple[str, ...] = ()
    """By what each finding is known again; none if nobody asked."""
    kept: bool = False
    """Whether it was found by an earlier check."""
    asked: frozenset[str] = frozenset()
    """The files that were asked for, and the folders, with `/` at their ends; none if nobody wants to know."""


class Fixes(NamedTuple):
    """Which fixes are made, and whether they are only shown."""

    unsafe: bool = False
    shown: bool = False


class Options(NamedTuple):
    """What holds for all files: the dialect that was asked for, the name of standard input, whether lines are to be shown."""

    dialect: str | None = None
    stdin_name: str | None = None
    texts: bool = False
    inputs: Inputs = Inputs()
    values: str | None = None
    """The file that `--variables` names."""
    fixes: Fixes | None = None
    """Which fixes are made; None: none."""
    keys: bool = False
    """Whether findings are to be known again."""
    asked: bool = False
    """Whether outcomes are to say what they hang on."""


class Checker:
    """Checks files one by one and keeps what they share: configurations, rule sets, files read."""

    def __init__(self, configs: Configs, options: Options, cache: "Cache | None" = None) -> None:
        self._configs = configs
        self._opener = Opener(configs, options.dialect, options.stdin_name)
        self._options = options
        self._rulesets = RuleSets()
        self._disk = Disk()
        self._keeper: Keeper | None = None
        if cache is not None:
            from deburr.cli.kept import Keeper as Keeping

            self._keeper = Keeping(cache, self._disk, options)

    def kept(self, target: Target) -> Outcome | None:
        """What an earlier check found in a file, if nothing that decides it has changed."""
        if self._keeper is None or target.failure or target.file == STDIN:
            return None
        try:
            data = paths.data(target.file)
        except OSError:
            return None
        config = self._configs.of(target.file)
        outcome = self._keeper.find(self._keeper.name(target.file, data, config), target.file, config.fail_on)
        if outcome is None or outcome.dialect is None:
            return None
        self._configs.require(config, by_name(outcome.dialect))
        if self._options.texts and outcome.findings and isinstance(found := source.read(data), Source):
            return outcome._replace(texts=texts(outcome.findings, target.file, found, self._disk))
        return outcome

    def outcome(self, target: Target) -> Outcome:
        """What becomes of a file."""
        opening = self._opener.opened(target)
        if isinstance(opening, Unopened):
            return Outcome(opening.file, reason=opening.reason, failure=opening.failure)
        return self._checked(opening) if self._options.fixes is None else self._fixed(opening, target.file == STDIN)

    def _checked(self, opening: Opening) -> Outcome:
        file, name, config, found, dialect, reason = opening
        run, inputs = _Runs(), inputs_for(self._options.inputs, self._options.values, dialect)
        runs = run if config.runs else None
        ruleset, host = self._ruleset(opening), self._host(name)
        needs = None
        if self._keeper is not None or self._options.asked:
            from deburr.needs import Needs

            host = needs = Needs(host)
        findings = check(found, dialect, ruleset, file, host, runs, inputs, mend=True)
        shown = texts(findings, file, found, host) if self._options.texts and findings else ()
        keys = _keys(findings, file, found, host) if self._options.keys and findings else ()
        outcome = Outcome(
            file,
            dialect.name,
            reason,
            tuple(findings),
            config.fail_on,
            "",
            config.origin,
            shown,
            run.misgiven,
            asides=tuple(run.asides),
            keys=keys,
            asked=asked(needs.texts, needs.folders) if needs is not None else frozenset(),
        )
        if self._keeper is not None and needs is not None and name == file:
            self._keeper.keep(self._keeper.name(file, found.data, config), outcome, needs)
        return outcome

    def _fixed(self, opening: Opening, piped: bool) -> Outcome:
        """Mend a program, write or show it, and check what has become of it."""
        from deburr.cli.fixing import fixed
        from deburr.cli.rewriting import difference, saved

        fixes, before = self._options.fixes, opening.source
        assert fixes is not None
        ruleset, host = self._ruleset(opening), self._host(opening.name)
        runs = _Runs() if opening.config.runs else None
        inputs = inputs_for(self._options.inputs, self._options.values, opening.dialect)
        done = fixed(opening, ruleset, host, runs, inputs, unsafe=fixes.unsafe)
        outcome = self._checked(opening._replace(source=done.source))._replace(fixed=done.taken)
        if fixes.shown:
            name = Style(False, paths.working_folder()).file(opening.file)
            return outcome._replace(change="".join(difference(before.whole, done.source.whole, name)))
        if piped:
            return outcome._replace(data=done.source.data)
        failure = saved(opening.file, done.source) if done.taken else ""
        return outcome._replace(failure=failure, fixed=0 if failure else done.taken)

    def _ruleset(self, opening: Opening) -> RuleSet:
        return self._rulesets.of(opening.dialect, opening.config, opening.name or opening.file)

    def _host(self, name: str) -> Host:
        return self._disk if name else NoFiles()


def asked(texts: Iterable[str], folders: Iterable[str]) -> frozenset[str]:
    """What an outcome hangs on besides its program."""
    return frozenset((*texts, *(f"{folder.rstrip('/')}/" for folder in folders)))


class _Runs:
    """Runs a program. ``misgiven``: what is wrong with a value that was given for it; ``asides``: what is to be said of it beside findings."""

    def __init__(self) -> None:
        self.misgiven = ""
        self.asides: list[Aside] = []

    def __call__(self, analysis: Analysis) -> list[Finding]:
        """What a run meets."""
        # Only programs without an error pay for the interpreters.
        from deburr.ran import Misgiven, ran

        try:
            return ran(analysis, aside=self.asides.append)
        except Misgiven as wrong:
            self.misgiven = str(wrong)
            return []


def outcomes(
    checker: Checker, targets: Sequence[Target], processes: Callable[[Sequence[Target]], int]
) -> Iterator[Outcome]:
    """The outcomes in the order of the targets, whatever the number of processes, which depends on what is to be done."""
    kept = [checker.kept(target) for target in targets]
    wanted = [target for target, known in zip(targets, kept) if known is None]
    made = _made(checker, wanted, processes(wanted))
    for known in kept:
        yield known or next(made)


def _made(checker: Checker, targets: Sequence[Target], jobs: int) -> Iterator[Outcome]:
    if jobs < 2 or len(targets) < 2 or any(target.file == STDIN for target in targets):
        yield from map(checker.outcome, targets)
        return
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    # Processes are never ended from outside: one that is in the middle of a message would leave the others waiting for ever.
    with ProcessPoolExecutor(min(jobs, len(targets)), None, _start, (checker,)) as pool:
        try:
            yield from pool.map(_outcome, targets, chunksize=max(1, min(4, len(targets) // (jobs * 32))))
        except BrokenProcessPool:
            raise ConfigError(_ENDED) from None
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


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
    return tuple(dict(_texts(findings, file, found, host, AROUND)).items())


def _keys(findings: Iterable[Finding], file: str, found: Source, host: Host) -> tuple[str, ...]:
    from deburr.cli.fingerprint import key

    lines = dict(_texts(findings, file, found, host, 0))
    return tuple(key(finding, lines.get((finding.place.file, finding.place.line), "")) for finding in findings)


def _texts(
    findings: Iterable[Finding], file: str, found: Source, host: Host, around: int
) -> Iterator[tuple[tuple[str, int], str]]:
    files: dict[str, list[str]] = {file: found.lines}
    for finding in findings:
        places = [finding.place, *(related.place for related in finding.related)]
        for place in places:
            if place.file not in files:
                files[place.file] = split_lines(host.read(place.file) or "")
            lines = files[place.file]
            for line in range(max(0, place.line - around), min(len(lines), place.line + around + 1)):
                yield (place.file, line), lines[line]
