"""When programs are checked and who is told: at once what an edit decides, the rest in idle slices, and again what depends on it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.host import NoFiles
from deburr.ide.moved import moved
from deburr.needs import Needs

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr.host import Host
    from deburr.ide.view import View
    from deburr.lsp.files import Stamp
    from deburr.lsp.idle import Idle
    from deburr.lsp.session import Open, Session
    from deburr_grammar.text import Edit

BREATH = 0.03
"""Seconds without an edit after which an edited program is gone through as a whole."""
PAUSE = 0.1
"""Seconds without an edit after which the programs that depend on what was edited are checked again."""


class Outdated(Exception):
    """What was waited for is of no interest any more: the program has changed."""


@dataclass(eq=False)
class Checked:
    """What is known of a program. ``whole``: all of it was gone through in its present state."""

    findings: tuple[Finding, ...] = ()
    whole: bool = False
    needs: Needs | None = None
    stamp: Stamp | None = None
    waiting: list[asyncio.Future[None]] = field(default_factory=list)


class Checks:
    """The findings of a session's programs. ``say`` is told of each file of which they are others now."""

    def __init__(
        self, session: Session, idle: Idle, say: Callable[[str], None], failed: Callable[[Exception], None]
    ) -> None:
        self._session = session
        self._idle = idle
        self._say = say
        self._failed = failed
        self._known: dict[str, Checked] = {}
        self._changed: set[str] = set()
        self._timer: asyncio.TimerHandle | None = None
        self._pauses: dict[str, asyncio.TimerHandle] = {}
        self.depended: Callable[[], None] = lambda: None
        """Called when programs are checked again because of others."""
        self.changed: Callable[[set[str]], None] = lambda files: None
        """Called with files that are not as they were, when the pause behind the last edit has passed."""

    def findings(self, file: str) -> tuple[Finding, ...]:
        """What is known of a file: what its own check found there and what those of others did."""
        own = self._known.get(file)
        found = [finding for finding in own.findings if finding.place.file == file] if own else []
        for other, known in self._known.items():
            if other != file and known.needs is not None and file in known.needs.texts:
                found += [finding for finding in known.findings if finding.place.file == file]
        return tuple(sorted(set(found), key=lambda finding: finding.order))

    def elsewhere(self, file: str) -> dict[str, tuple[Finding, ...]]:
        """What the check of a program found in other files."""
        own = self._known.get(file)
        files = {finding.place.file for finding in own.findings} - {file} if own else set()
        return {other: self.findings(other) for other in sorted(files)}

    def opened(self, program: Open) -> None:
        """A program was opened, or is another than before."""
        self._known.pop(program.file, None)
        self._begin(program.file, program.view, urgent=True)
        self.touched(program.file)

    def edited(self, program: Open, edits: Sequence[Edit]) -> None:
        """A program was edited: what its lines decide is known at once."""
        known = self._known.setdefault(program.file, Checked())
        view = program.view
        known.whole = False
        if view is not None:
            analysis = Analysis(view.document, view.ruleset, view.file, view.host)
            known.findings = tuple(moved(known.findings, edits, analysis))
            self._say(program.file)
        self._idle.drop(program.file)
        _release(known, Outdated())
        self._later(program.file)
        self.touched(program.file)

    def closed(self, program: Open) -> None:
        """A program was closed."""
        self._idle.drop(program.file)
        known = self._known.pop(program.file, None)
        _release(known, Outdated())
        self._say(program.file)
        for file in _places(known):
            self._say(file)
        self.touched(program.file)

    def touched(self, *files: str) -> None:
        """These files are not as they were: what depends on them is checked again, after a pause."""
        self._changed.update(files)
        if self._timer is not None:
            self._timer.cancel()
        self._timer = asyncio.get_running_loop().call_later(PAUSE, self._again)

    @property
    def waits(self) -> bool:
        """Whether the pause after an edit has not passed yet."""
        return self._timer is not None or bool(self._pauses)

    def everything(self) -> None:
        """All that is known may be wrong: settings have changed."""
        for file in list(self._known):
            self._restart(file)
        self.depended()

    async def whole(self, file: str) -> tuple[Finding, ...]:
        """The findings of a program when all of it was gone through; Outdated if it changes meanwhile."""
        known = self._known.get(file)
        if known is None or (not known.whole and not self._idle.has(file)) or self._is_stale(file, known):
            self._begin(file, self._session.view(file))
            known = self._known[file]
        if not known.whole:
            done: asyncio.Future[None] = asyncio.get_running_loop().create_future()
            known.waiting.append(done)
            await done
        return self.findings(file)

    def _is_stale(self, file: str, known: Checked) -> bool:
        """Whether a file that is not open was written since it was checked."""
        return file not in self._session.open_files and known.stamp != self._session.files.stamp(file)

    def _begin(self, file: str, view: View | None, *, urgent: bool = False) -> None:
        known = self._known.setdefault(file, Checked())
        _release(known, Outdated())
        known.whole = False
        known.stamp = self._session.files.stamp(file)
        if view is None:
            self._finish(known, file, (), None)
            return
        self._idle.start(file, self._work(file, view, known), urgent=urgent)

    def _work(self, file: str, view: View, known: Checked) -> Iterator[None]:
        yield
        needs = None if isinstance(view.host, NoFiles) else Needs(view.host)
        host: Host = view.host if needs is None else needs
        run = self._run if self._session.settings.of(file).runs else None
        found: list[Finding] = []
        try:
            analysis = Analysis(view.document, view.ruleset, file, host, run=run, prove=self._prove)
            found = yield from analysis.gathering()
        except Exception as error:
            self._failed(error)
            found = list(known.findings)
        self._finish(known, file, tuple(found), needs)

    def _run(self, analysis: Analysis) -> Iterator[Finding | None]:
        """What a bounded run meets. What goes wrong in an interpreter costs no other finding."""
        from deburr.ran import running

        yield from self._guarded(running(analysis))

    def _prove(self, analysis: Analysis) -> Iterator[Finding | None]:
        """What is proven of its values, under the same guard."""
        from deburr.values import proving

        yield from self._guarded(proving(analysis))

    def _guarded(self, work: Iterator[Finding | None]) -> Iterator[Finding | None]:
        try:
            yield from work
        except Exception as error:
            self._failed(error)

    def _finish(self, known: Checked, file: str, found: tuple[Finding, ...], needs: Needs | None) -> None:
        before = _places(known)
        known.findings, known.whole, known.needs = found, True, needs
        for each in sorted({file} | before | _places(known)):
            self._say(each)
        _release(known, None)

    def _later(self, file: str) -> None:
        """Go through an edited program when nothing was typed for a moment; whoever asks for the whole need not wait for that."""
        if (timer := self._pauses.pop(file, None)) is not None:
            timer.cancel()
        self._pauses[file] = asyncio.get_running_loop().call_later(BREATH, self._rested, file)

    def _rested(self, file: str) -> None:
        self._pauses.pop(file, None)
        program, known = self._session.open_files.get(file), self._known.get(file)
        if program is not None and known is not None and not known.whole and not self._idle.has(file):
            self._begin(file, program.view, urgent=True)

    def _again(self) -> None:
        """Check what depends on the files that were changed."""
        self._timer = None
        changed, self._changed = self._changed, set()
        self.changed(changed)
        host = self._session.files
        found = [
            file
            for file, known in self._known.items()
            if known.needs is not None and any(known.needs.concerned(path, host) for path in changed)
        ]
        for file in found:
            self._restart(file)
        if found:
            self.depended()

    def _restart(self, file: str) -> None:
        program = self._session.open_files.get(file)
        if program is not None:
            self._session.settle(program)
            self._begin(file, program.view)
        else:
            self._begin(file, self._session.view(file))


def _places(known: Checked | None) -> set[str]:
    """The files in which a program's check found something."""
    return {finding.place.file for finding in known.findings} if known else set()


def _release(known: Checked | None, error: Exception | None) -> None:
    """Tell those who wait for a check that it is done, or that it never will be."""
    waiting = known.waiting if known is not None else []
    for future in waiting:
        if future.done():
            continue
        if error is None:
            future.set_result(None)
        else:
            future.set_exception(error)
    waiting.clear()
