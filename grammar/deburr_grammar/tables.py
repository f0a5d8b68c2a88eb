"""Writes the prebuilt Lark tables of every dialect: `python -m deburr_grammar.tables`. Never runs when deburr is used."""

from pathlib import Path

from deburr_grammar.dialects import NAMES, by_name


def main() -> None:
    """Write `line.tables` into each dialect's folder, where it is not there or of another grammar."""
    for dialect in map(by_name, NAMES):
        if not dialect.grammar.fresh:
            path = Path(__file__).parent / "dialects" / dialect.name / "line.tables"
            path.write_bytes(dialect.grammar.tables())


if __name__ == "__main__":
    main()
