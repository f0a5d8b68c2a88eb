"""What lines of a CGT template name: words, sections, functions, commands (spec/cgt.md §3, §4, §11)."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from deburr.symbols import Act, Mention, Offer, Sort, Symbol, Takes
from deburr.templates.symbols import DECLARED_TYPES, Symbols, Word
from deburr_grammar.dialect import Role
from deburr_grammar.text import Span, with_newlines
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.codes import Entry
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_DECLARATION = re.compile(
    r"(?i)#(dec|int|str|tbl|calcdec|calcint|calcstr)[ \t]*((?:#[A-Za-z][A-Za-z0-9_]*[ \t]*,?[ \t]*)+)"
)
_NAME = re.compile(r"#([A-Za-z][A-Za-z0-9_]*)")
_PARTIAL = re.compile(r"^@\$?[A-Za-z0-9_]*$|#[A-Za-z0-9_]*$|\$?[A-Za-z][A-Za-z0-9_]*$")
SHARED = "shared by all sections"
SET = "only a run tells"
UNSET = "set nowhere here"
NAMING = frozenset(("WORD", "HEADER", "SECTION"))
_FORMATTED = re.compile(r"(?i)#fmt\($")
_ROWS = 30
_SYSTEM_WORD = "word"


def names(document: Document) -> tuple[tuple[str, str], ...]:
    """The words that the template declares, with their types."""
    found: dict[str, str] = {}
    for chunk in document.chunks():
        kept: dict[str, str] | None = chunk.memo.get("declared words")
        if kept is None:
            kept = chunk.memo["declared words"] = dict(_declared(with_newlines(chunk.text)))
        found |= kept
    return tuple(sorted(found.items()))


def mentions(line: LineNode, names: Hashable) -> Iterator[Mention]:
    """Words, sections, functions and commands."""
    known = _symbols(names)
    looked_up = {part.children[2].start for part in walk(line.tree) if isinstance(part, Node) and part.kind == "lookup"}
    for part in walk(line.tree):
        if isinstance(part, Token):
            yield from _token(line.text, part, Act.READ if part.start in looked_up else Act.CALL)
            continue
        target = next((each for each in part.children if each.kind == "WORD"), None)
        for each in part.children:
            if each.kind == "WORD":
                sets = part.kind in ("eval", "macro") and each is target
                act = Act.DEFINE if part.kind == "declaration" else Act.SET if sets else Act.READ
                yield from _word(line.text, each, act, known, part.kind in ("template", "row"))
        if part.kind == "function" and isinstance(part.children[0], Token):
            name = part.children[0]
            span = Span(name.start, name.end)
            said = line.text[name.start : name.end].upper()
            yield Mention(Symbol(Sort.FUNCTION, said, table="function"), Act.SAY, span, span)


def file(symbol: Symbol, file: str, ruleset: RuleSet, host: Host) -> str | None:
    """No name leads out of a template."""
    return None


def partial(before: str) -> int:
    """A word with its `#`, or letters."""
    match = _PARTIAL.search(before)
    return match.start() if match else len(before)


def offers(expected: frozenset[str], before: str, partial: str) -> Iterator[Offer | str]:
    """By the terminals that can stand there."""
    if partial.startswith("@"):
        yield "section"
    if "SECTION" in expected:
        yield Offer.SECTIONS
        return
    if "FORMAT" in expected:
        yield "format"
    if "LOGIC" in expected:
        yield "command/AND"
        yield "command/OR"
    if "WORD" in expected and _FORMATTED.search(before):
        yield "format_class"
    if "WORD" in expected:
        yield Offer.VARIABLES
        yield "word"
    if "EVAL" in expected:
        yield "command"
    if "NAME" in expected and "PI" in expected:
        yield "function"


def called(before: str) -> None:
    """No call has arguments."""


def takes(document: Document, symbol: Symbol) -> Takes:
    """Nothing is handed over."""
    return Takes(written(symbol), (), "")


def resumed(before: str) -> str:
    """The start of a line says how it is read."""
    return before


def end(opener: Bracket) -> str:
    """Brackets close within lines."""
    return ""


def files(file: str, ruleset: RuleSet, host: Host, before: str) -> Iterator[str]:
    """No name leads out of a template."""
    yield from ()


def spelled(entry: Entry) -> str:
    """Sections with their `@`, words and commands with their `#`, functions with their parenthesis, formats bare."""
    if entry.first is not None or entry.table == "format":
        return "" if entry.first is not None else entry.name
    if entry.table == "section":
        return f"@{entry.name}"
    return f"{entry.name}(" if entry.table == "function" else f"#{entry.name}"


def valid(symbol: Symbol, name: str) -> str:
    """Letters, digits and underscores, a letter first; a user section keeps its `$`."""
    if symbol.sort is Sort.SECTION and symbol.name.startswith("$") != name.startswith("$"):
        return "sections with `$` compute a word; others do not"
    if re.fullmatch(r"\$?[A-Za-z][A-Za-z0-9_]*", name) is None:
        return f"`{name}` is no name"
    return "" if symbol.sort is not Sort.VARIABLE or _symbols(()).system(name) is None else f"`{name}` is a system word"


def notes(document: Document, line: int, mention: Mention) -> Iterator[str]:
    """Of a declared word its type; of a word with a section of its name, the rows of that table."""
    kind = dict(names(document)).get(mention.symbol.name)
    if kind is not None:
        yield f"declared here, type: {kind}"
    rows = list(table_rows(document, mention.symbol.name)) if mention.symbol.sort is not Sort.SECTION else []
    if rows:
        lines = [f"| {label} | `{prints}` |" for label, prints in rows]
        yield "\n".join(["| row of the section | prints |", "|---|---|", *lines])


def table_rows(document: Document, section: str) -> Iterator[tuple[str, str]]:
    """The rows of a table section: the label and what is printed."""
    first = next(
        (line for line, bracket in document.brackets() if bracket.role is Role.REGION and bracket.label == section),
        None,
    )
    for at in range(first + 1, min(document.line_count, first + 1 + _ROWS)) if first is not None else ():
        row = document.node(at)
        if row.reading.name != "table" or row.text.startswith("@"):
            return
        label, comma, prints = row.text.partition("//")[0].partition(",")
        if comma:
            yield label.strip(), prints.strip()


def meant(document: Document, line: int, mention: Mention) -> None:
    """Nothing stands for anything else."""


def written(symbol: Symbol) -> str:
    """`#WORD`, `@SECTION`, or the name."""
    if symbol.sort is Sort.SECTION:
        return f"@{symbol.name}"
    return symbol.name if symbol.sort is Sort.FUNCTION else f"#{symbol.name}"


def _declared(text: str) -> Iterator[tuple[str, str]]:
    for match in _DECLARATION.finditer(text):
        for name in _NAME.finditer(match[2]):
            yield name[1], DECLARED_TYPES[match[1].upper()]


@lru_cache(maxsize=64)
def _symbols(names: Hashable) -> Symbols:
    declared = names if isinstance(names, tuple) else ()
    return Symbols({name: Word(name, kind, True) for name, kind in declared}, {})


def _word(text: str, token: Node | Token, act: Act, known: Symbols, output: bool) -> Iterator[Mention]:
    said = text[token.start + 1 : token.end]
    spelled = known.spell(said, output and act is Act.READ)
    name = spelled.name
    span = Span(token.start, token.end - len(spelled.rest))
    inner = Span(span.start + 1, span.end)
    if spelled.kind == "command":
        yield Mention(Symbol(Sort.KEYWORD, name, table="command"), Act.SAY, span, span)
    elif known.declared.get(name) is None and known.system(name) is not None and not _is_users(name):
        yield Mention(Symbol(Sort.WORD, name, table=_SYSTEM_WORD), act, span, inner)
    else:
        yield Mention(Symbol(Sort.VARIABLE, name, table="variable"), act, span, inner)


def _is_users(name: str) -> bool:
    return re.fullmatch("[SUV][0-9]{1,2}", name) is not None


def _token(text: str, token: Token, act: Act) -> Iterator[Mention]:
    span = Span(token.start, token.end)
    said = text[token.start : token.end]
    if token.kind == "HEADER":
        inner = Span(token.start + 1, token.end)
        yield Mention(Symbol(Sort.SECTION, said[1:], table="section"), Act.DEFINE, span, inner)
    elif token.kind == "SECTION":
        yield Mention(Symbol(Sort.SECTION, said, table="section"), act, span, span)
    elif said.startswith("#") and token.kind not in ("WORD", "TEXT", "ROW_TEXT", "COMMENT", "CHARS", "STRING"):
        yield Mention(Symbol(Sort.KEYWORD, said[1:].upper(), table="command"), Act.SAY, span, span)
