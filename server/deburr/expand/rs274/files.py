"""What an RS274 run reads besides its program: subprogram files and stored parameters. Opens nothing itself: it asks the host."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from deburr.expand.rs274.machine import may_be_given
from deburr.expand.rs274.state import READ_ONLY
from deburr.expand.rs274.unit import Unit
from deburr.formats.parameters import read
from deburr.steps import done
from deburr.suggest import suggestion
from deburr_grammar.dialects.rs274.names import name_of
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.state import State

_NUMBERED = re.compile(r"(?i)m[ \t]*0*[ \t]*98[ \t]*p[ \t]*0*([0-9]+)")
_NAMED = re.compile(r"#[ \t]*<([^<>\r\n]*)>")
_INDEX = re.compile(r"#[ \t]*0*([0-9]+)")
_CALCULATED = re.compile(r"#[ \t]*[^ \t0-9<]|[0-9][ \t]+[0-9]")
"""A number of a parameter that is calculated, or written with blanks in it."""
_OWN = 5000
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def loaded(job: Job, label: str) -> Unit | None:
    """The file of a subprogram: its name in lower case and `.ngc`, beside the program or on the configured path (spec/oracle.md §1)."""
    for folder in (job.programs[0].file.rpartition("/")[0], *job.settings["subroutine-path"]):
        path = f"{folder.rstrip('/')}/{label}.ngc" if folder else f"{label}.ngc"
        text = job.host.read(path)
        if text is not None:
            return done(Unit.making(path, Document.parse(text, job.ruleset.dialect)))
    return None


def called_files(unit: Unit, load: Callable[[str], Unit | None]) -> Iterator[Unit | None]:
    """A program and the files that its calls lead to, and theirs; None for each that only the run knows. ``load`` brings the file of a label."""
    seen: set[str | None] = set()
    waiting = [unit]
    while waiting:
        unit = waiting.pop()
        yield unit
        called = {*unit.called, *_NUMBERED.findall(unit.document.text)} - seen
        seen |= called
        if None in called:
            yield None
        waiting += [file for label in called if label is not None and (file := load(label)) is not None]


def unread(job: Job, unit: Unit, load: Callable[[str], Unit | None]) -> Iterator[str]:
    """What there is to say of values that were given for the run, and that neither the program nor a file that it calls mentions."""
    given = {name: name_of(name) for name in job.inputs.typed}
    files = list(called_files(unit, load)) if given else []
    if None in files:
        return
    text = "\n".join(file.document.text for file in files if file is not None).lower()
    names = set(map(name_of, _NAMED.findall(text)))
    numbers = {int(said) for said in _INDEX.findall(text)}
    for said, name in given.items():
        if name.isascii() and name.isdigit():
            # Numbers from 5000 on mean something to the control, and others can be calculated.
            if int(name) < _OWN and int(name) not in numbers and not _CALCULATED.search(text):
                yield f"-D {said}: the program never reads `#{name}`"
        elif name not in names:
            yield f"-D {said}: the program never reads `#<{name}>`{suggestion(name, names)}"


def unread_by_programs(job: Job) -> Iterator[str]:
    """What `unread` says where no run begins."""
    for program in job.programs:
        unit = done(Unit.making(program.file, program.document))
        yield from unread(job, unit, partial(loaded, job))


def first_values(state: State) -> None:
    """Stored parameters, then what was defined for this run: `5=1.25`, `_name=2`."""
    path = state.job.settings["parameters"]
    for number, value in read((state.job.host.read(path) or "") if path else "").values.items():
        state.params[number] = value
    for name, said in state.job.inputs.define.items():
        _define(state, name.strip().removeprefix("#"), said)


def _define(state: State, name: str, said: str) -> None:
    value = float(said) if _NUMBER.fullmatch(said) else math.inf
    if not math.isfinite(value):
        raise state.job.unusable("param-range", f"{name}={said}", "the value is no number")
    plain = name_of(name)
    if plain.isascii() and plain.isdigit():
        if not 1 <= int(plain) <= state.last:
            message = f"parameters go from 1 to {state.last}"
            raise state.job.unusable("param-range", f"{name}={said}", message)
        if int(plain) in READ_ONLY:
            message = f"the control sets `#{int(plain)}` itself; programs can only read it"
            raise state.job.unusable("param-readonly", f"{name}={said}", message)
        state.params[int(plain)] = value
    elif state.machine.named(plain) is not None and not may_be_given(plain):
        message = f"the control sets `#<{plain}>` itself; programs can only read it"
        raise state.job.unusable("param-readonly", f"{name}={said}", message)
    else:
        (state.globals if plain.startswith("_") else state.locals)[plain] = value
