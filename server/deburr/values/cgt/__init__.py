"""CGT's part in proving values: the sections of a template, and the generator that runs them in any order (spec/cgt.md §1, §6). Says nothing of what is found."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from deburr.analysis import Analysis
    from deburr.values.program import Routine
    from deburr_grammar.document import Document


def worth(document: Document) -> Generator[None, None, bool]:
    """Whether any line has a word, a table or a loop."""
    from deburr.values.cgt.lines import concerns

    return (yield from concerns(document))


def routines(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The generator and all sections; None where the template cannot be read."""
    from deburr.values.cgt.split import routines_of

    return (yield from routines_of(analysis))


def written(key: object) -> str:
    """A word as one writes it."""
    return f"#{key}"


def read(said: str) -> object:
    """The word that is written so."""
    return said.removeprefix("#")
