"""Toolpath events, one JSON object a line: `{"section": NAME, "set": {WORD: value}}` (spec/cgt.md §11). Never opens a file, never knows which names there are."""

from __future__ import annotations

import json
import math
import re
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.formats import Fault
from deburr.suggest import suggestion
from deburr_grammar.text import Span, split_lines

if TYPE_CHECKING:
    from collections.abc import Iterator


class Given(NamedTuple):
    """A word that an event sets, without `#`, its value, and the columns of both."""

    name: str
    value: float | str
    span: Span
    value_span: Span


class Event(NamedTuple):
    """Words are set first, then the section runs; its name is empty where none does."""

    line: int
    section: str
    span: Span
    values: tuple[Given, ...]


class Events(NamedTuple):
    """The events in order, and what is wrong with the other lines."""

    events: tuple[Event, ...]
    faults: tuple[Fault, ...]


_KEYS = ("section", "set")
_PIECE = re.compile(r'"(?:[^"\\]|\\.)*"|[{}\[\]:,]|[^\s"{}\[\]:,]+')


class _Key(NamedTuple):
    """A key of an object: how deep it stands, and the columns of the key and of what its value begins with."""

    name: str
    depth: int
    span: Span
    value: Span


def read(text: str) -> Events:
    """The events in a text."""
    found: list[Event] = []
    faults: list[Fault] = []
    for number, line in enumerate(split_lines(text)):
        if not line.strip():
            continue
        wrong = sorted(_faults(number, line))
        faults += wrong
        if not wrong:
            found.append(_event(number, line))
    return Events(tuple(found), tuple(faults))


def _faults(number: int, line: str) -> Iterator[Fault]:
    whole = Span(len(line) - len(line.lstrip()), len(line.rstrip()))
    try:
        data = json.loads(line)
    except json.JSONDecodeError as error:
        at = min(error.pos, max(0, len(line.rstrip()) - 1))
        yield Fault(number, Span(at, at + 1), f"this line is no JSON object: {error.msg[0].lower()}{error.msg[1:]}")
        return
    except (ValueError, RecursionError):
        yield Fault(number, whole, "this line is no JSON object that can be read")
        return
    if not isinstance(data, dict):
        yield Fault(number, whole, 'this line is no JSON object; write `{"section": "LINE", "set": {"XPOS": 1}}`')
        return
    keys = list(_keys(line))
    yield from _twice(number, keys)
    for key, value in data.items():
        yield from _of_key(number, key, value, keys, whole)


def _of_key(number: int, key: str, value: Any, keys: list[_Key], whole: Span) -> Iterator[Fault]:
    place = next((each for each in keys if each.depth == 1 and each.name == key), None)
    span, at = (place.span, place.value) if place else (whole, whole)
    if key not in _KEYS:
        yield Fault(
            number, span, f"`{key}` is no key of an event; the keys are `section` and `set`{suggestion(key, _KEYS)}"
        )
    elif key == "section" and not (isinstance(value, str) and value):
        yield Fault(number, at, "`section` takes the name of a section as a text")
    elif key == "set" and not isinstance(value, dict):
        yield Fault(number, at, '`set` takes words with their values, `{"XPOS": 1}`')
    elif key == "set":
        for word, said in value.items():
            inner = next((each for each in keys if each.depth == 2 and each.name == word), None)
            good = isinstance(said, str) or (type(said) in (int, float) and _finite(said))
            if not good:
                yield Fault(number, inner.value if inner else whole, f"`{word}` takes a number or a text")
            elif isinstance(said, str) and len(split_lines(said)) > 1:
                yield Fault(number, inner.value if inner else whole, f"the text of `{word}` holds a line break")


def _finite(said: float) -> bool:
    try:
        return math.isfinite(float(said))
    except OverflowError:
        return False


def _twice(number: int, keys: list[_Key]) -> Iterator[Fault]:
    seen = set[tuple[int, str]]()
    for key in keys:
        if (key.depth, key.name) in seen:
            yield Fault(number, key.span, f"`{key.name}` stands twice in this event; only one of them can hold")
        seen.add((key.depth, key.name))


def _event(number: int, line: str) -> Event:
    data = json.loads(line)
    keys = {(key.depth, key.name): key for key in _keys(line)}
    section = keys.get((1, "section"))
    values = ((keys[2, word], said) for word, said in data.get("set", {}).items())
    return Event(
        number,
        data.get("section", ""),
        section.value if section else Span(0, len(line)),
        tuple(
            Given(key.name, said if isinstance(said, str) else float(said), key.span, key.value) for key, said in values
        ),
    )


def _keys(line: str) -> Iterator[_Key]:
    """The keys of a line of JSON that can be read."""
    depth = 0
    pieces = list(_PIECE.finditer(line))
    for at, piece in enumerate(pieces):
        depth += (piece[0] in "{[") - (piece[0] in "}]")
        if piece[0].startswith('"') and pieces[at + 1 : at + 2] and pieces[at + 1][0] == ":":
            yield _Key(json.loads(piece[0]), depth, Span(*piece.span()), Span(*pieces[at + 2].span()))
