"""Where flat lines go: to the writer and the judge, or to the contour that is being gathered. Makes no line itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from deburr.expand.rs274.judge import Judge

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.copying import Stretch
    from deburr.expand.rs274.state import State
    from deburr.expand.rs274.unit import Unit
    from deburr.fault import Frame


class Output:
    """The flat lines of one run."""

    def __init__(self, job: Job, state: State) -> None:
        self._job = job
        self._state = state
        self._judge: Judge | None = None

    def judged(self) -> None:
        """Have all lines judged from here on."""
        self._judge = Judge(self._job)

    def emit(self, text: str, unit: Unit, row: int, frame: Frame | None, does: Sequence[str] | None = None) -> None:
        """A flat line. ``does``: the lines that do the same, if it does not say that itself."""
        if self._state.contour is not None:
            self._state.contour.append((text, unit, row, frame))
            return
        self._job.emit(text, unit.file, row, frame)
        if self._judge is None:
            return
        if does is None:
            self._judge.add(text, unit, row, frame)
        else:
            self._judge.heed(does, unit, row, frame)

    def ask(self, text: str, unit: Unit, row: int, frame: Frame | None) -> None:
        """Have a line judged that the next ones stand for."""
        if self._judge is not None and self._state.contour is None and text.strip():
            self._judge.ask(text, unit, row, frame)

    def copy(self, part: Stretch, unit: Unit) -> None:
        """Lines as they stand in their program."""
        texts, rows, shapes = part.bare()
        frame = self._state.frame
        if self._state.contour is not None:
            self._state.contour += ((text, unit, row, frame) for text, row in zip(texts, rows))
            return
        if self._job.inputs.keep_n:
            texts, rows, shapes = part.lines, range(part.first, part.first + len(part.lines)), part.shapes
        self._job.copy(texts, unit.file, rows, frame)
        if self._judge is not None:
            self._judge.copied(texts, shapes, unit, rows, frame)

    def settle(self) -> None:
        """Judge what waits."""
        if self._judge is not None:
            self._judge.settle()

    def finish(self) -> None:
        """Judge what is left, and where the moves of the program lead."""
        if self._judge is not None:
            self._judge.finish()
