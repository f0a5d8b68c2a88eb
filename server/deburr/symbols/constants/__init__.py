"""What is certain of values without a run: constants that are assigned, values from the configuration, loops of a known length. Never guesses.

A module is named after its dialect and found by that name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.symbols import Mention, Symbol
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode
    from deburr_grammar.text import Span

Settings = Mapping[str, Any]
Held = Callable[[int, str], "Value | None"]
"""What a name that is written on a line holds before the block that the line opens, as far as it is known."""


class Value(NamedTuple):
    """What a name holds. ``last``, ``step`` and ``passes`` are those of a loop that counts it; ``why``: where that comes from, in Markdown."""

    first: str
    why: str
    last: str = ""
    step: str = ""
    passes: int = 0

    @property
    def plain(self) -> str | None:
        """The one text that it holds; None while a loop counts it."""
        return None if self.passes else self.first

    @property
    def said(self) -> str:
        """The value in words: `5`, or `5 … 15 step 5 (3 passes)`."""
        counted = f" ({count(self.passes)})" if self.passes else ""
        if not self.last:
            return f"{self.first}{counted}"
        return f"{self.first} … {self.last}{f' step {self.step}' if self.step else ''}{counted}"


def count(passes: int) -> str:
    """A number of passes in words."""
    return f"{passes:,} pass{'' if passes == 1 else 'es'}"


class Length(NamedTuple):
    """How often the loop that starts on a line goes round, and the columns that say so; ``text`` may say more."""

    span: Span
    text: str


class Constants(Protocol):
    """What a dialect's module knows of values."""

    def assigned(self, document: Document, line: int, mention: Mention, settings: Settings) -> str | None:
        """What a mention gives the thing that it sets, whenever its line is reached; None if the line alone does not tell."""

    def given(self, symbol: Symbol, file: str, settings: Settings, host: Host) -> Value | None:
        """What a symbol holds throughout a program because its configuration says so."""

    def names(self, file: str, settings: Settings, host: Host) -> Iterator[str]:
        """The names that a program's configuration gives values, as they are written."""

    def counted(self, document: Document, line: int, symbol: Symbol, total: Value | None, held: Held) -> Value | None:
        """What a symbol holds in a loop around a line that counts it; ``total`` if no loop does."""

    def disturbed(self, document: Document, first: int, last: int) -> bool:
        """Whether a run can come into these lines (both included) from elsewhere, or values change in them without being named."""

    def results(self, line: LineNode, settings: Settings) -> Iterator[tuple[Span, str]]:
        """The expressions of a line that come to one value on every run, outermost ones, with that value."""

    def lengths(self, document: Document, line: int, held: Held, settings: Settings) -> Iterator[Length]:
        """The lengths of the loops that start on a line, as far as they are known."""

    def row(self, document: Document, line: int, mention: Mention) -> str | None:
        """The text that a mention prints, where it means a row of a table."""


@cache
def constants_of(dialect: str) -> Constants | None:
    """The module of a dialect; None if it has none."""
    name = f"{__name__}.{dialect}"
    found: Constants | None = import_module(name) if find_spec(name) is not None else None
    return found
