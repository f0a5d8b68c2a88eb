"""Phase 1 of a MetaGCODE run: every `#FILE` line is replaced by its snippet (spec/metagcode.md §5.1, §7). Never looks at a value.

The gathered text is never built: it is the directives and the stretches between them in
order, each shared by all places at which its file is put in.
"""

from __future__ import annotations

import posixpath
from array import array
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from deburr.expand.job import SLICE, Job
from deburr.expand.metagcode.lines import Directive, Stretch, Text
from deburr.fault import Entered, Fault, Frame
from deburr.includes import Folder, leaves
from deburr.suggest import suggestion
from deburr_grammar.dialect import Dialect, Role
from deburr_grammar.dialects.metagcode.limits import DEEPEST, LARGEST, LINES
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document
from deburr_grammar.text import Span


class Include(NamedTuple):
    """A `#FILE` line: its row, its columns, the name on it."""

    row: int
    span: Span
    name: str | None

    @property
    def named(self) -> Span:
        """The columns of the name."""
        return Span(self.span.end - len(self.name or ""), self.span.end)


class Source:
    """One file of a program and the files that it puts in."""

    def __init__(self, text: Text) -> None:
        self.text = text
        self.parts: list[Stretch | Directive | Include] = []
        self.includes: list[Include] = []
        self.targets: dict[int, Source] = {}
        """The snippets that are there, by the rows that name them."""
        self.size: int | None = None
        """Lines with all snippets put in, once that is known."""

    def read(self) -> Iterator[None]:
        """Find the directives and what stands between them, in slices."""
        for number, part in enumerate(_parts(self.text), 1):
            self.parts.append(part)
            if isinstance(part, Include):
                self.includes.append(part)
            if number % SLICE == 0:
                yield


class Place:
    """A file where it is put in: by which line of which other. ``before``: the step of the gathered text that comes next."""

    __slots__ = ("before", "outer", "row", "source")

    def __init__(self, source: Source, outer: Place | None = None, row: int = 0, before: int = 0) -> None:
        self.source = source
        self.outer = outer
        self.row = row
        self.before = before

    @property
    def file(self) -> str:
        """The file's path."""
        return self.source.text.file

    @property
    def stack(self) -> Frame | None:
        """The `#FILE` lines on the way to it."""
        return None if self.outer is None else Frame(self.outer.stack, self.outer.file, self.row, Entered.FILE, 0)

    @property
    def way(self) -> Iterator[Place]:
        """This file and those on the way to it, innermost first."""
        place: Place | None = self
        while place is not None:
            yield place
            place = place.outer

    @property
    def program(self) -> Source:
        """The program that it belongs to."""
        *_, outermost = self.way
        return outermost.source

    @property
    def include(self) -> Include:
        """The line that puts it in; it must not be a program."""
        assert self.outer is not None
        return next(each for each in self.outer.source.includes if each.row == self.row)


class Gathered:
    """The gathered text as steps in order. ``places``: where each step's file is put in; ``partners``: the other end of each directive."""

    def __init__(self) -> None:
        self.steps: list[Stretch | Directive] = []
        self.places: list[Place] = []
        self.partners = array("i")


class Gatherer:
    """The programs of a job and all snippets that they lead to. ``faults``: what is wrong with the way they do so."""

    def __init__(self, job: Job) -> None:
        self._dialect = job.ruleset.dialect
        first = job.programs[0].file
        self._folder = Folder(job.host, first, str(job.settings["snippets-dir"]))
        self._snippets: dict[str, Source] = {}
        self.programs = tuple(Source(Text(program.file, program.document)) for program in job.programs)
        self.faults: list[Fault] = []
        self.reached: list[Place] = []
        """Every file once."""

    @property
    def alone(self) -> bool:
        """Whether the program is itself a snippet, so that a run of it shows nothing of the programs that put it in."""
        return self._folder.inside

    def gather(self) -> Iterator[None]:
        """Read all snippets, level by level, in slices."""
        level = [Place(program) for program in self.programs]
        seen = set[int]()
        for _ in range(DEEPEST + 1):
            inner: dict[int, Place] = {}
            for reached in level:
                if id(reached.source) not in seen:
                    seen.add(id(reached.source))
                    self.reached.append(reached)
                    yield from reached.source.read()
                    self._resolve(reached)
                for row, target in reached.source.targets.items():
                    inner.setdefault(id(target), Place(target, reached, row))
            level = list(inner.values())
        self.faults += [_endless(reached) for reached in level]
        if not self.faults:
            self._measure()

    def _resolve(self, reached: Place) -> None:
        """Find the snippets that a file names; what rules on lines refuse is not looked for."""
        for include in reached.source.includes:
            if not include.name or "|" in include.name or leaves(include.name):
                continue
            found = self._folder.find(include.name)
            if found is None:
                self._fault("file-missing", reached, include, self._missing(include.name))
            elif found.larger(LARGEST):
                message = f"`{include.name}` has more than {LARGEST:,} bytes, which is refused for a snippet"
                self._fault("limit", reached, include, message)
            else:
                if found.path not in self._snippets:
                    document = _document(found.text, self._dialect)
                    self._snippets[found.path] = Source(Text(found.path, document))
                reached.source.targets[include.row] = self._snippets[found.path]

    def _missing(self, name: str) -> str:
        if self._folder.silent:
            return f"`{name}` cannot be looked for: a program that lies in no folder has no snippets beside it"
        last = name.replace("\\", "/").rpartition("/")[2]
        near = self._folder.near(name)
        alike = [each for each in near if each.casefold() == last.casefold()]
        hint = "; several names differ from it in case only, and none is preferred" if len(alike) > 1 else ""
        return f"`{name}` is not in the folder of snippets `{self._folder.root}`{hint or suggestion(last, near)}"

    def _fault(self, kind: str, reached: Place, include: Include, message: str) -> None:
        unknown = kind == "file-missing" and self._folder.silent
        self.faults.append(Fault(kind, reached.file, include.row, include.named, message, reached.stack, unknown))

    def _measure(self) -> None:
        """Refuse a text that grows beyond all lines; report where it does."""
        lines = 0
        message = f"the text has more than {LINES:,} lines with all its snippets put in, which is refused"
        for program in self.programs:
            file, rows = program.text.file, program.text.rows
            if lines + rows > LINES:
                self.faults.append(Fault("limit", file, LINES - lines, Span(0, 0), message))
                return
            lines += rows
            for include in program.includes:
                lines += _size(program.targets[include.row]) - 1 if include.row in program.targets else 0
                if lines > LINES:
                    self.faults.append(Fault("limit", file, include.row, include.span, message))
                    return

    def flatten(self, gathered: Gathered) -> Iterator[None]:
        """Fill in the gathered text, in slices."""
        for program in self.programs:
            place = Place(program)
            for number, (step, inner) in enumerate(_flat(place, gathered.steps), 1):
                gathered.steps.append(step)
                gathered.places.append(inner)
                gathered.partners.append(-1)
                if number % SLICE == 0:
                    yield


def _flat(place: Place, steps: Sequence[object]) -> Iterator[tuple[Stretch | Directive, Place]]:
    """The steps of a file at a place. Files that come to nothing are passed over, however often they are put in."""
    for part in place.source.parts:
        if not isinstance(part, Include):
            yield part, place
        elif (target := place.source.targets.get(part.row)) is not None and _size(target):
            yield from _flat(Place(target, place, part.row, len(steps)), steps)


def _size(source: Source) -> int:
    if source.size is None:
        inner = sum(_size(target) - 1 for target in source.targets.values())
        source.size = source.text.rows + inner
    return source.size


def _parts(text: Text) -> Iterator[Stretch | Directive | Include]:
    """A file as what stands between its directives, and these."""
    row = 0
    for line, bracket in text.document.brackets():
        if bracket.kind != SNIPPET and bracket.role is Role.MIDDLE:
            continue
        if line > row:
            yield Stretch(text, row, line)
        if bracket.kind == SNIPPET:
            yield Include(line, bracket.span, bracket.label)
        else:
            yield Directive(text, line, bracket)
        row = line + 1
    if text.rows > row:
        yield Stretch(text, row, text.rows)


def _endless(last: Place) -> Fault:
    """What is wrong with a way that is longer than the longest: it goes in a circle, or it is too long."""
    way = [*last.way][::-1]
    files = [each.file for each in way]
    again = next((at for at, file in enumerate(files) if file in files[:at]), None)
    if again is None:
        return _refused(last, "snippet-depth", f"leads more than {DEEPEST} snippets deep, where this ends")
    circle = [f"`{posixpath.basename(file)}`" for file in files[files.index(files[again]) : again + 1]]
    return _refused(way[again], "snippet-cycle", f"closes the circle {' > '.join(circle)}, which never ends")


def _refused(place: Place, kind: str, message: str) -> Fault:
    """A fault of the line that puts in a file."""
    include, outer = place.include, place.outer
    assert outer is not None
    return Fault(kind, outer.file, include.row, include.span, f"`#FILE {include.name}` {message}", outer.stack)


@lru_cache(maxsize=64)
def _document(text: str, dialect: Dialect) -> Document:
    return Document.parse(text, dialect)
