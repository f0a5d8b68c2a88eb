"""What calls lead to: subs of the program and of files around it. Never judges, never looks for a file itself."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from functools import cached_property
from posixpath import basename, splitext
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.finding import Finding, Severity
from deburr.rules.rs274._folders import BREAKS, Folders
from deburr.rules.rs274._guesses import Guesses
from deburr.rules.rs274._program import Call, Program, Sub, program_of, ready
from deburr.steps import paced
from deburr_grammar.text import Span

_NESTED = "rs274 nested"
_INSIDE = "rs274.o-unclosed", "rs274.sub-nested", "rs274.percent", "rs274.program-end-missing"
"""What is wrong with a file as such, but does not stop a call of its sub."""


class How(Enum):
    """What a call leads to."""

    SUB = "a sub of the same file, or of the program"
    FILE = "a sub in a file of its own"
    LACKS = "a file without the sub"
    PERCENT = "a sub behind a `%`, where the program has one too"
    MISNAMED = "nothing, but there is a file that is named almost so"
    PASSED = "a sub that the control has passed over and does not find again"
    NEARBY = "nothing, but a folder nearby has the file"
    MISSING = "nothing"
    UNSAFE = "a file whose name a shell would change"
    UNSEEN = "what only the run knows"


FAILS = frozenset((How.LACKS, How.PERCENT, How.MISNAMED, How.PASSED, How.MISSING))


class Target(NamedTuple):
    """Where a call leads: the file (the program's own path for itself), the program in it and the sub."""

    how: How
    path: str = ""
    program: Program | None = None
    sub: Sub | None = None


class Trouble(NamedTuple):
    """What stops the control in a called file: where, and why. ``message`` is empty where a call in it fails: then ``call`` and ``target`` say more."""

    path: str
    line: int
    span: Span
    message: str
    severity: Severity
    program: Program | None = None
    call: Call | None = None
    target: Target | None = None


class World:
    """A program with all files that it can reach by calls."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self.folders = Folders(analysis)
        self.guesses = Guesses()
        self._targets: dict[tuple[str, Call], Target] = {}
        self._errors: dict[str, list[Finding]] = {}
        self.main = program_of(analysis)
        self.path = analysis.file
        self.nested = bool(analysis.memo.get(_NESTED))
        """Whether the program is only looked at because another one calls it."""

    def following(self) -> Iterator[None]:
        """Follow the calls of the program, in steps."""
        for call in paced(self.main.calls):
            if call is None:
                yield
            else:
                self.target(self.path, self.main, call)

    @cached_property
    def is_library(self) -> bool:
        """Whether the file only defines subs, so that what its callers define is there too."""
        return bool(self.main.subs) and not self.main.has_main

    @cached_property
    def own(self) -> Sub | None:
        """The sub for which a library is looked up by its name: all before it is passed over then."""
        stem = splitext(basename(self.path))[0]
        return next(iter(self.main.by_label.get(stem, ())), None) if self.is_library else None

    def target(self, path: str, program: Program, call: Call) -> Target:
        """What a call in a file leads to."""
        key = (path, call)
        if key not in self._targets:
            self._targets[key] = self._found(path, program, call)
        return self._targets[key]

    def fails(self, target: Target, call: Call) -> bool:
        """Whether the control finds no sub: no other call can have made the sub known."""
        return target.how in FAILS and (target.how in (How.LACKS, How.PERCENT) or call.label not in self._found_ahead)

    def is_idle(self, line: int) -> bool:
        """Whether a line of the program is never run: in a block with a written-out false condition, or in a sub that nobody calls."""
        sub = self.main.sub_at(line)
        return self.main.passed_over(line) or (sub is not None and self.is_uncalled(sub))

    def is_uncalled(self, sub: Sub) -> bool:
        """Whether it is certain that nobody calls a sub of the program."""
        if self.is_library or self.nested or sub.label is None or None in self._called:
            return False
        return all(caller is sub for caller in self._called.get(sub.label, ()))

    @cached_property
    def _called(self) -> dict[str | None, list[Sub | None]]:
        """The labels that are called, with the subs of the program that do so, None standing for all else; None: the label of a call of which only the run knows where it leads."""
        found: dict[str | None, list[Sub | None]] = {}
        for call in self.main.calls:
            found.setdefault(call.label, []).append(self.main.sub_at(call.line))
            if not call.fanuc and self.target(self.path, self.main, call).how is How.UNSEEN and not call.faulty:
                found.setdefault(None, []).append(None)
        for target in self.reached.values():
            for call, _ in self.calls_in(target):
                found.setdefault(call.label, []).append(None)
        return found

    @cached_property
    def reached(self) -> dict[tuple[str, int], Target]:
        """All subs of other files to which calls lead, under their files and first lines."""
        found: dict[tuple[str, int], Target] = {}
        waiting = [self.target(self.path, self.main, call) for call in self.main.calls]
        while waiting:
            target = waiting.pop()
            if target.program is None or target.sub is None or target.program is self.main:
                continue
            key = (target.path, target.sub.start)
            if key not in found:
                found[key] = target
                waiting += [inner for _, inner in self.calls_in(target)]
        return found

    @cached_property
    def is_complete(self) -> bool:
        """Whether it is known where all calls lead."""
        targets = [self.target(self.path, self.main, call) for call in self.main.calls]
        targets += [inner for target in self.reached.values() for _, inner in self.calls_in(target)]
        return all(target.how in (How.SUB, How.FILE) and target.sub is not None for target in targets)

    @cached_property
    def programs(self) -> list[Program]:
        """The program and all files that it reaches."""
        found = {target.path: target.program for target in self.reached.values()}
        return [self.main, *(program for program in found.values() if program is not None)]

    def calls_in(self, target: Target) -> list[tuple[Call, Target]]:
        """The calls in a sub, with what they lead to."""
        program, sub = target.program, target.sub
        if program is None or sub is None:
            return []
        return [(call, self.target(target.path, program, call)) for call in program.calls_by_sub.get(sub, ())]

    def troubles(self, target: Target) -> Iterator[Trouble]:
        """What stops the control, or newer ones, in a called file's sub and in those of other files that it calls."""
        seen: set[tuple[str, int]] = set()
        waiting = [target]
        while waiting:
            here = waiting.pop()
            if here.program is None or here.sub is None or here.program is self.main:
                continue
            if (here.path, here.sub.start) in seen:
                continue
            seen.add((here.path, here.sub.start))
            yield from self._in_sub(here, here.program, here.sub)
            for call, inner in self.calls_in(here):
                if self.fails(inner, call):
                    yield Trouble(here.path, call.line, call.span, "", Severity.ERROR, here.program, call, inner)
                waiting.append(inner)

    def _in_sub(self, target: Target, program: Program, sub: Sub) -> Iterator[Trouble]:
        for finding in self._errors_of(target.path, program):
            if sub.start <= finding.place.line <= sub.end:
                at = finding.place
                yield Trouble(target.path, at.line, Span(at.col, at.end_col), finding.message, Severity.ERROR)
        nested = next((each for each in program.subs if not sub.closed and each.start > sub.start), None)
        if not sub.closed and not sub.returns and nested is None:
            yield Trouble(target.path, sub.start, sub.span, f"`{said(sub.label)} sub` has no `endsub`", Severity.ERROR)
        elif nested is not None:
            message = f"`{said(nested.label)} sub` stands inside `{said(sub.label)} sub`, which newer controls refuse and older ones ignore"
            yield Trouble(target.path, nested.start, nested.span, message, Severity.WARNING)

    def _errors_of(self, path: str, program: Program) -> list[Finding]:
        if path not in self._errors:
            nested = self._analysis.nested(program.document, path)
            nested.memo[_NESTED] = True
            found = [each for each in nested.findings() if each.severity is Severity.ERROR]
            self._errors[path] = [each for each in found if each.rule not in _INSIDE]
        return self._errors[path]

    def _found(self, path: str, program: Program, call: Call) -> Target:
        if call.label is None or call.path is None or call.faulty:
            return Target(How.UNSEEN)
        if call.fanuc:
            return self._called_by_number(program, call, call.label)
        known = self._known(path, program, call, call.label)
        if known is not None:
            return known
        if not BREAKS.isdisjoint(call.path):
            return Target(How.UNSAFE)
        file = self.folders.find(call.path)
        if file is not None:
            return self._in_file(file, call.label)
        return self._below(path, program, call, call.label)

    def _known(self, path: str, program: Program, call: Call, label: str) -> Target | None:
        """The sub that the control has come by, or that is being run."""
        here = program.sub_at(call.line)
        if here is not None and here.label == label:
            return Target(How.SUB, path, program, here)
        if self.own is not None and program is self.main:
            return None
        in_main = program is self.main and here is None
        for sub in self.main.by_label.get(label, ()):
            if sub.flow and not self.main.passed_over(sub.start) and (not in_main or sub.start < call.line):
                return Target(How.SUB, self.path, self.main, sub)
        return None

    def _in_file(self, file: str, label: str) -> Target:
        program = self.folders.program(file)
        if program is None:
            return Target(How.UNSEEN)
        sub = next(iter(program.by_label.get(label, ())), None)
        if sub is None:
            return Target(How.UNSEEN if program.computed else How.LACKS, file, program)
        if self.main.percents and any(line < sub.start for line in program.percents):
            return Target(How.PERCENT, file, program, sub)
        return Target(How.FILE, file, program, sub)

    def _below(self, path: str, program: Program, call: Call, label: str) -> Target:
        """Where there is no such file, the rest of the text is searched."""
        subs = program.by_label.get(label, [])
        ahead = next((sub for sub in subs if sub.start > call.line), None)
        if ahead is not None:
            return Target(How.SUB, path, program, ahead)
        if program.computed or self.main.computed or not (subs or self.folders.searchable):
            return Target(How.UNSEEN)
        if subs:
            return Target(How.PASSED, path, program, subs[0])
        if self.folders.near(call.path or label):
            return Target(How.MISNAMED)
        return Target(How.NEARBY if self.folders.nearby(label) else How.MISSING)

    def _called_by_number(self, program: Program, call: Call, label: str) -> Target:
        file = self.folders.find(label)
        found = self.folders.program(file) if file is not None else None
        if found is not None and file is not None and label not in self.main.by_label:
            # A file of the number is read whatever else has it.
            has = found.computed or any(bare == label for _, bare in found.bare)
            return Target(How.FILE if has else How.LACKS, file, found)
        if any(bare == label for each in (program, self.main) for _, bare in each.bare):
            return Target(How.SUB)
        if file is not None or not self.folders.searchable:
            return Target(How.UNSEEN if file is None else How.FILE, file or "")
        return Target(How.MISSING)

    @cached_property
    def _found_ahead(self) -> set[str]:
        """The labels of subs that some call makes known to all that come after it."""
        places = [(self.path, self.main, call) for call in self.main.calls]
        for target in self.reached.values():
            if target.program is not None:
                places += [(target.path, target.program, call) for call, _ in self.calls_in(target)]
        found = {call.label for path, program, call in places if self.target(path, program, call).how is How.SUB}
        return {label for label in found if label is not None}


def ready_world(analysis: Analysis) -> Iterator[None]:
    """Find where the calls of the program lead, in steps."""
    yield from ready(analysis)
    yield from world_of(analysis).following()


def world_of(analysis: Analysis) -> World:
    """The program that is checked and the files around it."""
    found: World | None = analysis.memo.get("rs274 world")
    if found is None:
        found = analysis.memo["rs274 world"] = World(analysis)
    return found


def said(label: str | None) -> str:
    """A label with its O as one writes it."""
    if label is None:
        return "o[...]"
    return f"o{label}" if label.isdigit() else f"o<{label}>"
