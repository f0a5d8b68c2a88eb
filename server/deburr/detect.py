"""Which dialect a file is written in, and why. Never guesses: no answer is an answer, never a silent default."""

import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import NamedTuple

from deburr.paths import extension
from deburr.suggest import suggestion
from deburr.suppress import comment_pattern
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import split_lines, with_newlines

SHARED = (".nc", ".tap", ".cnc", ".gcode", ".txt", ".tmp")
"""Extensions that programs of many controls have: what stands in the file decides."""
_LINES = 5
_NEAR = 10_000
_FAR = 1_000_000
_SIGN = "deburr:"


class Answer(NamedTuple):
    """The dialect's name, or None, and the reason in words."""

    dialect: str | None
    reason: str


class Hints(NamedTuple):
    """What others said of the file: the command line, the editor, the configuration's `[files]` (dialect and reason)."""

    asked: str | None = None
    language: str | None = None
    configured: Answer | None = None


NO_HINTS = Hints()


def detect(file: str, text: str, hints: Hints = NO_HINTS) -> Answer:
    """The first that answers. ``file`` is "" for text without a name."""
    if hints.asked:
        return Answer(hints.asked, "asked for with --dialect")
    if hints.language in NAMES:
        return Answer(hints.language, "the editor's language")
    return hints.configured or modeline(text) or _by_extension(file) or _by_content(file, text)


def modeline(text: str) -> Answer | None:
    """What a comment `deburr: dialect=NAME` in the first or last lines says; of a name that there is not, that it answers nothing."""
    if _SIGN not in text[:_NEAR] and _SIGN not in text[-_NEAR:]:
        return None
    for line, where in _edges(text):
        match = _modeline().search(line) if _SIGN in line else None
        if match is not None:
            name = next(said for said in match.groups() if said is not None)
            if name in NAMES:
                return Answer(name, f"the modeline in {where}")
            return Answer(None, f"the modeline in {where} names `{name}`, which is no dialect{suggestion(name, NAMES)}")
    return None


@cache
def known_extensions() -> frozenset[str]:
    """The extensions by which folders are searched."""
    return frozenset((*SHARED, *(each for name in NAMES for each in by_name(name).extensions)))


def _edges(text: str) -> Iterator[tuple[str, str]]:
    """The first and last lines with what to call them."""
    first = split_lines(text[:_NEAR])[:_LINES]
    yield from ((line, f"line {number}") for number, line in enumerate(first, 1))
    last = split_lines(text[-_NEAR:].rstrip("\r\n"))[-_LINES:]
    yield from ((line, "the last lines") for line in last)


@cache
def _modeline() -> re.Pattern[str]:
    pairs = tuple(dict.fromkeys(pair for name in NAMES for pair in by_name(name).comments))
    return re.compile(comment_pattern(pairs, rf"{_SIGN}[ \t]*dialect[ \t]*=[ \t]*([\w-]+){{}}*"))


def _by_extension(file: str) -> Answer | None:
    found = extension(file)
    name = next((name for name in NAMES if found and found in by_name(name).extensions), None)
    return Answer(name, f"the extension {found}") if name else None


def _by_content(file: str, text: str) -> Answer:
    found = extension(file)
    if file and found not in SHARED:
        return Answer(None, f"no dialect has the extension {found}" if found else "the file has no extension")
    shown = list(_shown(map(by_name, NAMES), with_newlines(text[:_FAR])))
    if len(shown) == 1:
        dialect, what = shown[0]
        return Answer(dialect.name, what)
    if shown:
        said = " and ".join(f"{what} ({dialect.name})" for dialect, what in shown)
        return Answer(None, f"the text shows {said}, which no one dialect has both")
    why = f"the extension {found} is shared by many controls" if file else "the text has no name"
    return Answer(None, f"{why}, and nothing in it is proper to one of {', '.join(NAMES)}")


def _shown(dialects: Iterable[Dialect], text: str) -> Iterator[tuple[Dialect, str]]:
    """The dialects of whose own signs the text shows one, with the sign; comments are no evidence."""
    for dialect in dialects:
        code = _comments(dialect).sub("", text) if dialect.comments else text
        for evidence in dialect.evidence:
            if match := re.search(evidence.pattern, code):
                line = len(split_lines(code[: match.start() + len(match[0]) - len(match[0].lstrip())]))
                yield dialect, f"{evidence.text} in line {line}"
                break


@cache
def _comments(dialect: Dialect) -> re.Pattern[str]:
    pairs = (
        rf"{re.escape(a)}[^\r\n]*?{re.escape(b)}" if b else rf"{re.escape(a)}[^\r\n]*" for a, b in dialect.comments
    )
    return re.compile("|".join(pairs))
