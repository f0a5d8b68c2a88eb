"""What is decided in a template's section: where ways lead, what is said of those that are never taken, how often loops go round (spec/cgt.md §5.2, §5.4, §5.6). Builds nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from deburr.arithmetic.cgt import equal
from deburr.finding import Severity
from deburr.templates.items import Body, Item
from deburr.values.domain import UNITS, Value, above, below
from deburr.values.graph import RETURN, Proof
from deburr_grammar.text import Span

PASSES = 100_000
"""Passes that one `#REPEAT` may make (spec/cgt.md §8)."""
CONSTANT = "condition-constant"


class Label:
    """A node that is known when what stands before it is built."""

    def __init__(self) -> None:
        self.at = RETURN


class Way(NamedTuple):
    """A way that a node ought to take now and then, and what is said if it never does."""

    to: Label | int
    kind: str = ""
    message: str = ""
    severity: Severity | None = None


def extent(head: Item, body: Body) -> Span:
    """The columns of what decides: the test of an `#IF`, or a bracket as far as it stands on its line."""
    if body.head is None:
        same = body.closer is not None and body.closer.line == head.line
        return Span(head.start, body.closer.end if same and body.closer is not None else head.end)
    node = body.head.node
    asked = (node.node("tests") or node.node("string_tests")) if node is not None else None
    return Span(asked.start, asked.end) if asked is not None else head.span


def said_of(body: Body, inside: int, other: Label) -> Iterator[Way]:
    """What is said of ways that are never taken. A body that only leaves guards against what nobody expects."""
    if body.head is None:
        message = "this bracket never prints: on every way here its words have been output since they last changed"
        yield Way(inside, "bracket-idle" if any(map(_is_more, body.items())) else "", message)
        yield Way(other)
        return
    whole = body.head.text
    said = f"`{whole if body.head.name == 'IFCHG' else whole.partition('(')[2].rpartition(')')[0]}`"
    guards = bool(body.parts) and all(
        isinstance(each, Item) and each.kind in ("exit", "comment") for each in body.parts
    )
    yield Way(
        inside, "" if guards else CONSTANT, f"{said} never holds here, so that what stands under it is never output"
    )
    yield Way(other, CONSTANT, f"{said} always holds here", Severity.INFO)


def _is_more(item: Item) -> bool:
    """Whether a bracket prints or does more with an item than to repeat its words."""
    if item.kind == "text":
        return any(sign.isdigit() for sign in item.text)
    return item.kind in ("eval", "macro", "mark", "lookup", "call", "exit")


def counts(value: Value, said: str, span: Span) -> Value:
    """The numbers of passes that a count can be. It raises a `Proof` where none of its numbers is one."""
    if value.empty or value.wild:
        return Value(0.0, float(PASSES), UNITS)
    if value.low == value.high:
        passes = round(value.low)
        if passes < 0 or not equal(value.low, passes):
            message = f"`{said}` is {value.low:g} here; a whole number from 0 on is needed"
            raise Proof("repeat-count", span, message)
    elif value.high < 0:
        raise Proof("repeat-count", span, f"`{said}` is always below 0 here; a whole number from 0 on is needed")
    elif value.step and value.step % UNITS == 0 and not value.whole and value.high < PASSES:
        raise Proof("repeat-count", span, f"`{said}` is never a whole number here; one from 0 on is needed")
    if value.low > PASSES + 1:
        raise Proof("limit", span, f"`{said}` asks for {value.low:,.0f} passes or more; {PASSES:,} are the limit")
    return above(below(value, PASSES + 1.0, False), 0.0, False)
