"""The words of a template as variables: which of them hold values that only the template sets, and with what they start (spec/cgt.md §4, §5.1, §11). Reads no line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from deburr.templates.symbols import DECLARED_TYPES, Symbols, Word, is_free, rows_of
from deburr.templates.types import is_number
from deburr.values.domain import NO, YES, Value, any_of, exactly
from deburr.values.graph import Env, Key, Telling

FIXED = {"ON": YES, "OFF": NO}
ENDED, CALL_LEFT, LEFT = 0.0, 1.0, 2.0
"""How a section is over: at its end, by `#EXITC`, by `#EXIT`."""


class _Said(NamedTuple):
    name: str = ""
    of: str = "output"


class Shown(_Said, Telling):
    """Whether what a word would print is what was output of it last: a key beside the words. Without a name it stands for all of them."""

    __slots__ = ()

    def told(self, value: Value) -> str:
        """What became of it, as part of a chain of reasons."""
        return f"`#{self.name}` is output here, or counts as output" if value == YES else f"`#{self.name}` changes here"

    def __str__(self) -> str:
        return self.name


class State(NamedTuple):
    """Keys for what a run is in. ``of``: "end" (how a section ended), "returned" (what it computes), or the number of a loop's node."""

    of: str | int


END, RETURNED = State("end"), State("returned")
ALL = Shown()


@dataclass(frozen=True)
class Vocabulary:
    """What a template's words and sections are.

    ``declared``: names with the commands that declare them; ``tables``: how many rows there are; ``quiet``: sections that
    may be run where no line is output.
    """

    declared: tuple[tuple[str, str], ...]
    machine: tuple[tuple[str, str], ...]
    given: tuple[tuple[str, str], ...]
    tables: tuple[tuple[str, int], ...]
    sections: frozenset[str]
    quiet: frozenset[str]

    @cached_property
    def symbols(self) -> Symbols:
        """The words by their names."""
        known = {name: Word(name, "decimal" if is_number(said) else "string", True) for name, said in self.given}
        mine = {name: Word(name, DECLARED_TYPES[said], not said.startswith("CALC")) for name, said in self.declared}
        return Symbols(known | mine, dict(self.machine))

    def find(self, said: str) -> Word | None:
        """The word that `#said` means."""
        if said not in self._found:
            self._found[said] = self.symbols.find(said.removeprefix("#"))
        return self._found[said]

    def computes(self, word: Word) -> str:
        """The section that computes a word; nothing if none does."""
        return f"${word.name}" if self._commands.get(word.name, "").startswith("CALC") else ""

    def is_mine(self, name: str) -> bool:
        """Whether a word is the template's: neither the generator nor the control gives it a value."""
        return is_free(name) or name in self.symbols.declared

    def holds(self, word: Word) -> bool:
        """Whether a word holds what was set until it is set again: a block number counts on by itself, and others are fixed."""
        return word.type not in ("block", "text") and word.name not in FIXED

    def rows(self, name: str) -> int | None:
        """How many rows a table has; None if there is no such table."""
        return self._tables.get(name)

    def codes(self, word: Word) -> int | None:
        """How many rows a table word can print: a system word has some of its own."""
        rows = self.rows(word.name)
        return rows if rows is not None else len(rows_of(word.name)) or None

    def start(self, name: str) -> Value:
        """What a word of the template holds at first."""
        said = dict(self.given).get(name)
        word = self.symbols.find(name)
        if word is not None and word.is_text:
            return any_of(frozenset((said or "",)))
        return exactly(float(said)) if said is not None and is_number(said) else NO

    @cached_property
    def has_computed(self) -> bool:
        """Whether sections compute any words."""
        return any(command.startswith("CALC") for _, command in self.declared)

    @cached_property
    def _found(self) -> dict[str, Word | None]:
        return {}

    @cached_property
    def _commands(self) -> Mapping[str, str]:
        return dict(self.declared)

    @cached_property
    def _tables(self) -> Mapping[str, int]:
        return dict(self.tables)


def without(env: Env, *keys: Key) -> Env:
    """The values without those of some keys; themselves where they have none of them."""
    if env.keys().isdisjoint(keys):
        return env
    found = env.copy()
    for key in keys:
        found.pop(key, None)
    return found


def unshown(env: Env) -> Env:
    """The values where nothing is known any more of what was output."""
    return {key: value for key, value in env.items() if not isinstance(key, Shown)}
