"""How subprograms of RS274 are called: arguments as they are written, parameters as a subprogram uses and describes them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.symbols import Act, Called, Sort, Symbol, Takes
from deburr.symbols.index import all_symbols, mentions_of
from deburr_grammar.tree import Node

if TYPE_CHECKING:
    from deburr_grammar.document import Document

_BLANKS = re.compile(r"[ \t]+")
_HEAD = 20
"""So many lines at the head of a subprogram are looked at for what it says of itself."""
_CALL = re.compile(r"(?i)[ \t]*/?[ \t]*(?:n[0-9. \t]+)?o[ \t]*(<[^<>]*>|[0-9]+)[ \t]*c[ \t]*a[ \t]*l[ \t]*l(.*)")
_COMMENT = re.compile(r"[ \t]*(?:\(([^()]*)\)|;(.*))[ \t]*")
_DESCRIBED = re.compile(r"#([0-9]{1,2})[ \t]*[-=:]?[ \t]*([A-Za-z][^#,;\n]*)")
_NAMED = re.compile(r"[ \t]*#<[ \t]*([^<>]+?)[ \t]*>[ \t]*=[ \t]*\[?[ \t]*#([0-9]{1,2})[ \t]*\]?[ \t]*(?:[(;].*)?$")


def called(before: str) -> Called | None:
    """A call with an argument that is open, or with all that it has so far."""
    match = _CALL.match(before)
    if match is None:
        return None
    depth = given = 0
    for sign in match[2]:
        depth += (sign == "[") - (sign == "]")
        given += sign == "]" and not depth
    name = _BLANKS.sub("", match[1]).strip("<>").lower()
    return Called(Symbol(Sort.SUB, str(int(name)) if name.isdigit() else name), match.start(1), given)


def takes(document: Document, symbol: Symbol) -> Takes:
    """The parameters that it uses, by the names that it gives them, and the comments at its head."""
    head = next((each.line for each in mentions_of(document, symbol) if each.mention.act is Act.DEFINE), 0)
    comments = list(_comments(document, head))
    names = _named_parameters(document, head) | dict(_DESCRIBED.findall("\n".join(comments)))
    label, items = f"{written(symbol)} call", list[tuple[int, int]]()
    for number in range(1, max(parameters(document, symbol.name), *map(int, names), 0) + 1):
        said = names.get(str(number), f"#{number}").strip()
        items.append((len(label) + 2, len(label) + 2 + len(said)))
        label += f" [{said}]"
    return Takes(label, tuple(items), "\n".join(comments))


def arguments(document: Document, sub: str, number: int) -> Iterator[str]:
    """An argument of a subprogram in each call, as it is written there."""
    for each in mentions_of(document, Symbol(Sort.SUB, sub)):
        node = document.node(each.line)
        o_line = next(node.find("o_line"), None) if each.mention.act is Act.CALL else None
        if o_line is None:
            continue
        groups = [part for part in o_line.children if isinstance(part, Node) and part.kind == "group"]
        group = groups[number - 1] if number <= len(groups) else None
        said = f"`{node.text[group.start + 1 : group.end - 1].strip()}`" if group is not None else "nothing (0)"
        yield f"{said} in line {each.line + 1}"


def parameters(document: Document, sub: str) -> int:
    """How many parameters a subprogram uses: the highest number up to 30 that it names."""
    within = ("sub", sub)
    named = (symbol for symbol in all_symbols(document, Sort.VARIABLE) if symbol.local and symbol.name.isdigit())
    numbers = [int(symbol.name) for symbol in named if next(mentions_of(document, symbol, within), None) is not None]
    return max(numbers, default=0)


def written(symbol: Symbol) -> str:
    """`#5`, `#<name>`, `o<name>`, `o5`, or the name."""
    number = symbol.name.isdigit()
    if symbol.sort is Sort.VARIABLE:
        return f"#{symbol.name}" if number else f"#<{symbol.name}>"
    if symbol.sort in (Sort.SUB, Sort.LABEL):
        return f"o{symbol.name}" if number else f"o<{symbol.name}>"
    return symbol.name


def _named_parameters(document: Document, head: int) -> dict[str, str]:
    """The names to which a subprogram assigns its parameters: `#<depth> = #1`."""
    found: dict[str, str] = {}
    for line in range(head, min(head + _HEAD, document.line_count)):
        if match := _NAMED.match(document.line(line)):
            found.setdefault(match[2], match[1])
    return found


def _comments(document: Document, head: int) -> Iterator[str]:
    """The comments on the first line of a subprogram and on the lines before and behind it that have nothing else."""
    first = head
    while first > 0 and _COMMENT.fullmatch(document.line(first - 1)) and head - first < _HEAD:
        first -= 1
    for line in range(first, min(head + _HEAD, document.line_count)):
        text = document.line(line)
        match = _COMMENT.fullmatch(text) if line != head else _COMMENT.search(text)
        if match is not None:
            yield (match[1] or match[2] or "").strip()
        elif line > head:
            return
