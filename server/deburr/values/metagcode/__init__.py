"""MetaGCODE's part in proving values: a text with its snippets is one routine. Its variables come from outside and never change, so all that is known of them is what conditions and loops say."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from deburr.analysis import Analysis
    from deburr.values.program import Routine
    from deburr_grammar.document import Document


def worth(document: Document) -> Generator[None, None, bool]:
    """Whether any line asks for a value."""
    from deburr.values.metagcode.lines import concerns

    return (yield from concerns(document))


def routines(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The text with all its snippets; None where its blocks do not fit together."""
    from deburr.values.metagcode.flow import routine_of

    found = yield from routine_of(analysis)
    return None if found is None else {found.name: found}


def written(key: object) -> str:
    """A variable as one writes it."""
    return f"|{key}|"


def read(said: str) -> object:
    """The variable that is written so."""
    return said.strip("|").strip(" \t")
