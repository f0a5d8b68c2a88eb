"""The values that a MetaGCODE run starts with: those of the configured file, and over them those that are given by name (spec/metagcode.md §5.2)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.fault import Fault
from deburr.formats.variables import Defect, Values, read_values
from deburr.host import NoFiles
from deburr.includes import beside
from deburr_grammar.dialects.metagcode.forms import names
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job

_IMPROPER = (
    (
        "value-has-bar",
        re.compile(r"\|"),
        "has a bar in it, and values are not filled in again; write it without bars",
    ),
    (
        "value-has-line-end",
        re.compile(r"[\r\n]"),
        "has a line end in it, which would make two blocks of one; write it on one line",
    ),
)
"""What no value may hold: the rule, the sign, the words."""


class _Given(NamedTuple):
    """A value as it was defined, and the file in which; none if it was given by its name."""

    name: str
    text: str
    file: str = ""


def values_of(job: Job) -> tuple[dict[str, str], list[Fault]]:
    """The values by their names, and what is wrong with them or with their file."""
    setting = str(job.settings["variables"])
    given = [_Given(name.strip(" \t"), text) for name, text in job.inputs.define.items()]
    faults: list[Fault] = []
    if setting and not isinstance(job.host, NoFiles):
        path = beside(job.programs[0].file, setting)
        text = job.host.read(path)
        read = Values({}, (), False) if text is None else read_values(text, path)
        given[:0] = [_Given(name, value.text, path) for name, value in read.known.items()]
        faults = [_unread(job, path)] if text is None else [_broken(path, defect) for defect in read.defects]
    faults += [fault for each in given for fault in _improper(job, each)]
    return {each.name: each.text for each in given}, faults


def _unread(job: Job, path: str) -> Fault:
    message = f"the file of values `{path}` cannot be read, so no variable has a value"
    return Fault("variables-file", job.programs[0].file, 0, Span(0, 0), message)


def _broken(path: str, defect: Defect) -> Fault:
    message = f"this line of the file of values cannot be used: {defect.why}"
    return Fault("variables-file", path, defect.line, defect.span, message)


def _improper(job: Job, given: _Given) -> Iterator[Fault]:
    """What no value may hold, whether it is used or not."""
    for kind, pattern, wrong in _IMPROPER:
        if not pattern.search(given.text):
            continue
        if given.file:
            message = f"the value of `|{given.name}|`, from `{given.file}`, {wrong}"
            yield Fault(kind, *_first_use(job, given.name), message)
        else:
            yield job.unusable(kind, f"{given.name}=...", f"the value {wrong}").fault


def _first_use(job: Job, name: str) -> tuple[str, int, Span]:
    """Where the programs refer to a name first; their first line if they do not."""
    for program in job.programs:
        for piece in program.document.pieces():
            for index, line in enumerate(piece.chunk.lines) if name in piece.chunk.text else ():
                for start, found in names(line):
                    if found == name:
                        return program.file, piece.line + index, Span(start, line.index("|", start + 1) + 1)
    return job.programs[0].file, 0, Span(0, 0)
