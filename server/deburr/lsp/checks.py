"""When programs are checked and who is told: at once what an edit decides, the rest in idle slices, and again what depends on it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import reduce
from heapq import merge
from itertools import chain, groupby, islice
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.finding import Severity, joined
from deburr.host import NoFiles
from deburr.ide.held import Held
from deburr.ide.moved import Structure, found_anew, moved, structural, structure_of
from deburr.lsp.checked import Checked, learning, once, order, release
from deburr.needs import Needs
from deburr.steps import let_go, paced
from deburr.symbols.index import reading

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr.host import Host
    from deburr.ide.view import View
    from deburr.lsp.idle import Idle
    from deburr.lsp.session import Open, Session
    from deburr_grammar.text import Edit

BREATH = 0.03
"""Seconds without an edit after which an edited program is gone through as a whole."""
MOMENT = 0.01
"""Seconds after which what a check leaves behind is let go: an edit is often followed by questions about it. Less than a breath, so that it is done between two keys."""
_READING = "names"
PAUSE = 0.1
"""Seconds without an edit after which the programs that depend on what was edited are checked again."""


class Outdated(Exception):
    """What was waited for is of no interest any more: the program has changed."""


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
        self.done: Callable[[], None] = lambda: None
        """Called when a program has been gone through."""
        self.changed: Callable[[set[str]], None] = lambda files: None
        """Called with files that are not as they were, when the pause behind the last edit has passed."""

    def findings(self, file: str) -> tuple[Finding, ...]:
        """What is known of a file: what its own check found there and what those of others did."""
        return tuple(self._merged(file))

    def first(self, file: str, count: int) -> tuple[list[Finding], int]:
        """The first findings in a file, and how many there are in all; about how many, where there are more than these and two checks found the same."""
        own = self._known.get(file)
        several = 0 if own is None else len(own.still) + len(own.blocks) + len(own.ran)
        found = list(islice(self._merged(file), count))
        return found, len(found) if len(found) < count else several + len(self._by_others(file))

    def on(self, file: str, first: int, last: int) -> list[Finding]:
        """The findings that begin on some lines of a file, both included."""
        own = self._known.get(file)
        lists = [own.still.on(first, last), own.ran.on(first, last)] if own else []
        more = [*(own.blocks if own else ()), *self._by_others(file)]
        return once(chain(*lists, (each for each in more if first <= each.place.line <= last)))

    def elsewhere(self, file: str) -> dict[str, tuple[Finding, ...]]:
        """What the check of a program found in other files."""
        own = self._known.get(file)
        return {other: self.findings(other) for other in sorted(own.elsewhere)} if own else {}

    def _merged(self, file: str) -> Iterator[Finding]:
        own = self._known.get(file)
        lists: list[Iterable[Finding]] = [own.still, own.blocks, own.ran] if own else []
        every = merge(*lists, once(self._by_others(file)), key=order)
        return (reduce(joined, same) for _, same in groupby(every, key=order))

    def _by_others(self, file: str) -> list[Finding]:
        """What the checks of other programs found in a file."""
        checks = (known for other, known in self._known.items() if other != file)
        reading = (known for known in checks if known.needs is not None and file in known.needs.texts)
        return [finding for known in reading for finding in known.elsewhere.get(file, ())]

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
            with Analysis(view.document, view.ruleset, view.file, view.host) as analysis:
                known.still = moved(known.still, edits, analysis).also(found_anew(edits, analysis))
                known.ran = moved(known.ran, edits, analysis)
                structure = structure_of(analysis)
                if not structure.stays(known.structure):
                    known.blocks = tuple(once(structural(analysis, structure)))
                known.structure = structure
            self._say(program.file)
        self._leave(program.file)
        release(known, Outdated())
        self._later(program.file)
        self.touched(program.file)

    def closed(self, program: Open) -> None:
        """A program was closed."""
        self._leave(program.file)
        known = self._known.pop(program.file, None)
        release(known, Outdated())
        self._say(program.file)
        for file in known.elsewhere if known is not None else ():
            self._say(file)
        self.touched(program.file)

    def _leave(self, file: str) -> None:
        """Leave what is being done for a program."""
        self._idle.drop(file)
        self._idle.drop((_READING, file))

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
        release(known, Outdated())
        known.whole = False
        known.stamp = self._session.files.stamp(file)
        if view is None:
            before = set(known.elsewhere)
            known.still, known.blocks, known.ran, known.elsewhere = Held(), (), Held(), {}
            known.structure = Structure()
            self._finish(known, file, None, before)
            return
        self._idle.start(file, self._work(file, view, known), urgent=urgent)

    def _work(self, file: str, view: View, known: Checked) -> Iterator[None]:
        yield
        needs = None if isinstance(view.host, NoFiles) else Needs(view.host)
        host: Host = view.host if needs is None else needs
        run = self._run if self._session.settings.of(file).runs else None
        before = set(known.elsewhere)
        with Analysis(view.document, view.ruleset, file, host, run=run, prove=self._prove) as analysis:
            try:
                yield from self._gone_through(analysis, known)
            except Exception as error:
                self._failed(error)
            finally:
                self._idle.later(MOMENT, let_go(list(analysis.memo.values())))
        self._finish(known, file, needs, before)
        if file in self._session.open_files:
            self._idle.start((_READING, file), self._read(file, view))

    def _read(self, file: str, view: View) -> Iterator[None]:
        """Read the names of a program, so that no question has to."""
        yield from reading(view.document)
        program = self._session.open_files.get(file)
        if program is not None and program.view is view and not view.is_read:
            program.view = replace(view, is_read=True)
            self.done()
            self.depended()

    def _gone_through(self, analysis: Analysis, known: Checked) -> Iterator[None]:
        """Learn all of a program; what it says as it stands is told before its values are proven and it is run."""
        still: list[Finding] | None = None

        def early(found: list[Finding]) -> Iterator[None]:
            nonlocal still
            still = found
            # A program with an error is not run, so nothing of a run is left of it.
            keeps = all(finding.severity is not Severity.ERROR for finding in found)
            yield from learning(known, analysis, found, known.ran if keeps else Held())
            self._say(analysis.file)

        found = yield from analysis.gathering(early)
        known_still: set[Finding] = set()
        for each in paced(found if still is None else still):
            if each is None:
                yield
            else:
                known_still.add(each)
        more: list[Finding] = []
        for each in paced(found):
            if each is None:
                yield
            elif each not in known_still:
                more.append(each)
        ran = yield from Held.holding(finding for finding in more if finding.place.file == analysis.file)
        yield from learning(known, analysis, found, ran, frozenset(more))

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

    def _finish(self, known: Checked, file: str, needs: Needs | None, before: set[str]) -> None:
        known.whole, known.needs = True, needs
        for each in sorted({file} | before | set(known.elsewhere)):
            self._say(each)
        release(known, None)
        self.done()

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
