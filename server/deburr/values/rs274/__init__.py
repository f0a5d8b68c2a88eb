"""RS274's part in proving values: its routines, and what they start with. Says nothing of what is found."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from deburr.analysis import Analysis
    from deburr.values.program import Routine
    from deburr_grammar.document import Document


def worth(document: Document) -> Generator[None, None, bool]:
    """Whether anything in the program has a value that a line does not tell alone."""
    from deburr.values.rs274.lines import concerns

    return (yield from concerns(document))


def routines(analysis: Analysis) -> Generator[None, None, Mapping[str, Routine] | None]:
    """The main program and the subprograms; None where nothing can be said of them."""
    from deburr.values.rs274.split import routines_of

    return (yield from routines_of(analysis))


def written(key: object) -> str:
    """A parameter as one writes it."""
    return f"#<{key}>" if isinstance(key, str) else f"#{key}"


def read(said: str) -> object:
    """The parameter that is written so."""
    name = said.removeprefix("#").strip("<>")
    return int(name) if name.isdecimal() and "<" not in said else name
