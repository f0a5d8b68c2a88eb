"""What rules on words share: a line's letters and codes, which motion uses them, and what the table says of a code. By shape alone."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from deburr.arithmetic.rs274 import constant
from deburr.modal import State
from deburr.rule import Line, Report
from deburr_grammar.dialects.rs274.modality import AXES, code_of
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

UNKNOWN = "?"
"""The motion of a line of which only the run knows it."""
TAKES_AXES = frozenset(("G10", "G28", "G30", "G52", "G92"))
"""One-line codes to which the axis words of their line belong (spec/rs274.md §5)."""
CYCLES = frozenset(["G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88", "G89"])
ARCS = frozenset(("G2", "G3"))
PROBES = frozenset(("G38.2", "G38.3", "G38.4", "G38.5"))
DEFAULTS = {
    "plane": "G17",
    "distance": "G90",
    "arc-distance": "G91.1",
    "feed-mode": "G94",
    "cutter-compensation": "G40",
}
"""What is in force at the start (spec/rs274.md §5)."""


@dataclass(frozen=True, slots=True)
class Words:
    """A line's words in order: their letters, the codes of G and M words ("" for one that only the run knows), and both as sets.

    ``groups``: the numbers of the words in each modal group. ``clear``: every code is known, and
    no group has two, so that it is certain what the line asks for.
    """

    letters: tuple[str, ...]
    codes: tuple[str, ...]
    has: frozenset[str]
    groups: Mapping[str, tuple[int, ...]]
    clear: bool

    @property
    def axes(self) -> bool:
        """Whether the line has axis words."""
        return not AXES.isdisjoint(self.has)

    def first(self, *names: str) -> int:
        """The number of the first word of one of these letters or codes."""
        return next(at for at, pair in enumerate(zip(self.letters, self.codes)) if not set(pair).isdisjoint(names))

    def of(self, group: str) -> str:
        """The code of a group on the line; "" where there is none."""
        at = self.groups.get(group)
        return self.codes[at[0]] if at else ""


def words(line: Line) -> Words:
    """The words of a line, kept with its shape."""
    memo = line.node.shape.memo
    key = ("rs274 words", line.node.reading.name, line.settings["remap"])
    found = memo.get(key)
    if not isinstance(found, Words):
        found = memo[key] = _words(line)
    return found


def node(line: Line, at: int) -> Node:
    """A word by its number."""
    return _nodes(line.node)[at]


@lru_cache(8)
def _nodes(node: LineNode) -> tuple[Node, ...]:
    """The words of a line: asked for once for each finding, and absurd lines have thousands."""
    return tuple(node.find("word"))


def said(line: Line, at: int) -> str:
    """How a word is written."""
    return line.said(node(line, at))


def report(line: Line, at: int, message: str) -> Report:
    """A report on a word."""
    word = node(line, at)
    return Report(Span(word.start, word.end), message)


def value(line: Line, word: Node) -> float | None:
    """The value of a word if the line alone decides it."""
    found = constant(line.text, word.children[-1], line.settings)
    return found if isinstance(found, float) else None


def values(line: Line) -> dict[str, float | None]:
    """The values of all words by their letters, as far as the line decides them."""
    return {line.text[word.start].upper(): value(line, word) for word in line.node.find("word")}


def in_force(state: State, group: str) -> str | None:
    """The code of a group that is in force, or the one with which every program starts; None where that is not certain."""
    return DEFAULTS.get(group, "") if state.untouched(group) else state.code(group)


def governs(found: Words, state: State, group: str) -> str | None:
    """The code of a group that is in force when the line's motion is made."""
    return found.of(group) or in_force(state, group)


def motion(found: Words, state: State) -> str:
    """The motion that a line asks for: its own, or the one in force if it has words for it; "" for none."""
    if not found.clear:
        return UNKNOWN
    own = [found.codes[at] for at in found.groups.get("motion", ())]
    if own:
        return next((code for code in own if code != "G80"), "G80")
    if not TAKES_AXES.isdisjoint(found.has) or "G43.1" in found.has:
        return ""
    active = in_force(state, "motion")
    if found.axes:
        return UNKNOWN if active is None else active
    if not found.has.isdisjoint("IJK"):
        return UNKNOWN if active is None else active if active in ARCS else ""
    return ""


def starts(found: Words, state: State, code: str) -> bool:
    """Whether it is certain that the motion of the line was not in force before it."""
    active = in_force(state, "motion")
    return code in found.has and active is not None and active != code


def entry(line: Line, code: str) -> Mapping[str, Any]:
    """What the table says of a code."""
    found = line.node.dialect.codes.entry("code", code)
    return found.more if found is not None else {}


@cache
def remap(names: tuple[str, ...]) -> frozenset[str]:
    """The codes to which the machine gives a meaning of its own: nothing is known of a line with one."""
    return frozenset(map(code_of, names))


@cache
def users(dialect: Any, letter: str) -> frozenset[str]:
    """The codes that take a word of a letter, or let it through."""
    table = dialect.codes.table("code")
    return frozenset(each.name for each in table if letter in (*each.more["words"], *each.more.get("ignores", ())))


def _words(line: Line) -> Words:
    found = list(line.node.find("word"))
    letters = tuple(line.text[word.start].upper() for word in found)
    codes = tuple(_code(line, word) if letter in "GM" else "" for letter, word in zip(letters, found))
    groups: dict[str, tuple[int, ...]] = {}
    foreign = remap(line.settings["remap"])
    for at, code in enumerate(codes):
        if code and code not in foreign and (group := entry(line, code).get("group")):
            groups[group] = (*groups.get(group, ()), at)
    # A faulty line may hold words that were not read.
    own = [code for letter, code in zip(letters, codes) if letter in "GM"]
    known = all(code not in foreign and entry(line, code) for code in own) and not line.node.problems
    clear = known and all(len(_sharing(line, codes, at)) < 2 for at in groups.values())
    return Words(letters, codes, frozenset((*letters, *codes)), groups, clear)


def _sharing(line: Line, codes: tuple[str, ...], group: tuple[int, ...]) -> list[int]:
    """The words of a group that may not stand together."""
    return [at for at in group if not entry(line, codes[at]).get("shares_line")]


def sharing(line: Line, found: Words, letter: str) -> Iterator[list[int]]:
    """The words of each group of G or M codes that may not stand together."""
    for group in found.groups.values():
        if found.letters[group[0]] == letter:
            yield _sharing(line, found.codes, group)


def _code(line: Line, word: Node) -> str:
    """The code of a word as the table names it; as it is spelled if it is in no table, "" if only the run knows it."""
    if not isinstance(word.children[-1], Token):
        return ""
    code = code_of(line.said(word))
    family = line.node.dialect.codes.family("code", int(code[1:])) if re.fullmatch("M[0-9]{1,6}", code) else None
    return family.name if family is not None else code


def clashes(line: Line, letter: str, way_out: str) -> Iterator[Report]:
    """A report on each code of a letter behind the first of its modal group."""
    found = words(line)
    for first, *others in filter(None, sharing(line, found, letter)):
        group = line.node.dialect.codes.entry("group", entry(line, found.codes[first])["group"])
        title = group.title if group is not None else ""
        for at in others:
            both = f"`{said(line, at)}` and `{said(line, first)}`"
            yield report(line, at, f"{both} are of one group ({title}); {way_out}")
