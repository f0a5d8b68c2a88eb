"""Comments that allow a rule: `deburr: allow RULE[, RULE] [-- reason]`. Never decides whether a rule is right.

Such a comment speaks for its own line, and alone on its line for the next one as well;
several alone on lines that follow each other speak for the line behind them.
"""

import re
from collections.abc import Generator, Iterable, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from itertools import islice
from typing import NamedTuple

from deburr.finding import Finding
from deburr.rule import Notice, covers
from deburr.ruleset import RuleSet
from deburr.steps import done, paced
from deburr_grammar.chunk import Chunk
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES
from deburr_grammar.document import Document
from deburr_grammar.text import Span

UNUSED = "allow-unused"
UNKNOWN = "allow-unknown"
MISSPELT = "allow-misspelt"
_SIGN = "deburr:"
_HINTS = ("eburr", "EBURR")
"""One of them stands in every chunk that holds such a comment, however it is spelled."""
_OTHERS = frozenset(("ignore", "disable", "noqa", "suppress", "silence", "skip", "off", "allow", "allows", "allowed"))
"""What other tools call it."""


_ANY, _NONE = frozenset((True,)), frozenset[bool]()
_MOST = 100
"""Names in one comment; what follows them is not looked at, so the findings that it means are shown."""


class Allow(NamedTuple):
    """A name in such a comment: the rule or the prefix, where it stands, and whether the comment is alone on its line."""

    name: str
    span: Span
    alone: bool


class Allowed(NamedTuple):
    """What is left of findings, and what is to be said of the comments themselves."""

    findings: Sequence[Finding]
    notices: list[Notice]


def allows(document: Document) -> dict[int, tuple[Allow, ...]]:
    """All such comments of a program by line."""
    return done(_allows(document))


def _allows(document: Document) -> Generator[None, None, dict[int, tuple[Allow, ...]]]:
    found: dict[int, tuple[Allow, ...]] = {}
    first = 0
    for chunk in document.chunks():
        found.update((first + index, names) for index, names in _in_chunk(chunk, document.dialect))
        first += chunk.eols
        yield
    return found


def allowing(document: Document, findings: Sequence[Finding], ruleset: RuleSet) -> Generator[None, None, Allowed]:
    """The findings that no comment allows, and the comments that allowed none, found in steps."""
    table = yield from _allows(document)
    misspelt: list[Notice] = []
    for notice in _misspelt(document):
        if notice is None:
            yield
        else:
            misspelt.append(notice)
    if not table:
        return Allowed(findings, misspelt)
    kept: list[Finding] = []
    used: set[tuple[int, Allow]] = set()
    for finding in paced(findings):
        if finding is None:
            yield
            continue
        speaking = [each for each in _speaking(table, finding.place.line) if covers(each[1].name, finding.rule)]
        used.update(speaking)
        kept += [] if speaking else [finding]
    unused = [(line, allow) for line, names in table.items() for allow in names if (line, allow) not in used]
    return Allowed(kept, [*_notices(document, unused, ruleset), *misspelt])


def mentions(text: str) -> bool:
    """Whether a text may hold such a comment."""
    return _SIGN in text


def allows_anything(document: Document) -> bool:
    """Whether a program may hold such a comment: it costs what an edit touched."""
    return bool(document.gathered("allowing", lambda piece: _ANY if mentions(piece.chunk.text) else _NONE))


def is_allowed(document: Document, finding: Finding) -> bool:
    """Whether a comment allows a finding: looks only at its line and the lines of comments right above."""
    near: dict[int, tuple[Allow, ...]] = {}
    line = finding.place.line
    while line >= 0:
        near[line] = in_line(document.line(line), document.dialect)
        if line != finding.place.line and not (near[line] and near[line][0].alone):
            break
        line -= 1
    return any(covers(allow.name, finding.rule) for _, allow in _speaking(near, finding.place.line))


@lru_cache(16)
def in_line(text: str, dialect: Dialect) -> tuple[Allow, ...]:
    """The names that a line's comments allow."""
    if _SIGN not in text:
        return ()
    pattern = _pattern(dialect)
    alone = not pattern.sub("", text).strip()
    return tuple(allow for match in pattern.finditer(text) for allow in _names(match, alone))


def comment_pattern(comments: Sequence[tuple[str, str]], inner: str) -> str:
    """A pattern for a comment that holds something: ``{}`` in ``inner`` is what may not be left behind in it, `{number}` numbers the pair of signs."""
    found = []
    for number, (opens, ends) in enumerate(comments):
        rest = rf"(?:(?!{re.escape(ends)}).)" if ends else "."
        held = inner.replace("{}", rest).replace("{number}", str(number))
        found.append(rf"{re.escape(opens)}{rest}*?{held}{re.escape(ends) if ends else '$'}")
    return "|".join(found) or "(?!)"


@cache
def _pattern(dialect: Dialect) -> re.Pattern[str]:
    return re.compile(comment_pattern(dialect.comments, rf"{_SIGN}[ \t]*allow(?![\w-])(?P<names{{number}}>{{}}*)"))


@cache
def _meant(dialect: Dialect) -> re.Pattern[str]:
    """A comment that names a rule behind `deburr` and a word, however these are spelled."""
    name = r"(?P<name{number}>[A-Za-z0-9]+(?:\.[A-Za-z0-9-]+)?)"
    inner = rf"(?P<said{{number}}>\bdeburr[ \t]*:?[ \t]*(?P<word{{number}}>[a-z-]+)[ \t:=]+{name})(?![\w.]){{}}*"
    return re.compile(comment_pattern(dialect.comments, inner), re.I)


def _misspelt(document: Document) -> Iterator[Notice | None]:
    """Comments that are certainly meant to allow a rule and do not, with a None behind each chunk."""
    first = 0
    for chunk in document.chunks():
        for index, span, name in _misspelt_in_chunk(chunk, document.dialect):
            if document.node(first + index).reading.start is not None:
                yield Notice(MISSPELT, first + index, span, name)
        first += chunk.eols
        yield None


def _misspelt_in_chunk(chunk: Chunk, dialect: Dialect) -> tuple[tuple[int, Span, str], ...]:
    """Kept with the chunk: it depends on its text alone."""
    found: tuple[tuple[int, Span, str], ...] | None = chunk.memo.get("misspelt")
    if found is None:
        lines = range(len(chunk.starts)) if any(hint in chunk.text for hint in _HINTS) else range(0)
        found = tuple((index, *each) for index in lines for each in _misspelt_in_line(chunk.line(index), dialect))
        chunk.memo["misspelt"] = found
    return found


def _misspelt_in_line(text: str, dialect: Dialect) -> Iterator[tuple[Span, str]]:
    for match in _meant(dialect).finditer(text):
        parts = match.groupdict()
        number = next(name.removeprefix("said") for name, said in parts.items() if name.startswith("said") and said)
        word, name = (parts[f"{part}{number}"].lower() for part in ("word", "name"))
        rule = name.partition(".")[0] in NAMES and ("." in name or word in _OTHERS)
        if rule and word != "dialect" and not _pattern(dialect).fullmatch(match[0]):
            yield Span(*match.span(f"said{number}")), name


def _names(match: re.Match[str], alone: bool) -> Iterator[Allow]:
    """The names of one comment; one without any is an empty name, which no rule has."""
    group = next(name for name, said in match.groupdict().items() if said is not None)
    without_reason = re.split(r"(?:^|\s)--(?:\s|$)", match[group], maxsplit=1)[0]
    at = match.start(group)
    names = list(islice(re.finditer(r"[^,\s](?:[^,]*[^,\s])?", without_reason), _MOST))
    for name in names:
        yield Allow(name[0], Span(at + name.start(), at + name.end()), alone)
    if not names:
        yield Allow("", Span(match.string.rindex(_SIGN, 0, at), at), alone)


def _in_chunk(chunk: Chunk, dialect: Dialect) -> tuple[tuple[int, tuple[Allow, ...]], ...]:
    """Kept with the chunk: it depends on its text alone."""
    found: tuple[tuple[int, tuple[Allow, ...]], ...] | None = chunk.memo.get("allows")
    if found is None:
        lines = range(len(chunk.starts)) if _SIGN in chunk.text else range(0)
        found = tuple((index, names) for index in lines if (names := in_line(chunk.line(index), dialect)))
        chunk.memo["allows"] = found
    return found


def _speaking(table: Mapping[int, tuple[Allow, ...]], line: int) -> Iterator[tuple[int, Allow]]:
    """The names that speak for a line, with the lines that they stand on."""
    yield from ((line, allow) for allow in table.get(line, ()))
    above = line - 1
    while above in table and table[above] and table[above][0].alone:
        yield from ((above, allow) for allow in table[above])
        above -= 1


def _notices(document: Document, unused: Iterable[tuple[int, Allow]], ruleset: RuleSet) -> Iterator[Notice]:
    """What is said of names that allowed nothing; text that is not read is nobody's comment."""
    for line, allow in unused:
        if document.node(line).reading.start is None:
            continue
        if not ruleset.knows(allow.name):
            yield Notice(UNKNOWN, line, allow.span, allow.name)
        elif ruleset.speaks(allow.name):
            yield Notice(UNUSED, line, allow.span, allow.name)
