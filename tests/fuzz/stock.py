"""Programs to begin with: examples, test lines, what the pages of rules show, and expansions of the tests."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from deburr.catalogue import rules_of
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from support.alphabets import alphabet
from support.code import ROOT
from support.pages import Example, examples

_LONG = 1_200
"""Bytes of a program that a fuzzer can change anywhere and still try often."""
_WORD = 60
"""The longest word that a dictionary of libFuzzer takes."""


def numbered() -> Iterator[tuple[int, Dialect]]:
    """The dialects with the numbers by which they are chosen."""
    return ((number, by_name(name)) for number, name in enumerate(NAMES))


@cache
def programs(dialect: Dialect) -> tuple[bytes, ...]:
    """Short programs of a dialect."""
    found = [
        path.read_bytes()[:_LONG]
        for path in sorted((ROOT / "examples" / dialect.name).rglob("*"))
        if path.suffix in dialect.extensions
    ]
    lines = alphabet(dialect).lines
    found += [dialect.frame.replace("{}", "\n".join(lines[at : at + 8])).encode() for at in range(0, len(lines), 8)]
    return (*found, *(each.program.encode() for each in shown(dialect)))


@cache
def shown(dialect: Dialect) -> tuple[Example, ...]:
    """What the pages of a dialect's rules show."""
    found = (each for rule in rules_of(dialect.name) for each in examples(rule, dialect))
    return tuple(each for each in found if len(each.program) < _LONG)


def words() -> Iterator[str]:
    """The signs and lines of all dialects as a dictionary of libFuzzer."""
    found = {piece for _, dialect in numbered() for piece in (*alphabet(dialect).signs, *alphabet(dialect).lines)}
    for piece in sorted(found):
        data = piece.encode()
        if 1 < len(data) <= _WORD:
            yield '"' + "".join(f"\\x{byte:02x}" for byte in data) + '"'
