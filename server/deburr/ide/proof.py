"""Proof that a program means what it meant: nothing new is said of it, and, as far as it can be run, its flat program is the same."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.expand import Budget, Job, Kept, Program, drive, interpreter
from deburr.ide.refactor import Cannot, Work

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from deburr.host import Host
    from deburr.ide.view import View
    from deburr_grammar.document import Document

_BUDGET = Budget(20_000, 20_000)
"""How far a program is run to compare what it does: some tenths of a second."""


def proving(view: View, after: Document, files: Mapping[str, str] | None = None) -> Work[None]:
    """Cannot, if another text of a program, with more files beside it, would not mean the same. Can be left at each step."""
    host = With(view.host, files or {})
    before = yield from _said(view, view.document, view.host)
    now = yield from _said(view, after, host)
    if new := next(iter(now - before), ""):
        raise Cannot(f"the program would be faulty: {new}")
    was = yield from flat(view, view.document, view.host)
    if not _alike(was, (yield from flat(view, after, host))):
        raise Cannot("the program would do something else")


class Flat(NamedTuple):
    """A flat program, and whether it goes to the end: no fault, and no more lines than anyone waits for."""

    lines: Sequence[str]
    whole: bool


def flat(view: View, document: Document, host: Host) -> Work[Flat]:
    """The flat program as far as it can be had."""
    if interpreter(view.dialect.name) is None:
        return Flat((), False)
    lines = Kept()
    job = Job([Program(view.file, document)], view.ruleset, host, lines, None, _BUDGET)
    yield from drive(job)
    return Flat(lines.lines, not (job.faults or job.cut))


def _alike(before: Flat, after: Flat) -> bool:
    """Whether two flat programs are the same, as far as both go."""
    if before.whole and after.whole:
        return before.lines == after.lines
    return all(one == two for one, two in zip(before.lines, after.lines))


def _said(view: View, document: Document, host: Host) -> Work[Counter[str]]:
    with Analysis(document, view.ruleset, view.file, host) as analysis:
        findings = yield from analysis.gathering()
    return Counter(each.rule for each in findings)


class With:
    """Files, and more that are not written yet."""

    def __init__(self, host: Host, files: Mapping[str, str]) -> None:
        self._host = host
        self._files = files

    def read(self, path: str) -> str | None:
        """The text of a file."""
        return self._files[path] if path in self._files else self._host.read(path)

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder."""
        start = folder.rstrip("/") + "/"
        more = {path[len(start) :].partition("/")[0] for path in self._files if path.startswith(start)}
        return sorted({*self._host.names(folder), *more}) if more else self._host.names(folder)
