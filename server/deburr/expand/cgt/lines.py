"""The flat lines of a template: put together from pieces, numbered, and held back while a block number in them is not known (spec/cgt.md §4, §5.3). Runs nothing."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, NamedTuple

from deburr.fault import Fault, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Callable

    from deburr.expand.job import Job
    from deburr.fault import Frame

LONGEST = 1_000_000
"""Characters of a flat line: only a `#REPEAT` without line breaks makes long ones."""


class Place(NamedTuple):
    """A part of the template: its row and its columns."""

    row: int
    span: Span


class Later(str):
    """The piece of a line that stands for a block number; ``number`` is None until a `#SETBLK` gives it."""

    number: str | None
    place: Place
    said: str


class _Held(NamedTuple):
    pieces: tuple[str, ...]
    row: int
    frame: Frame | None


class Lines:
    """The output of a run. ``out`` are the pieces of the line that is being put together; ``row`` and ``begun`` are where it began and in what."""

    def __init__(self, job: Job, file: str) -> None:
        self._job = job
        self._emit = job.emit
        self._file = file
        self.frame: Frame | None = None
        """What the run is in."""
        self.out: list[str] = []
        self.row = 0
        self.begun: Frame | None = None
        self.loud = True
        """Whether lines are output: those of `@DECLARE` and of sections that compute are not."""
        self._number: Callable[[], str] | None = None
        self._plain = True
        self._asked = False
        """Whether a number was asked for before it was known: from then on lines are looked at piece by piece."""
        self._marks: dict[float, str] = {}
        self._wanted: dict[float, list[Later]] = {}
        self._held: deque[_Held] = deque()
        self._length = self._counted = 0

    def begin(self, row: int) -> None:
        """Something is put on the line. If nothing is on it yet, it comes from there, however many passes of a loop it goes on through."""
        if not self.out:
            self.row, self.begun = row, self.frame

    def write(self, pieces: list[str], row: int) -> None:
        """One line, or none if it has no text."""
        self._write(pieces, row, self.frame)

    def flush(self) -> None:
        """Write what was put together."""
        if self.out:
            self._write(self.out, self.row, self.begun)
            self.out.clear()
        self._length = self._counted = 0

    def grown(self, at: Place) -> None:
        """Stop a line that grows without end."""
        self._length += sum(map(len, self.out[self._counted :]))
        self._counted = len(self.out)
        if self._length > LONGEST or self._counted > LONGEST:
            message = f"the passes of this loop make one line of more than {LONGEST:,} characters; a line break behind its `<` ends the line after each pass"
            raise Halt(Fault("limit", self._file, at.row, at.span, message, self.frame))

    def silence(self, loud: bool) -> None:
        """Output lines from here on, or none."""
        self.loud = loud
        self._settle()

    def number_with(self, number: Callable[[], str]) -> None:
        """Put a block number in front of each line from here on."""
        self._number = number
        self._plain = False

    def mark(self, key: float, number: str) -> None:
        """`#SETBLK`: the present line has that number."""
        self._marks[key] = number
        for piece in self._wanted.pop(key, ()):
            piece.number = number
        self._release()

    def marked(self, key: float, said: str, at: Place) -> str:
        """`#GETBLK`: the number of a marked line; if none is marked yet, what stands for it."""
        if key in self._marks:
            return self._marks[key]
        # Some text, so that the line is not taken for an empty one.
        piece = Later("?")
        piece.number, piece.place, piece.said = None, at, said
        self._wanted.setdefault(key, []).append(piece)
        self._asked, self._plain = True, False
        return piece

    def finish(self) -> None:
        """The run is over: numbers that are still not known stay out."""
        for pieces in self._wanted.values():
            for piece in pieces:
                message = f"no `#SETBLK` marked the block of `{piece.said}`, so it has no number"
                self._job.meet(Fault("getblk-unset", self._file, piece.place.row, piece.place.span, message, None))
                piece.number = ""
        self._release()

    def _write(self, pieces: list[str], row: int, frame: Frame | None) -> None:
        if self._plain:
            if text := "".join(pieces):
                self._emit(text, self._file, row, frame)
        elif self.loud:
            self._put(pieces, row, frame)

    def _put(self, pieces: list[str], row: int, frame: Frame | None) -> None:
        if not any(pieces):
            return
        line = (self._number(), *pieces) if self._number is not None else tuple(pieces)
        if not self._held and _known(line):
            self._emit(_text(line), self._file, row, frame)
            return
        self._held.append(_Held(line, row, frame))
        most = self._job.budget.blocks
        if most and self._job.emitted + len(self._held) > most:
            first = next(piece for piece in self._held[0].pieces if isinstance(piece, Later))
            way = self._job.inputs.ways.blocks
            message = f"more than {most:,} lines wait for the block number of `{first.said}`; {way} sets another limit"
            raise Halt(Fault("limit", self._file, first.place.row, first.place.span, message, self.frame))

    def _release(self) -> None:
        held = self._held
        while held and _known(held[0].pieces):
            pieces, row, frame = held.popleft()
            if text := _text(pieces):
                self._emit(text, self._file, row, frame)

    def _settle(self) -> None:
        self._plain = self.loud and self._number is None and not self._asked


def _known(pieces: tuple[str, ...]) -> bool:
    return all(piece.number is not None for piece in pieces if isinstance(piece, Later))


def _text(pieces: tuple[str, ...]) -> str:
    return "".join([(piece.number or "") if isinstance(piece, Later) else piece for piece in pieces])
