"""What a language answers whose configuration gives no name a value, and whose loops have no counters of their own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.symbols.constants import Held, Settings, Value

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.symbols import Symbol
    from deburr_grammar.document import Document


def given(symbol: Symbol, file: str, settings: Settings, host: Host) -> None:
    """No setting says what a name holds throughout a program: where it has a value at the start, programs change it."""


def names(file: str, settings: Settings, host: Host) -> Iterator[str]:
    """No setting gives a name a value."""
    yield from ()


def counted(document: Document, line: int, symbol: Symbol, total: Value | None, held: Held) -> Value | None:
    """No loop has a counter of its own."""
    return total


def shown(value: float) -> str:
    """A value as a person writes it."""
    return f"{value:.9g}" if value else "0"
