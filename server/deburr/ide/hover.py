"""What is known of the thing at a place, in Markdown: what it means, whose it is, what it holds there, where it is set and read. Claims nothing that it does not know."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.ide.definition import file_of
from deburr.ide.known import held, is_seen, known, proven
from deburr.ide.related import uses
from deburr.symbols import Act, Sort, entry_of, language_of
from deburr.symbols.constants import constants_of, count
from deburr.symbols.index import Placed, at

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.codes import Entry
    from deburr_grammar.text import Pos, Span

_LISTED = 3
"""So many lines are named; of more, only how many there are."""
_MOST = 500
"""So many uses are looked at: to count all would take longer the longer a program is."""
_LONGEST = 60
_LATER = "where it is used is known when the program has been read"
_USED = (Sort.VARIABLE, Sort.WORD, Sort.SUB, Sort.LABEL, Sort.SECTION)
_HOLDING = (Sort.VARIABLE, Sort.WORD)
_FACTS = {"unit": "unit", "type": "type", "kind": "kind", "argument": "argument", "result": "result"}
_UNKNOWN = {
    "machine": "only the machine has it",
    "operator": "it is the operator's",
    "table": "it is stored at the control",
    "toolpath": "the toolpath gives it",
}

Found = dict[Act, list[tuple["View", Placed]]]


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


def described(entry: Entry, *more: str) -> Iterator[str]:
    """What a table says: signature, meaning, facts; ``more`` are facts that hold here."""
    if signature := entry.more.get("signature"):
        yield f"`{signature}`"
    yield entry.text
    yield " · ".join([*_facts(entry), *filter(None, more)])


def _facts(entry: Entry) -> Iterator[str]:
    for key, said in _FACTS.items():
        value = entry.more.get(key)
        if value and value != "none":
            yield f"{said}: {value}"
    if entry.more.get("access") == "read" or entry.more.get("settable") is False:
        yield "read only"
    if group := entry.more.get("group"):
        yield f"group: {group}"
    if words := entry.more.get("words"):
        yield f"words: {' '.join(words)}"


def _parts(view: View, placed: Placed) -> Iterator[str]:
    mention = placed.mention
    symbol, language = mention.symbol, language_of(view.dialect.name)
    assert language is not None
    entry = entry_of(symbol, view.dialect.codes)
    scope = _scope(placed) or (language.SHARED if symbol.sort is Sort.VARIABLE else "")
    yield f"**`{language.written(symbol)}`** {entry.title if entry is not None else symbol.sort.value}"
    if entry is not None:
        yield from described(entry, scope)
        yield rows(entry)
    else:
        yield scope
    if view.is_read:
        yield from language.notes(view.document, placed.line, mention)
    if symbol.sort is Sort.KEYWORD:
        yield from _lengths(view, placed)
    if file := file_of(view, symbol):
        yield f"file `{file.removeprefix(view.file.rpartition('/')[0] + '/')}`"
    if symbol.sort in _USED and not mention.passing:
        seen = is_seen(view, placed)
        found = _found(view, placed) if seen else {}
        if symbol.sort in _HOLDING:
            yield _value(view, placed, entry, found if seen else None)
        yield _places(view, symbol.sort, found) if seen else _LATER


def _lengths(view: View, placed: Placed) -> Iterator[str]:
    """How often the loop goes round that a keyword starts."""
    constants = constants_of(view.dialect.name)
    if constants is not None:
        found = constants.lengths(view.document, placed.line, partial(held, view), view.ruleset.settings)
        yield " · ".join(each.text for each in found)


def rows(entry: Entry) -> str:
    """The codes that a table word prints, by their number."""
    codes: Any = entry.more.get("codes")
    if not codes:
        return ""
    return "\n".join(["| row | prints |", "|---|---|", *(f"| {row} | `{code}` |" for row, code in enumerate(codes))])


def _scope(placed: Placed) -> str:
    if not placed.mention.symbol.local:
        return ""
    if placed.region is None:
        return "of the main program; subprograms have their own"
    kind, label = placed.region
    return f"of the {kind} `{label}` alone" if label is not None else f"of this {kind} alone"


def _found(view: View, placed: Placed) -> Found:
    found: Found = {}
    for each, one in islice(uses(view, placed.mention.symbol, placed.region), _MOST):
        found.setdefault(one.mention.act, []).append((each, one))
    return found


def _value(view: View, placed: Placed, entry: Entry | None, found: Found | None) -> str:
    """What it holds here; what is not known is called that, with the reason; without uses there is none yet."""
    if entry is not None and (constant := entry.more.get("value")):
        return f"value: **{constant}**"
    if value := known(view, placed):
        return f"value here: **{value.said}** ({value.why})"
    if told := proven(view, placed):
        passes = [] if told.passes is None else [f"({count(told.passes)})"]
        why = ", ".join(passes + [told.why] * bool(told.why))
        return f"value here: **{told.text}** {why or '(on every way to this line)'}"
    return "" if found is None else f"value here: not known, {_reason(view, placed, entry, Act.SET in found)}"


def _reason(view: View, placed: Placed, entry: Entry | None, is_set: bool) -> str:
    """Why a value is not known."""
    more = entry.more if entry is not None else {}
    if said := _UNKNOWN.get(str(more.get("known"))):
        return said
    language = language_of(view.dialect.name)
    assert language is not None
    if is_set or more.get("access") == "read" or more.get("settable") is False:
        return language.SET
    inside: str = more.get("inside", "") if placed.region is not None else ""
    return inside or language.UNSET


def _places(view: View, sort: Sort, found: Found) -> str:
    """Where it is defined, set, read and called. What is set once is shown as it stands there."""
    called = "called" if sort is Sort.SUB else "named"
    words = ((Act.DEFINE, "defined"), (Act.SET, "set"), (Act.READ, "read"), (Act.CALL, called))
    return " · ".join(_said(word, view, places) for act, word in words if (places := found.get(act)))


def _said(word: str, view: View, places: Sequence[tuple[View, Placed]]) -> str:
    lines = dict.fromkeys((each.file, one.line) for each, one in places)
    listed = [_place(view, *line) for line in islice(lines, _LISTED)]
    over = "over " if len(places) > _MOST - 2 * _LISTED else ""
    more = f" and {over}{len(lines) - _LISTED} more" if len(lines) > _LISTED else ""
    text = f"{word} in {', '.join(listed)}{more}"
    if word == "set" and len(places) == 1:
        each, one = places[0]
        line = each.document.line(one.line).strip()
        text += f": `{line}`" if len(line) <= _LONGEST and "`" not in line else ""
    return text


def _place(view: View, file: str, line: int) -> str:
    """A line as people count; in other files with their names."""
    name = "" if file == view.file else f" of `{file.rpartition('/')[2]}`"
    return f"line {line + 1}{name}"
