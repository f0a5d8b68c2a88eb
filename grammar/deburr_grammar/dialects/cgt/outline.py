"""What the sections of a CGT template are, and how its brackets hang together (spec/cgt.md §2, §3, §11)."""

import re
from collections.abc import Callable, Hashable, Iterator
from functools import lru_cache
from typing import NamedTuple

from deburr_grammar.codes import CodeTable
from deburr_grammar.dialect import Bracket, Reading, Role, Step
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Token, tokens

PREAMBLE = Reading("preamble", None)
HEADER = Reading("header", "header")
TEMPLATE = Reading("template", "template")
DECLARE = Reading("declare", "template")
TABLE = Reading("table", "table")
OUTSIDE = Reading("outside", None)
READINGS = (PREAMBLE, HEADER, TEMPLATE, DECLARE, TABLE, OUTSIDE)

TABLE_WORDS = frozenset({"ABSI", "ADIR", "BDIR", "COOLNT", "CYCLE", "DCOMP", "MOV", "SPNDL"})
"""System words that print a row of the section of their own name (spec/cgt.md §11, *Words*)."""

SECTIONS = frozenset(
    [
        "DECLARE",
        "START",
        "END",
        "CYCLCHG",
        "TOOLCHG",
        "RAP",
        "LINE",
        "ARC",
        "XZARC",
        "YZARC",
        "HELIX",
        "DWELL",
        "STPROF",
        "ENDPROF",
        "FXD1",
        "FXD2",
        "FXD3",
        "FXD4",
        "FXD5",
    ]
)
"""Sections that the generator runs by itself. None of them is ever a table."""

_COMMENT = re.compile(r"//[^\n]*")
_LOOKUP = re.compile(r"#table\([ \t]*(\$?[A-Za-z][A-Za-z0-9_]*)[ \t]*,", re.I)
_DECLARED = re.compile(r"#tbl[ \t]*(#[A-Za-z][A-Za-z0-9_]*(?:[ \t]*,[ \t]*#[A-Za-z][A-Za-z0-9_]*)*)", re.I)
_NAME = re.compile(r"#([A-Za-z0-9_]+)")
_TESTED = re.compile(r"#([A-Za-z][A-Za-z0-9_]*)\(([^()\n]*)\)(?=<)")
_COMPARES = re.compile("[<>]")
_COMMAND_OR_BRACKET = re.compile(r"#[A-Za-z][A-Za-z0-9_]*\((?:[^()]|\([^()]*\))*\)|[<>]")


class State(NamedTuple):
    """How lines are read, and the name of the section they stand in (None: in none)."""

    reading: Reading = PREAMBLE
    section: str | None = None


class CGTOutline:
    """The fold over section headers and brackets."""

    marks = r"^@|[<>]"
    needs_depth = ""

    def facts(self, text: str) -> frozenset[str]:
        """The names of sections that are tables, because a lookup or a table word names them."""
        text = _COMMENT.sub("", text)
        named = {match[1] for match in _LOOKUP.finditer(text)}
        for match in _DECLARED.finditer(text):
            named.update(_NAME.findall(match[1]))
        return frozenset(named - SECTIONS)

    def start(self, facts: frozenset[str]) -> Hashable:
        """Before the first header."""
        return State()

    def reading(self, state: Hashable) -> Reading:
        """As the last header says."""
        assert isinstance(state, State)
        return state.reading

    def step(self, state: State, depth: int, facts: frozenset[str], read: Callable[[Reading], LineNode]) -> Step:
        """What a header, a closing `@` or a line with brackets does."""
        line = read(state.reading)
        if not line.text.startswith("@"):
            live = state.reading in (TEMPLATE, DECLARE)
            return Step(state.reading, tuple(brackets(line)) if live else (), state)
        line = read(HEADER)
        ended = _ended(state)
        if "END" in line.kinds and not line.problems:
            return Step(HEADER, ended, State(OUTSIDE)) if ended else Step(state.reading, (), state)
        name, span = section_name(line)
        return Step(
            HEADER, (*ended, Bracket(Role.REGION, "section", "@", name, span)), State(_read_as(name, facts), name)
        )


def section_name(line: LineNode) -> tuple[str, Span]:
    """The name on a header line, as far as it is one, and the columns of the header with its `@`."""
    token = next((part for part in tokens(line.tree) if part.kind == "HEADER"), None)
    end = token.end if token else max(1, len(line.text.split(maxsplit=1)[0]))
    return line.text[1:end], Span(0, end)


def brackets(line: LineNode) -> Iterator[Bracket]:
    """The brackets of a template line: those that were read, and on a faulty line those that stand behind the fault."""
    reached = 0
    tests = misspelt_tests(line.text)
    for token in tokens(line.tree):
        reached = token.end
        if any(test.start < token.start < test.end for test in tests):
            continue
        if token.kind in ("LT", "BODY"):
            yield _bracket(Role.OPEN, token.start)
        elif token.kind == "GT":
            yield _bracket(Role.CLOSE, token.start)
    if line.problems:
        yield from _behind(line, reached)


def _behind(line: LineNode, reached: int) -> Iterator[Bracket]:
    """A fault costs one finding: what stands behind the broken command still pairs with the lines around it."""
    text = line.text.partition("//")[0]
    deep = 0
    for token in tokens(line.tree):
        deep = 0 if token.kind == "OPEN" else deep + (token.kind == "LPAR") - (token.kind == "RPAR")
    unfinished = [part for part in line.tree.children if isinstance(part, Token)]
    lost = False
    if any(part.kind == "OPEN" for part in unfinished):
        lost = deep < 0
        reached = reached if lost else _closed(text, reached, deep)
    elif apart := re.compile(r"[ \t]*\(?").match(text, reached):
        # The parenthesis of a command, with a blank before it or itself left out.
        reached = max(reached, _closed(text, apart.end(), 0))
    for match in _COMMAND_OR_BRACKET.finditer(text, reached):
        if len(match[0]) > 1:
            continue
        if match[0] == ">" and lost:
            lost = False  # It closes the body whose `<` is what the line lacks.
            continue
        lost = lost and match[0] == ">"
        yield _bracket(Role.OPEN if match[0] == "<" else Role.CLOSE, match.start())


def misspelt_tests(text: str) -> list[Span]:
    """What stands in parentheses behind a word that nobody knows, compares, and has a body: an `#IF` that is misspelt, so its `<` and `>` are no brackets."""
    found = _TESTED.finditer(text) if "(" in text else ()
    return [
        Span(match.end(1), match.end())
        for match in found
        if _COMPARES.search(match[2]) and not _known(match[1].upper())
    ]


def _known(name: str) -> bool:
    return name in _names() or re.fullmatch("[SUV][0-9]{1,2}", name) is not None


@lru_cache(maxsize=1)
def _names() -> frozenset[str]:
    codes = CodeTable("deburr_grammar.dialects.cgt")
    return frozenset(entry.name for table in ("word", "command") for entry in codes.table(table))


def _closed(text: str, at: int, deep: int) -> int:
    """Behind the parenthesis that closes a command; where none does, the same place."""
    for match in re.compile(r"[()]").finditer(text, at):
        deep += 1 if match[0] == "(" else -1
        if deep < 0:
            return match.end()
    return at


def _bracket(role: Role, at: int) -> Bracket:
    return Bracket(role, "bracket", "<" if role is Role.OPEN else ">", None, Span(at, at + 1))


def _ended(state: State) -> tuple[Bracket, ...]:
    if state.section is None:
        return ()
    return (Bracket(Role.END_REGION, "section", "@", state.section, Span(0, 1)),)


def _read_as(name: str, facts: frozenset[str]) -> Reading:
    if name == "DECLARE":
        return DECLARE
    return TABLE if name in TABLE_WORDS or name in facts else TEMPLATE
