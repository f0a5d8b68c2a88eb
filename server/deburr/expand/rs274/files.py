"""What an RS274 run reads besides its program: subprogram files and stored parameters. Opens nothing itself: it asks the host."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from deburr.expand.rs274.unit import Unit
from deburr.formats.parameters import read
from deburr.steps import done
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.state import State

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def loaded(job: Job, label: str) -> Unit | None:
    """The file of a subprogram: its name in lower case and `.ngc`, beside the program or on the configured path (spec/oracle.md §1)."""
    for folder in (job.programs[0].file.rpartition("/")[0], *job.settings["subroutine-path"]):
        path = f"{folder.rstrip('/')}/{label}.ngc" if folder else f"{label}.ngc"
        text = job.host.read(path)
        if text is not None:
            return done(Unit.making(path, Document.parse(text, job.ruleset.dialect)))
    return None


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
    plain = name.strip("<>").lower()
    if plain.isascii() and plain.isdigit():
        if not 1 <= int(plain) <= state.last:
            message = f"parameters go from 1 to {state.last}"
            raise state.job.unusable("param-range", f"{name}={said}", message)
        state.params[int(plain)] = value
    else:
        (state.globals if plain.startswith("_") else state.locals)[plain] = value
