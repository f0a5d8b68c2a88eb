"""Writes the prebuilt Lark tables of every dialect: `python -m deburr_grammar.tables`. Never runs when deburr is used."""

import io
from pathlib import Path

from deburr_grammar.dialects import NAMES, by_name


def built(package: str, starts: tuple[str, ...]) -> bytes:
    """The tables of one dialect's grammar as bytes."""
    from deburr_grammar.grammar import Grammar

    buffer = io.BytesIO()
    Grammar(package, starts).build().save(buffer)
    return buffer.getvalue()


def main() -> None:
    """Write `line.tables` into each dialect's folder."""
    for dialect in map(by_name, NAMES):
        path = Path(__file__).parent / "dialects" / dialect.name / "line.tables"
        path.write_bytes(built(dialect.package, dialect.starts))


if __name__ == "__main__":
    main()
