"""From the lines of a flat program to its path."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.motion.form import Form
from deburr.motion.machine import Machine
from deburr.motion.path import Recorder

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from deburr.motion.path import Path

SLICE = 250
"""Lines between two moments at which the work can be left."""


def follow(lines: Iterable[str], form: Form | None = None) -> Path:
    """The path of a flat program, to its end."""
    recorder = Recorder()
    for _ in following(lines, recorder, form):
        pass
    return recorder.path()


def following(lines: Iterable[str], recorder: Recorder, form: Form | None = None) -> Iterator[None]:
    """The same as work in slices, into a recorder."""
    machine = Machine(form or Form(), recorder)
    for flat, line in enumerate(lines):
        machine.line(line, flat)
        if machine.ended:
            return
        if flat % SLICE == SLICE - 1:
            yield
