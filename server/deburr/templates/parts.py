"""What stands in a body as it is executed: items, branches with their `#ELSE`, loops; comments and what belongs to them are gone. Never looks at a value."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.templates.items import Body, Item

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

TRAILING = "trailing"
"""The kind of blanks between something and a comment: they are output only behind text."""
_OUTPUT = ("word", "lookup", "text")


class Branch(NamedTuple):
    """A conditional bracket or an `#IF`, with the body of its `#ELSE`."""

    body: Body
    other: Body | None


Part = Item | Branch | Body
"""Bodies are those of `#REPEAT`. Items and bodies that belong to nothing are given too: they are faults."""


def parts_of(body: Body) -> Iterator[Part]:
    """The parts in order."""
    parts = body.parts
    passed: set[int] = set()
    for at, part in enumerate(parts):
        if at in passed:
            continue
        if isinstance(part, Body):
            if part.kind in ("bracket", "if"):
                other = _else_of(parts, at)
                passed |= {at + 1, at + 2} if other is not None else set()
                yield Branch(part, other)
            else:
                yield part
        elif (item := _executed(parts, at)) is not None:
            yield item


def first_line(part: Part) -> int:
    """The line on which a part begins."""
    if isinstance(part, Item):
        return part.line
    opener = (part.body if isinstance(part, Branch) else part).opener
    assert opener is not None
    return opener.line


def last_line(part: Part) -> int:
    """The line on which a part ends."""
    if isinstance(part, Item):
        return part.line
    body = (part.other or part.body) if isinstance(part, Branch) else part
    return body.closer.line if body.closer is not None else first_line(part)


def by_line(parts: Iterable[Part]) -> list[list[Part]]:
    """Parts with no line break between them."""
    found: list[list[Part]] = []
    for part in parts:
        if found and last_line(found[-1][-1]) == first_line(part):
            found[-1].append(part)
        else:
            found.append([part])
    return found


def starts_with_break(body: Body) -> bool:
    """Whether nothing stands behind the `<` of a body on its line."""
    assert body.opener is not None and body.closer is not None
    first = next((first_line(part) for part in parts_of(body)), body.closer.line)
    return first > body.opener.line


def _executed(parts: Sequence[Item | Body], at: int) -> Item | None:
    item = parts[at]
    assert isinstance(item, Item)
    behind = parts[at + 1] if at + 1 < len(parts) else None
    if item.kind in ("comment", "if"):
        return None
    if item.kind == "repeat":
        bodies = (part for part in parts[at:] if isinstance(part, Body))
        return None if next((body for body in bodies if body.head is item), None) is not None else item
    if item.blank and isinstance(behind, Item) and behind.kind == "comment" and behind.line == item.line:
        before = _on_line(parts[at - 1], item.line) if at else None
        if before is None:
            return None
        return item if isinstance(before, Item) and before.kind in _OUTPUT else item._replace(kind=TRAILING)
    return item


def _on_line(part: Item | Body, line: int) -> Item | Body | None:
    """The part if it ends on a line."""
    last = part if isinstance(part, Item) else part.closer
    return part if last is not None and last.line == line else None


def _else_of(parts: Sequence[Item | Body], at: int) -> Body | None:
    """The body of an `#ELSE` directly behind a body."""
    body, *behind = parts[at : at + 3]
    if len(behind) < 2 or not isinstance(body, Body) or body.closer is None:
        return None
    item, other = behind
    if not isinstance(item, Item) or not isinstance(other, Body) or item.kind != "else" or other.kind != "else":
        return None
    assert other.opener is not None
    joined = (item.line, item.start) == (body.closer.line, body.closer.end)
    return other if joined and (other.opener.line, other.opener.start) == (item.line, item.end) else None
