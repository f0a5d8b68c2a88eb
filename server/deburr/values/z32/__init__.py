"""Z32's part in proving values: its programs, what calls lead to, and how parameters are written. Says nothing of what is found."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from deburr.analysis import Analysis
    from deburr.values.program import Routine
    from deburr_grammar.document import Document

_ELEMENT = re.compile(r"(PA[LR])\[[ \t]*0*([0-9]+)[ \t]*\]")


def worth(document: Document) -> Generator[None, None, bool]:
    """Whether anything in the program has a value that a line does not tell alone."""
    from deburr.values.z32.lines import concerns

    return (yield from concerns(document))


def routines(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The main program, its sections and the files that are called; None where nothing can be said of them."""
    from deburr.values.z32.split import routines_of

    return (yield from routines_of(analysis))


def written(key: object) -> str:
    """A parameter as one writes it."""
    return str(key)


def read(said: str) -> object:
    """The parameter that is written so."""
    said = said.upper()
    match = _ELEMENT.fullmatch(said)
    return f"{match[1]}[{match[2]}]" if match else said
