"""What lines of MetaGCODE name: variables, snippets, directives and their words (spec/metagcode.md §2, §3)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.includes import Folder
from deburr.symbols import Act, Mention, Offer, Sort, Symbol, Takes
from deburr_grammar.dialects.metagcode.forms import Group, groups
from deburr_grammar.dialects.metagcode.forms import name as name_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.codes import Entry
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_PARTIAL = re.compile(r"#[A-Za-z]*$|[A-Za-z][^ \t|]*$")
_SNIPPET = re.compile(r"(?i)[ \t]*#file[ \t]+")
_MOST = 500
SHARED = "shared with all snippets"
SET = UNSET = "it comes from outside"
NAMING = frozenset(("VARIABLE", "file"))
_DEEPEST = 40
"""So many blocks around a line are looked at."""
_KEYWORDS = {"IF", "ENDIF", "LOOP", "ENDLOOP", "FILE"}
_TABLES = {"OPERATOR": "operator", "TYPE": "type", "MODE": "steptype"}


def names(document: Document) -> None:
    """A line says it all."""


def mentions(line: LineNode, names: object) -> Iterator[Mention]:
    """Variables, the snippet of `#FILE`, directives, operators and types."""
    for part in walk(line.tree):
        if isinstance(part, Node):
            if part.kind == "counter":
                yield from (_variable(line.text, each, Act.SET) for each in part.children if each.kind == "VARIABLE")
            elif part.kind == "file":
                yield from _snippet(line.text, part)
            elif part.kind != "header":
                yield from (_variable(line.text, each, Act.READ) for each in part.children if each.kind == "VARIABLE")
        elif part.kind in _KEYWORDS:
            span = Span(part.start, part.end)
            yield Mention(
                Symbol(Sort.KEYWORD, line.text[part.start + 1 : part.end].upper(), table="keyword"), Act.SAY, span, span
            )
        elif part.kind in _TABLES:
            yield from _choice(line.text, part)


def file(symbol: Symbol, file: str, ruleset: RuleSet, host: Host) -> str | None:
    """The file of a snippet."""
    if symbol.sort is not Sort.FILE:
        return None
    found = Folder(host, file, str(ruleset.settings["snippets-dir"])).find(symbol.name)
    return None if found is None else found.path


def partial(before: str) -> int:
    """A variable with its bar, a directive with its `#`, or letters."""
    if before.count("|") % 2:
        return before.rindex("|")
    match = _PARTIAL.search(before)
    return match.start() if match else len(before)


def offers(expected: frozenset[str], before: str, partial: str) -> Iterator[Offer | str]:
    """By the terminals that can stand there."""
    if "NAME" in expected and _SNIPPET.match(before):
        yield Offer.FILES
    elif not before.strip() and "UNKNOWN" in expected:
        yield Offer.ENDS
        yield "keyword"
    # A form is read with a variable wherever one can be written by mistake; these places take one of few words.
    chosen = [_TABLES[each] for each in _TABLES if each in expected]
    yield from chosen
    if "VARIABLE" in expected and not chosen:
        yield Offer.VARIABLES


def called(before: str) -> None:
    """No call has arguments."""


def takes(document: Document, symbol: Symbol) -> Takes:
    """Nothing is handed over."""
    return Takes(written(symbol), (), "")


def resumed(before: str) -> str:
    """The start of a line says how it is read."""
    return before


def end(opener: Bracket) -> str:
    """`#ENDIF1`."""
    return f"#END{opener.word[1:]}{opener.label or ''}"


def files(file: str, ruleset: RuleSet, host: Host, before: str) -> Iterator[str]:
    """The snippets, also those in folders within."""
    folder = Folder(host, file, str(ruleset.settings["snippets-dir"]))
    waiting = [(folder.root, "")]
    for root, prefix in waiting:
        for each in host.names(root):
            inner = f"{root.rstrip('/')}/{each}"
            if host.names(inner) and len(waiting) < _MOST:
                waiting.append((inner, f"{prefix}{each}/"))
            else:
                yield f"{prefix}{each}"


def spelled(entry: Entry) -> str:
    """Directives with their `#`."""
    if entry.first is not None:
        return ""
    return f"#{entry.name}" if entry.table == "keyword" else entry.name


def valid(symbol: Symbol, name: str) -> str:
    """A variable's name has no bar in it, and is not empty."""
    good = name.strip(" \t") and not set("|\r\n") & set(name)
    return "" if good else f"`{name}` is no name"


def notes(document: Document, line: int, mention: Mention) -> Iterator[str]:
    """Of a variable inside a loop that counts it: how it is divided."""
    found = loops_around(document, line) if mention.symbol.sort is Sort.VARIABLE else ()
    for at, counters in found:
        for name, group in counters:
            if name == mention.symbol.name:
                node = document.node(at)
                step, mode = (node.text[each.start : each.end] for each in (group.step, group.mode))
                how = "their sum so far" if mode[:1] in "cC" else "the step itself"
                yield f"divided by `{node.text.split()[0]}` in line {at + 1} into equal steps of at most {step}; holds {how} in each pass"
                return


def loops_around(document: Document, line: int) -> Iterator[tuple[int, list[tuple[str, Group]]]]:
    """The heads of the loops around a line, innermost first, with what they count."""
    place = (line, 0)
    for _ in range(_DEEPEST):
        found = document.around(*place)
        if found is None:
            return
        at, bracket = found
        if bracket.kind == "loop":
            yield at, counted(document.node(at))
        place = (at, bracket.span.start)


def counted(head: LineNode) -> list[tuple[str, Group]]:
    """What the head of a loop counts, if its form is right."""
    return [
        (name_of(head.text[group.counter.start : group.counter.end]), group)
        for header in head.find("header")
        for group in groups(header)
        if group.counter.kind == "VARIABLE" and group.mode.kind == "MODE"
    ]


def meant(document: Document, line: int, mention: Mention) -> None:
    """Nothing stands for anything else."""


def written(symbol: Symbol) -> str:
    """`|name|`, `#FILE name`, or the name."""
    if symbol.sort is Sort.VARIABLE:
        return f"|{symbol.name}|"
    if symbol.sort is Sort.FILE:
        return f"#FILE {symbol.name}"
    return f"#{symbol.name}" if symbol.sort is Sort.KEYWORD and symbol.table == "keyword" else symbol.name


def _variable(text: str, token: Node | Token, act: Act) -> Mention:
    said = text[token.start + 1 : token.end - 1]
    bare = said.strip(" \t")
    at = token.start + 1 + len(said) - len(said.lstrip(" \t"))
    return Mention(
        Symbol(Sort.VARIABLE, bare, table="variable"), act, Span(token.start, token.end), Span(at, at + len(bare))
    )


def _snippet(text: str, node: Node) -> Iterator[Mention]:
    said = node.find("NAME")
    if said is not None:
        span = Span(said.start, said.end)
        yield Mention(Symbol(Sort.FILE, text[said.start : said.end]), Act.CALL, span, span)


def _choice(text: str, token: Token) -> Iterator[Mention]:
    said = text[token.start : token.end].lower()
    span = Span(token.start, token.end)
    meant = said if token.kind == "OPERATOR" else {"a": "alpha", "n": "numeric"}.get(said[0], said[0])
    yield Mention(Symbol(Sort.KEYWORD, meant, table=_TABLES[token.kind]), Act.SAY, span, span)
