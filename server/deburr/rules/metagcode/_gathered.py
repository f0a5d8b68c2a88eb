"""The blocks of a program as they hang together once every `#FILE` line is replaced by its snippet. Never builds that text.

What a snippet does to the blocks around it is known from its own lines and the snippets in
it: how many blocks it closes and opens beyond itself, and how deep it goes. That is worked
out once a file (`spec/metagcode.md` §4, §5.1).
"""

from bisect import bisect_left, bisect_right
from collections.abc import Generator, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.includes import Found
from deburr.rule import Note
from deburr.rules.metagcode._library import Library, is_plain
from deburr.rules.metagcode._matching import ENDS, Matching, Meant, Pair, Visit, matching, meant
from deburr.steps import done, paced
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.metagcode.limits import DEEPEST, NESTED
from deburr_grammar.dialects.metagcode.outline import SNIPPET, UNKNOWN
from deburr_grammar.structure import Fault, Placed, StructureFault
from deburr_grammar.text import Span


@dataclass(frozen=True, slots=True)
class Foreign(Bracket):
    """A bracket that comes out of a snippet: where it stands there, and what its loop counts."""

    file: str
    row: int
    counts: tuple[str, ...]

    @property
    def note(self) -> Note:
        """The bracket as a related place."""
        return Note(self.row, self.span, f"`{said(self)}` stands here", self.file)


class Effect(NamedTuple):
    """What a snippet does where it is included. ``sure``: all of it is known; ``deepest`` counts from where it starts."""

    lines: int
    closers: tuple[Foreign, ...]
    openers: tuple[Foreign, ...]
    deepest: int
    loops: Mapping[str, Foreign]
    names: frozenset[str]
    sure: bool


class Named(NamedTuple):
    """A name on a `#FILE` line that can be looked up: its columns, and what is found."""

    line: int
    span: Span
    name: str
    found: Found | None


def said(bracket: Bracket) -> str:
    """A bracket as it should be written: `#ENDIF1`."""
    return bracket.word + (bracket.label or "")


def end_of(opener: Bracket) -> str:
    """The end that an opener needs: `#ENDIF1`."""
    return f"#END{opener.word[1:]}{opener.label or ''}"


def ready(analysis: Analysis) -> Iterator[None]:
    """Match the blocks of a program, in steps: what rules that stand on them are to be ready with."""
    yield from gathered(analysis).matching()


def gathered(analysis: Analysis) -> "Gathered":
    """The gathered blocks of a program, made once."""
    found: Gathered | None = analysis.memo.get(__name__)
    if found is None:
        found = analysis.memo[__name__] = Gathered(analysis)
    return found


class Gathered:
    """One program with its snippets. Lines are those of the program; what a snippet does stands on its `#FILE` line."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._effects: dict[str, Effect] = {}
        self._matched: Matching | None = None

    @cached_property
    def library(self) -> Library:
        """The snippet files."""
        return Library(self._analysis)

    def matching(self) -> Iterator[None]:
        """Match the blocks, in steps."""
        yield from self.library.reading()
        yield from self._working_out()
        yield from self._match()

    @property
    def own(self) -> Sequence[tuple[int, Bracket]]:
        """The program's own brackets, the `#FILE` lines among them."""
        return self.library.own.brackets

    @cached_property
    def files(self) -> tuple[tuple[int, Bracket], ...]:
        """The `#FILE` lines."""
        return tuple((line, bracket) for line, bracket in self.own if bracket.kind == SNIPPET)

    @cached_property
    def named(self) -> Sequence[Named]:
        """The names on the `#FILE` lines, but for those that rules on lines refuse; none where nothing is known of files."""
        plain = ((line, bracket.span, bracket.label) for line, bracket in self.files if is_plain(bracket.label))
        if not self.files or self.library.silent:
            return ()
        return [
            Named(line, Span(span.end - len(name), span.end), name, self.library.find(name))
            for line, span, name in plain
            if name is not None
        ]

    @cached_property
    def effects(self) -> Mapping[int, Effect | None]:
        """What each `#FILE` line does; None where its snippet, or one in it, is not to be had."""
        return done(self._working_out())

    def _working_out(self) -> Generator[None, None, Mapping[int, Effect | None]]:
        if "effects" not in self.__dict__:
            found: dict[int, Effect | None] = {}
            for line, bracket in self.files:
                found[line] = self._effect(bracket)
                yield
            self.effects = found
        return self.effects

    @cached_property
    def sites(self) -> Mapping[int, Span]:
        """The columns of the `#FILE` lines."""
        return {line: bracket.span for line, bracket in self.files}

    @cached_property
    def faults(self) -> Sequence[StructureFault]:
        """The faults of structure that no unknown snippet can explain."""
        unknown = [line for line, effect in self.effects.items() if effect is None or not effect.sure]
        found = (fault for fault in self._matching.faults if not isinstance(fault.at.bracket, Meant))
        return list(_once(fault for fault in found if not _explained(fault, unknown)))

    def visits(self) -> Iterator[Visit]:
        """Every bracket in order. The blocks around it are only to be looked at before the next one is asked for."""
        return self._matching.visits()

    @property
    def pairs(self) -> Sequence[Pair]:
        """The blocks whose ends belong together, in the order of their ends."""
        return self._matching.pairs

    @cached_property
    def unknown(self) -> Sequence[int]:
        """The lines of directives that do not exist, in order."""
        return [line for line, bracket in self.own if bracket.kind == UNKNOWN]

    @property
    def _matching(self) -> Matching:
        """The blocks; a directive that is misspelt does what was meant, if blocks then fit better."""
        return done(self._match())

    def _match(self) -> Generator[None, None, Matching]:
        if self._matched is None:
            brackets = yield from self._brackets()
            best = yield from matching(brackets)
            for end in ENDS if best.faults and self.unknown else ():
                repaired = yield from matching([(line, meant(bracket, end)) for line, bracket in brackets])
                best = min(best, repaired, key=lambda each: len(each.faults))
            self._matched = best
        return self._matched

    def _brackets(self) -> Generator[None, None, Sequence[tuple[int, Bracket]]]:
        """All brackets: the program's own, and on each `#FILE` line what its snippet closes and opens beyond itself."""
        found: list[tuple[int, Bracket]] = []
        for each in paced(self.own):
            if each is None:
                yield
                continue
            line, bracket = each
            found.append(each)
            effect = self.effects[line] if bracket.kind == SNIPPET else None
            if effect is not None and effect.deepest <= NESTED:
                found += [(line, foreign) for foreign in (*effect.closers, *effect.openers)]
        return found

    def counts(self, placed: Placed) -> Sequence[str]:
        """The names that a loop counts."""
        if isinstance(placed.bracket, Foreign):
            return placed.bracket.counts
        return self.library.own.counts.get(placed.line, ())

    def place(self, placed: Placed) -> tuple[int, Span]:
        """Where a bracket is to be marked: a foreign one at the `#FILE` line that brings it."""
        return placed.line, self.sites[placed.line] if isinstance(placed.bracket, Foreign) else placed.bracket.span

    def note(self, placed: Placed) -> Note:
        """A bracket as a related place."""
        if isinstance(placed.bracket, Foreign):
            return placed.bracket.note
        return Note(placed.line, placed.bracket.span, f"`{said(placed.bracket)}` stands here")

    def _effect(self, bracket: Bracket) -> Effect | None:
        """What a `#FILE` line does. Circles and chains that are too long are not followed."""
        path = self.library.target(bracket)
        if path is None or path == self.library.file or len(self.library.longest(path)) >= DEEPEST:
            return None
        if path not in self._effects:
            self._effects[path] = self._work_out(path)
        return self._effects[path]

    def _work_out(self, path: str) -> Effect:
        scan = self.library.scan(path)
        sum_ = _Sum(path)
        for line, bracket in scan.brackets:
            if bracket.kind == SNIPPET:
                sum_.include(self._effect(bracket))
            elif bracket.kind == UNKNOWN:
                # It may be a misspelt end, of which the snippet's own check speaks.
                sum_.include(None)
            else:
                sum_.take(Foreign(*_parts(bracket), path, line, scan.counts.get(line, ())))
        return sum_.effect(scan.lines, scan.names)


def _parts(bracket: Bracket) -> tuple[Role, str, str, str | None, Span]:
    return bracket.role, bracket.kind, bracket.word, bracket.label, bracket.span


class _Sum:
    """An effect that is being added up."""

    def __init__(self, path: str) -> None:
        self._closers: list[Foreign] = []
        self._openers: list[Foreign] = []
        self._loops: dict[str, Foreign] = {}
        self._names: set[str] = set()
        self._lines = self._deepest = 0
        self._sure = True

    def take(self, bracket: Foreign) -> None:
        """Add a bracket."""
        if bracket.role is not Role.CLOSE:
            self._openers.append(bracket)
            self._loops = {**dict.fromkeys(bracket.counts, bracket), **self._loops} if bracket.counts else self._loops
            self._reach(len(self._openers))
        elif self._openers:
            self._openers.pop()
        elif len(self._closers) <= NESTED:
            # More closers than blocks may be open need not be told apart.
            self._closers.append(bracket)

    def include(self, inner: Effect | None) -> None:
        """Add a snippet in the snippet."""
        if inner is None:
            self._sure = False
            return
        self._reach(len(self._openers) + inner.deepest)
        self._lines += inner.lines - 1
        self._sure = self._sure and inner.sure
        self._names |= inner.names
        self._loops = {**inner.loops, **self._loops}
        for bracket in (*inner.closers, *inner.openers):
            self.take(bracket)

    def effect(self, lines: int, names: frozenset[str]) -> Effect:
        """The effect of a file with so many lines of its own, in which these names stand."""
        return Effect(
            self._lines + lines,
            tuple(self._closers),
            tuple(self._openers),
            self._deepest,
            self._loops,
            names | self._names,
            self._sure,
        )

    def _reach(self, depth: int) -> None:
        self._deepest = max(self._deepest, depth - len(self._closers))
        if depth > NESTED:
            # So deep is an error wherever it stands; what it leaves open is of no interest then.
            self._sure = False
            del self._openers[:-NESTED]


def _once(faults: Iterable[StructureFault]) -> Iterator[StructureFault]:
    """The faults without those that a snippet repeats: one of a sort on a `#FILE` line says it."""
    seen: set[tuple[Fault, int]] = set()
    for fault in faults:
        key = (fault.fault, fault.at.line)
        if not isinstance(fault.at.bracket, Foreign) or key not in seen:
            yield fault
            seen.add(key)


def _explained(fault: StructureFault, unknown: Sequence[int]) -> bool:
    """Whether a snippet that is not known, on one of these lines, may be what a fault misses."""
    at = fault.at.line
    if isinstance(fault.at.bracket, Foreign) and bisect_left(unknown, at) < bisect_right(unknown, at):
        return True
    if fault.other is not None:
        first, last = sorted((at, fault.other.line))
        return bisect_right(unknown, first) < bisect_left(unknown, last)
    return bool(unknown) and (unknown[0] < at if fault.fault is Fault.UNOPENED else unknown[-1] > at)
