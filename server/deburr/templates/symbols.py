"""The words of a template: known, declared, or neither, and where a word ends in abutting text (spec/cgt.md §4, §11)."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.dialects.cgt import DIALECT

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from deburr_grammar.codes import CodeTable

CONTROLS = frozenset({"AND", "OR", "EXC", "ELSE", "EXIT", "EXITC", "ONBLK"})
"""Commands without parentheses: text may abut them as it may abut words."""
POSITIONS = ("XPOS", "YPOS", "ZPOS")
DECLARED_TYPES = {
    "DEC": "decimal",
    "INT": "integer",
    "STR": "string",
    "TBL": "table",
    "CALCDEC": "decimal",
    "CALCINT": "integer",
    "CALCSTR": "string",
}
_TEXTS = ("text", "string")
_FAMILY = re.compile(r"([SUV])(0|[1-9][0-9]?)")


class Word(NamedTuple):
    """A word that has a value: its name without `#`, its type (decimal, integer, offset, block, table, text, string), whether `#EVAL` may set it."""

    name: str
    type: str
    settable: bool

    @property
    def is_text(self) -> bool:
        """Whether its value is a text."""
        return self.type in _TEXTS


class Spelled(NamedTuple):
    """What `#name` stands for. ``kind``: "word", "command", "class" (of formats), "job", "unknown" or "undeclared"; ``rest`` abuts as text."""

    kind: str
    name: str
    rest: str = ""
    word: Word | None = None


class Symbols:
    """All words that a template can use: the system's, the machine file's, those usable undeclared, and its own."""

    def __init__(self, declared: Mapping[str, Word], machine: Mapping[str, str]) -> None:
        self._known = {name: Word(name, kind, True) for name, kind in machine.items()} | _system()
        self.declared = {name: word for name, word in declared.items() if not self.reserved(name)}
        self._memo: dict[tuple[str, bool], Spelled] = {}

    def system(self, name: str) -> Word | None:
        """A word that exists without declaration, in any case."""
        return self._known.get(name.upper()) or _numbered(name.upper())

    def reserved(self, name: str) -> bool:
        """Whether a template may not declare that name."""
        return self.system(name) is not None or name.upper() in commands() or name in format_classes()

    def find(self, name: str) -> Word | None:
        """The word of that name, declared ones first; those are case-sensitive."""
        return self.declared.get(name) or self.system(name)

    def spell(self, name: str, output: bool) -> Spelled:
        """What `#name` is; only where it is output may text abut it."""
        key = (name, output)
        if key not in self._memo:
            self._memo[key] = self._spell(name, output)
        return self._memo[key]

    def similar(self, name: str, words: Iterable[str] = ()) -> str:
        """The end of a message: `; did you mean `#XPOS`?`, or nothing."""
        found = self.nearest(name, words)
        return f"; did you mean `#{found}`?" if found else ""

    def nearest(self, name: str, words: Iterable[str] = ()) -> str:
        """The known word that is spelled most like a name; nothing if none is."""
        known = {*self.declared, *self._known, *words}
        # `#INTEGER` is far from `#INT` by its letters.
        longer = [each for each in known if len(each) > 2 and name.upper().startswith(each.upper())]
        return nearest(name, known) or max(longer, key=len, default="")

    def _spell(self, name: str, output: bool) -> Spelled:
        whole = self._whole(name)
        if whole is not None:
            return whole
        for end in range(len(name) - 1, 0, -1) if output else ():
            start = name[:end]
            word = self.declared.get(start) or self._known.get(start) or _numbered(start)
            if word is not None:
                return Spelled("word", word.name, name[end:], word)
            if start in CONTROLS:
                return Spelled("command", start, name[end:])
        return Spelled("undeclared" if re.search("[a-z]", name) else "unknown", name)

    def _whole(self, name: str) -> Spelled | None:
        word = self.find(name)
        if word is not None:
            return Spelled("word", word.name, "", word)
        if name.upper() in commands():
            return Spelled("command", name.upper())
        if name.upper() in ("JOS", "JOS_STR"):
            return Spelled("job", name.upper())
        return Spelled("class", name) if name in format_classes() else None


def nearest(name: str, names: Iterable[str]) -> str:
    """The name that is spelled most like another one in any case; nothing if none is."""
    from difflib import get_close_matches

    by_upper = {each.upper(): each for each in sorted(names)}
    found = get_close_matches(name.upper(), by_upper, 1, 0.7)
    return by_upper[found[0]] if found else ""


@lru_cache(maxsize=1)
def commands() -> frozenset[str]:
    """The names of all commands and operators."""
    return frozenset(entry.name for entry in _codes().table("command"))


@lru_cache(maxsize=1)
def format_classes() -> frozenset[str]:
    """The classes of words that `#FMT` takes."""
    return frozenset(entry.name for entry in _codes().table("format_class"))


@lru_cache(maxsize=1)
def functions() -> Mapping[str, tuple[int, int]]:
    """How few and how many arguments each function takes."""
    return {entry.name: (entry.more["min_args"], entry.more["max_args"]) for entry in _codes().table("function")}


def built_in(name: str) -> str | None:
    """What sort of word or command a name is without a machine file; None where it is free."""
    word = _system().get(name) or _numbered(name)
    return word.type if word else "command" if name in commands() else None


def is_free(name: str) -> bool:
    """Whether a word is a user's though nothing declares it."""
    return _FAMILY.fullmatch(name) is not None


def missing_sign(said: str) -> str:
    """The end of a message about a name that is a word but for its `#`: `; did you mean `#V1`?`, or nothing."""
    name = said.upper()
    return f"; did you mean `#{name}`?" if _system().get(name) or _numbered(name) else ""


def rows_of(name: str) -> list[str]:
    """The codes that a system word prints where neither a machine file nor a section says otherwise."""
    entry = _codes().entry("word", name)
    return list(entry.more.get("codes", ())) if entry else []


@lru_cache(maxsize=1)
def table_words() -> frozenset[str]:
    """The system words that print a row of a table."""
    return frozenset(name for name, word in _system().items() if word.type == "table")


@lru_cache(maxsize=1)
def _system() -> dict[str, Word]:
    plain = (entry for entry in _codes().table("word") if "prefix" not in entry.more)
    return {entry.name: Word(entry.name, entry.more["type"], entry.more["settable"]) for entry in plain}


def _numbered(name: str) -> Word | None:
    match = _FAMILY.fullmatch(name)
    return Word(name, "string" if match[1] == "S" else "decimal", True) if match else None


def _codes() -> CodeTable:
    return DIALECT.codes
