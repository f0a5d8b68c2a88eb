"""Writes the prebuilt tables of every dialect, Lark's and those of its codes: `python -m deburr_grammar.tables`. Never runs when deburr is used."""

from pathlib import Path

from deburr_grammar.dialects import NAMES, by_name


def main() -> None:
    """Write `line.tables` and `codes.tables` into each dialect's folder, where they are not there or were made from something else."""
    for dialect in map(by_name, NAMES):
        folder = Path(__file__).parent / "dialects" / dialect.name
        for file, source in (("line.tables", dialect.grammar), ("codes.tables", dialect.codes)):
            if not source.fresh:
                (folder / file).write_bytes(source.tables())


if __name__ == "__main__":
    main()
