"""What is known of the thing at a place, in Markdown: what it means, whose it is, where it is set and read. Claims nothing that it does not know."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.ide.definition import file_of
from deburr.ide.related import uses
from deburr.symbols import Act, Sort, Symbol, entry_of, language_of
from deburr.symbols.index import Placed, at

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.codes import Entry
    from deburr_grammar.text import Pos, Span

_LISTED = 3
"""So many lines are named; of more, only how many there are."""
_LONGEST = 60
_USED = (Sort.VARIABLE, Sort.SUB, Sort.LABEL, Sort.SECTION)
_FACTS = {"unit": "unit", "type": "type", "kind": "kind", "argument": "argument", "result": "result"}
_KNOWN = {"machine": "its value is known to the machine only", "operator": "its value is the operator's"}


class Hover(NamedTuple):
    """What is shown, and the columns that it is about."""

    text: str
    span: Span


def hover(view: View, pos: Pos) -> Hover | None:
    """What is known of the thing at a place."""
    placed = at(view.document, pos.line, pos.col)
    if placed is None:
        return None
    parts = [part for part in _parts(view, placed) if part]
    return Hover("\n\n".join(parts), placed.mention.span)


def described(entry: Entry) -> Iterator[str]:
    """What a table says: signature, meaning, facts."""
    if signature := entry.more.get("signature"):
        yield f"`{signature}`"
    yield entry.text
    facts = [f"{said}: {entry.more[key]}" for key, said in _FACTS.items() if entry.more.get(key)]
    if entry.more.get("access") == "read":
        facts.append("read only")
    if group := entry.more.get("group"):
        facts.append(f"group: {group}")
    if words := entry.more.get("words"):
        facts.append(f"words: {' '.join(words)}")
    if known := _KNOWN.get(str(entry.more.get("known"))):
        facts.append(known)
    yield " · ".join(facts)


def _parts(view: View, placed: Placed) -> Iterator[str]:
    symbol = placed.mention.symbol
    language = language_of(view.dialect.name)
    assert language is not None
    entry = entry_of(symbol, view.dialect.codes)
    yield f"**`{language.written(symbol)}`** {entry.title if entry is not None else symbol.sort.value}"
    if entry is not None:
        yield from described(entry)
        yield rows(entry)
    yield _scope(placed)
    yield from language.notes(view.document, placed.line, placed.mention)
    if file := file_of(view, symbol):
        yield f"file `{file}`"
    if symbol.sort in _USED:
        yield from _places(view, symbol, placed)


def rows(entry: Entry) -> str:
    """The codes that a table word prints, by their number."""
    codes: Any = entry.more.get("codes")
    if not codes:
        return ""
    return "\n".join(["| row | prints |", "|---|---|", *(f"| {row} | `{code}` |" for row, code in enumerate(codes))])


def _scope(placed: Placed) -> str:
    symbol = placed.mention.symbol
    if not symbol.local:
        return ""
    if placed.region is None:
        return "of the main program; subprograms have their own"
    kind, label = placed.region
    return f"of the {kind} `{label}` alone" if label is not None else f"of this {kind} alone"


def _places(view: View, symbol: Symbol, placed: Placed) -> Iterator[str]:
    """Where it is set and read. What is set once is shown as it stands there."""
    found: dict[Act, list[tuple[View, Placed]]] = {}
    for each, one in uses(view, symbol, placed.region):
        found.setdefault(one.mention.act, []).append((each, one))
    said = [
        _said(word, view, places)
        for act, word in (
            (Act.DEFINE, "defined"),
            (Act.SET, "set"),
            (Act.READ, "read"),
            (Act.CALL, "called" if symbol.sort is Sort.SUB else "named"),
        )
        if (places := found.get(act))
    ]
    entry = entry_of(symbol, view.dialect.codes)
    free = entry is None or entry.more.get("access") != "read"
    if symbol.sort is Sort.VARIABLE and free and Act.SET not in found and Act.DEFINE not in found:
        said.insert(0, "set nowhere here: its value is not known")
    yield " · ".join(said)


def _said(word: str, view: View, places: Sequence[tuple[View, Placed]]) -> str:
    listed = [_place(view, each, one.line) for each, one in places]
    listed = list(dict.fromkeys(listed))
    more = f" and {len(listed) - _LISTED} more" if len(listed) > _LISTED else ""
    text = f"{word} in {', '.join(listed[:_LISTED])}{more}"
    if word == "set" and len(places) == 1:
        each, one = places[0]
        line = each.document.line(one.line).strip()
        text += f": `{line}`" if len(line) <= _LONGEST and "`" not in line else ""
    return text


def _place(view: View, other: View, line: int) -> str:
    """A line as people count; in other files with their names."""
    name = "" if other.file == view.file else f" of `{other.file.rpartition('/')[2]}`"
    return f"line {line + 1}{name}"
