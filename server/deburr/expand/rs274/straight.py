"""Programs without values and flow: their lines are copied as they stand, without a closure for each."""

from __future__ import annotations

import re
from collections.abc import Callable, Generator
from enum import Enum
from typing import TYPE_CHECKING

from deburr.expand.rs274.comments import ABORTS

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.dialect import Reading
    from deburr_grammar.line import Shape

_NUMBER = re.compile(r"[ \t]*[nN][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?")
_STEPS = re.compile(r"(?i:m[ \t]*0*[ \t]*(?:2|3[ \t]*0|7[ \t]*[0-3]|9[ \t]*[89])|g[ \t]*7[ \t]*[0-2])(?![0-9])")
"""Codes that end the program, go elsewhere, or need more than their own line."""
_TREATED = frozenset(("o_line", "PERCENT", "DELETE"))


class _Way(Enum):
    """What is to be done with lines of a shape."""

    COPY = "copy"
    STRIP = "copy without the line number, unless it holds an `(ABORT`"
    RUN = "run"


def straight(job: Job, unit: Unit, run: Callable[[int], int]) -> Generator[None, None, int]:
    """Copy lines from the first on, up to one behind which the next line is not the next. Gives the row at which the run goes on, below 0 if it is over."""
    row, left = 0, job.slice(unit.file, 0, None)
    for piece in unit.document.pieces():
        lines = piece.chunk.lines
        for reading, first, shapes in piece.read():
            for text, shape in zip(lines[first:], shapes):
                way = shape.memo.get("rs274 way") or _way(shape, reading)
                if way is _Way.COPY:
                    job.emit(text, unit.file, row, None)
                elif way is _Way.RUN or not _stripped(job, unit.file, row, text):
                    behind = run(row)
                    if behind != row + 1:
                        job.steps -= left
                        return behind
                row += 1
                left -= 1
                if not left:
                    yield
                    left = job.slice(unit.file, row, None)
    job.steps -= left
    return row


def without_number(text: str) -> str:
    """A line without its line number."""
    match = _NUMBER.match(text)
    return text[match.end() :] if match is not None else text


def _way(shape: Shape, reading: Reading) -> _Way:
    facts = shape.facts(reading)
    found = _Way.STRIP if facts.kinds & {"line_number", "COMMENT"} else _Way.COPY
    if reading.start is None or facts.problems or not facts.kinds.isdisjoint(_TREATED) or _STEPS.search(shape.text):
        found = _Way.RUN
    shape.memo["rs274 way"] = found
    return found


def _stripped(job: Job, file: str, row: int, text: str) -> bool:
    """Copy a line that may have a number or a comment; not one that stops the program."""
    if ABORTS.search(text):
        return False
    if not job.inputs.keep_n:
        shown = without_number(text)
        if not shown.strip() and text.strip():
            return True
        text = shown
    job.emit(text, file, row, None)
    return True
