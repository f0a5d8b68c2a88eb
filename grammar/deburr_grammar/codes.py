"""The tables of a dialect: codes, words, functions, keywords, variables, with what hover says of each. Never interprets a line.

`codes.tables` holds what `codes.toml` and `variables.toml` say, ready to be loaded
(`python -m deburr_grammar.tables` writes it, a test proves it fresh): reading large TOML
files costs more than all the rest of a short check.
"""

import marshal
import pkgutil
import re
import zlib
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any, NamedTuple


class Entry(NamedTuple):
    """One line of a table. ``first`` and ``last`` bound a family (`M100-M199`, `PAL[256..512]`), both included."""

    table: str
    name: str
    title: str
    text: str
    first: int | None = None
    last: int | None = None
    more: Mapping[str, Any] = {}

    def covers(self, number: int) -> bool:
        """Whether a number lies in the family."""
        return self.first is not None and self.last is not None and self.first <= number <= self.last


_Row = tuple[str, str, str, int | None, int | None, dict[str, Any]]
"""An entry without its table."""


class CodeTable:
    """The tables of one dialect, read from its `codes.toml` and `variables.toml` when first asked."""

    def __init__(self, package: str) -> None:
        self._package = package

    def table(self, name: str) -> tuple[Entry, ...]:
        """All entries of a table: "code", "word", "function", "keyword", "variable", ..."""
        return self._tables.get(name, ())

    def entry(self, table: str, name: str) -> Entry | None:
        """The entry of that name; names are compared without regard to case."""
        return self._by_name.get((table, name.lower()))

    def family(self, table: str, number: int) -> Entry | None:
        """The narrowest family of a table that covers a number."""
        found = [entry for entry in self.table(table) if entry.covers(number)]
        return min(found, key=lambda entry: (entry.last or 0) - (entry.first or 0), default=None)

    def __iter__(self) -> Iterator[Entry]:
        return (entry for entries in self._tables.values() for entry in entries)

    @property
    def fresh(self) -> bool:
        """Whether `codes.tables` is there and made from the tables as they are."""
        return _read(self._package, "codes.tables").startswith(self._key)

    def tables(self) -> bytes:
        """What `codes.tables` should hold."""
        return self._key + marshal.dumps(self._rows(), 2)

    @cached_property
    def _tables(self) -> dict[str, tuple[Entry, ...]]:
        stored = _read(self._package, "codes.tables")
        rows = marshal.loads(stored[len(self._key) :]) if stored.startswith(self._key) else self._rows()
        return {table: tuple(Entry(table, *row) for row in found) for table, found in rows.items()}

    def _rows(self) -> dict[str, list[_Row]]:
        import tomllib

        found: dict[str, list[_Row]] = {}
        for text in self._texts:
            for table, rows in tomllib.loads(text.decode("utf-8")).items():
                found[table] = [*found.get(table, ()), *map(_row, rows)]
        return found

    @cached_property
    def _texts(self) -> tuple[bytes, ...]:
        return tuple(_read(self._package, file) for file in ("codes.toml", "variables.toml"))

    @cached_property
    def _key(self) -> bytes:
        """What the tables are made from, in short: their check sums and sizes."""
        return b"".join(b"%d %d\n" % (zlib.crc32(text), len(text)) for text in self._texts)

    @cached_property
    def _by_name(self) -> dict[tuple[str, str], Entry]:
        return {(entry.table, entry.name.lower()): entry for entry in self}


def code_number(text: str) -> str:
    """The canonical spelling of a code: `g01` is `G1`, `G 38.20` is `G38.2`."""
    match = re.fullmatch(r"([A-Za-z]+)([0-9]*)\.?([0-9]*)", re.sub(r"[ \t]+", "", text))
    if match is None:
        return text.upper()
    letter, whole, fraction = match.groups()
    fraction = fraction.rstrip("0")
    return letter.upper() + (whole.lstrip("0") or "0") + (f".{fraction}" if fraction else "")


def _row(row: dict[str, Any]) -> _Row:
    """A line of a TOML table as `Entry` takes it."""
    name = next(
        (str(row[key]) for key in ("name", "letter", "id") if key in row), f"{row.get('first')}-{row.get('last')}"
    )
    known = {"name", "title", "text", "first", "last"}
    more = {key: value for key, value in row.items() if key not in known}
    return name, row.get("title", ""), row.get("text", ""), row.get("first"), row.get("last"), more


def _read(package: str, file: str) -> bytes:
    try:
        return pkgutil.get_data(package, file) or b""
    except FileNotFoundError:
        return b""
