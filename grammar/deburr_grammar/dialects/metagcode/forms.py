"""What the items of a directive say: conditions, loop variables, names and numbers (spec/metagcode.md §3). Never judges them."""

import re
from collections.abc import Iterator
from decimal import Decimal
from functools import lru_cache
from typing import NamedTuple

from deburr_grammar.line import LineNode
from deburr_grammar.tree import Node, Token, tokens

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)")
_REFERENCE = re.compile(r"\|([^|\r\n]*)\|")


class Condition(NamedTuple):
    """The four items of a complete `#IF`. A variable is a token VARIABLE, an item that cannot be what it should is ODD."""

    left: Token
    operator: Token
    right: Token
    type: Token


class Group(NamedTuple):
    """A variable of a complete `#LOOP` with its maxStep and its step type."""

    counter: Token
    step: Token
    mode: Token


def condition(node: Node) -> Condition:
    """The items of a `condition` node."""
    return Condition(*tokens(node))


def groups(header: Node) -> list[Group]:
    """The variables of a `header` node, from left to right."""
    return [Group(*tokens(group)) for group in header.nodes()]


@lru_cache(maxsize=4096)
def counters(line: LineNode) -> tuple[tuple[str, Token], ...]:
    """The names that a `#LOOP` counts with their tokens; none if its header is not complete."""
    counted = [group.counter for header in line.find("header") for group in groups(header)]
    return tuple((name(line.text[each.start : each.end]), each) for each in counted if each.kind == "VARIABLE")


def name(reference: str) -> str:
    """The name in `|name|`: outer blanks do not count."""
    return reference[1:-1].strip(" \t")


def names(text: str) -> Iterator[tuple[int, str]]:
    """The names that a text refers to, each with its offset."""
    return ((match.start(), match[1].strip(" \t")) for match in _REFERENCE.finditer(text))


def number(text: str) -> Decimal | None:
    """A plain decimal number, exactly; None where the text is none: there is no exponent."""
    return Decimal(text) if _NUMBER.fullmatch(text) else None


def is_numeric(type_: str) -> bool:
    """Whether a comparison type asks for numbers: its first letter decides."""
    return type_[:1] in ("n", "N")
