"""A program from its file to its flat form: opened, checked, run, written. All or nothing, unless a part is wanted."""

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from mmap import ACCESS_READ, mmap
from time import monotonic
from typing import IO, TYPE_CHECKING, NamedTuple

from deburr import paths, source
from deburr.analysis import Analysis
from deburr.check import in_file, opened
from deburr.cli.common import complain
from deburr.cli.disk import Disk
from deburr.cli.files import STDIN, Target
from deburr.cli.opening import Opener, Unopened
from deburr.cli.replacing import replacing
from deburr.cli.result import Result
from deburr.cli.run import Outcome, texts
from deburr.cli.style import style_for
from deburr.config import ConfigError, RuleSets
from deburr.configfile import Configs
from deburr.expand import Budget, Inputs, Job, Program, SourceMap, drive, interpreter
from deburr.finding import Finding, Severity
from deburr.host import Host, NoFiles
from deburr.ran import before_a_run, merged, worded
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.motion import Path

_PATIENCE = 2.0
"""Seconds after which a run that goes on says so."""


class Opened(NamedTuple):
    """A program that was read: how, as what, and under which rules."""

    file: str
    source: Source
    dialect: Dialect
    ruleset: RuleSet
    document: Document
    host: Host


class Terms(NamedTuple):
    """How programs are run and written. ``eol`` "": as in the source."""

    inputs: Inputs
    budget: Budget
    eol: str
    quiet: bool
    mapped: bool
    done: str = "written"
    """What becomes of flat lines, in a word for messages."""


def opened_programs(files: Sequence[str], dialect: str | None, configs: Configs) -> tuple[Opened, ...]:
    """The programs of some files, all of one dialect."""
    opener, rulesets, disk = Opener(configs, dialect), RuleSets(), Disk()
    found = tuple(_opened(file, opener, rulesets, disk) for file in files)
    names = {each.dialect.name for each in found}
    if len(names) > 1:
        raise ConfigError(f"programs of several dialects cannot be joined: {', '.join(sorted(names))}")
    if len(found) > 1 and not getattr(interpreter(found[0].dialect.name), "JOINS", False):
        name = found[0].dialect.name
        raise ConfigError(f"a program in `{name}` runs by itself: name one file, not {len(found)}; nothing joins them")
    return found


def _opened(file: str, opener: Opener, rulesets: RuleSets, disk: Disk) -> Opened:
    found = opener.opened(Target(file if file == STDIN else paths.absolute(file), True))
    if isinstance(found, Unopened):
        raise ConfigError(f"{file}: {found.failure}")
    host: Host = disk if found.name else NoFiles()
    ruleset = rulesets.of(found.dialect, found.config, found.file)
    document = opened(found.source, found.dialect, ruleset, host)
    return Opened(found.file, found.source, found.dialect, ruleset, document, host)


class Flat:
    """A flat program. ``whole``: it was produced without a fault; otherwise it is not to be used."""

    def __init__(self, programs: Sequence[Opened], terms: Terms, lines: IO[bytes], eol: str) -> None:
        self.programs = tuple(programs)
        self.terms = terms
        self.file = lines
        self.whole = True
        self.source_map = SourceMap() if terms.mapped else None
        self._eol = eol.encode()
        self._encoding = programs[-1].source.encoding
        self._bom = programs[0].source.bom
        self._ends = programs[-1].source.text.endswith(("\n", "\r"))
        self.count = 0
        """Lines so far."""

    def line(self, text: str) -> None:
        """One more line."""
        if self.count:
            self.file.write(self._eol)
        self.count += 1
        self.file.write(text.encode(self._encoding, "replace"))

    def keep(self, count: int) -> None:
        """Only the first so many lines."""
        self.file.flush()
        end = 0
        with mmap(self.file.fileno(), 0, access=ACCESS_READ) as text:
            # Each line but the first begins behind an end.
            for _ in range(count):
                end = text.find(self._eol, end) + len(self._eol)
        self.file.truncate(max(end - len(self._eol), 0))
        self.file.seek(0, os.SEEK_END)
        self.count = count

    def lines(self) -> list[str]:
        """All lines, to be compared."""
        self.file.seek(0)
        return self.file.read().decode(self._encoding).split(self._eol.decode()) if self.count else []

    def path(self, lines: Sequence[str] | None = None) -> "Path":
        """Where it goes, on the machine that is configured; or where other flat lines go there."""
        from deburr.motion.follow import follow
        from deburr.motion.form import form_of

        first = self.programs[0]
        form = form_of(first.ruleset, first.host, self.terms.inputs.simulate)
        return follow(self.lines() if lines is None else lines, form)

    def written(self, output: str | None, source_map: str | None, stats: str | None = None) -> int:
        """Put the flat program where it is wanted; the exit code. ``stats``: what stands in it is printed, in its place or beside its file."""
        if not self.whole and not self.terms.inputs.partial:
            return 1
        if self.count and self._ends:
            self.file.write(self._eol)
        if source_map is not None:
            self._write_map(output, source_map)
        if output is not None:
            with replacing(output) as out:
                self._copy(out)
        elif stats is None:
            self._copy(sys.stdout.buffer)
        if stats is not None:
            from deburr.cli.stats import say

            say(self, stats)
        return 0 if self.whole else 1

    def _copy(self, out: IO[bytes]) -> None:
        from shutil import copyfileobj

        if self._bom:
            out.write(b"\xef\xbb\xbf")
        self.file.seek(0)
        copyfileobj(self.file, out)
        out.flush()

    def _write_map(self, output: str | None, path: str) -> None:
        assert self.source_map is not None
        folder = paths.parent(paths.absolute(path))
        texts = self.source_map.texts(
            os.path.relpath(output, folder).replace(os.sep, "/") if output else "",
            lambda file: os.path.relpath(file, folder).replace(os.sep, "/"),
        )
        with replacing(path) as out:
            out.writelines(text.encode() for text in texts)


def flat_of(programs: Sequence[Opened], terms: Terms, lines: IO[bytes]) -> Flat:
    """Check the programs, run them into a file, and say on stderr what is wrong."""
    flat = Flat(programs, terms, lines, terms.eol or source.eol_of(programs[0].source.text))
    found = [finding for program in programs for finding in _checked(program, terms.inputs)]
    found = before_a_run(found, programs[0].dialect, terms.inputs, len(programs))
    if any(finding.severity is Severity.ERROR for finding in found):
        flat.whole = False
        # A name that is misspelt may be what the error is about.
        if unread := getattr(interpreter(programs[0].dialect.name), "unread", None):
            _warn(unread(_job(flat)), terms)
    else:
        found = merged(found, _run(flat))
    shown = [finding for finding in found if finding.severity is Severity.ERROR or not terms.quiet]
    _say([finding for finding in shown if finding.severity > Severity.INFO], flat)
    return flat


def _checked(program: Opened, inputs: Inputs) -> list[Finding]:
    document, ruleset = program.document, program.ruleset
    notices = tuple(program.source.notices())
    analysis = Analysis(document, ruleset, program.file, program.host, notices, inputs=inputs)
    return in_file(analysis.findings(), program.file, program.source)


def _job(flat: Flat) -> Job:
    first = flat.programs[0]
    programs = [Program(each.file, each.document) for each in flat.programs]
    return Job(programs, first.ruleset, first.host, flat, flat.terms.inputs, flat.terms.budget, flat.source_map)


def _warn(messages: Iterable[str], terms: Terms) -> None:
    for message in messages if not terms.quiet else ():
        complain(message, "warning")


def _run(flat: Flat) -> Iterator[Finding]:
    """What the run met."""
    first, job = flat.programs[0], _job(flat)
    started = said = monotonic()
    for _ in drive(job):
        now = monotonic()
        if now - said > _PATIENCE and sys.stderr.isatty():
            said = now
            print(f"\rdeburr: {job.steps:,} lines run, {job.emitted:,} written", end="", file=sys.stderr, flush=True)
    if said != started:
        print(file=sys.stderr)
    flat.whole = not job.halted
    _warn(job.unread, flat.terms)
    if flat.terms.inputs.decimals is not None and not flat.terms.quiet:
        from deburr.cli.rounding import Rounded, said_of_rounding

        _warn(said_of_rounding(Rounded(job, flat.lines), flat.path, style_for(sys.stderr).file), flat.terms)
    documents = {each.file: each for each in flat.programs}
    for fault in job.faults:
        if fault.given:
            raise ConfigError(fault.message)
        program = documents.get(fault.file)
        lines = program.source.lines if program else (first.host.read(fault.file) or "").split("\n")
        finding = worded(fault, first.ruleset, lines[fault.line] if fault.line < len(lines) else "")
        if fault is job.faults[-1] and job.halted:
            finding = finding._replace(severity=Severity.ERROR)
        flat.whole = flat.whole and finding.severity < Severity.ERROR
        yield finding


def _say(found: list[Finding], flat: Flat) -> None:
    from deburr.cli.reporters import full

    outcomes, programs = [], flat.programs
    for program in programs:
        own = tuple(finding for finding in found if finding.place.file == program.file)
        if program is programs[0]:
            files = {each.file for each in programs}
            own += tuple(finding for finding in found if finding.place.file not in files)
        lines = texts(own, program.file, program.source, program.host)
        outcomes.append(Outcome(program.file, program.dialect.name, "", own, texts=lines))
    full.report(Result(tuple(outcomes)), sys.stderr, style_for(sys.stderr))
    errors = sum(finding.severity is Severity.ERROR for finding in found)
    if errors:
        wanted = flat.terms.inputs.partial and flat.count
        done = flat.terms.done
        what = f"only {flat.count:,} lines were {done}" if wanted else f"nothing was {done}"
        complain(f"{what}: {errors} error{'s' if errors > 1 else ''}", "")
