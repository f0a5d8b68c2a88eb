"""Which values are numbers and which are texts (spec/cgt.md §5.8). Says nothing of words that nobody knows."""

import math
import re
from collections.abc import Iterator

from deburr.arithmetic.cgt import arguments_of
from deburr.templates.symbols import Symbols
from deburr_grammar.tree import Node, Token, walk

TEXT_FUNCTIONS = frozenset({"STRSUB"})
OF_TEXT = frozenset({"STRLEN", "STRSUB"})
"""Functions whose first argument is a text."""


_NUMBER = re.compile(r"[ \t]*[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)[ \t]*")


def is_number(said: str) -> bool:
    """Whether a text is a number as templates write them, with blanks around it."""
    return _NUMBER.fullmatch(said) is not None and math.isfinite(float(said))


def value_of(node: Node, behind: str) -> Node | Token | None:
    """What stands between a sign of a command (`=` or its parenthesis) and the end of the command."""
    at = next(number for number, part in enumerate(node.children) if part.kind == behind)
    found = node.children[at + 1]
    return None if found.kind == "RPAR" else found


def no_numbers(symbols: Symbols, text: str, part: Node | Token) -> Iterator[Node | Token]:
    """The operands of a calculation that are texts."""
    if isinstance(part, Token):
        word = symbols.find(text[part.start + 1 : part.end]) if part.kind == "WORD" else None
        if part.kind == "CHARS" or (word is not None and word.is_text):
            yield part
        return
    if part.kind == "job":
        if "_" in text[part.start : part.children[0].end]:
            yield part
        return
    if part.kind == "function":
        name = text[part.start : part.children[0].end].upper()
        if name in TEXT_FUNCTIONS:
            yield part
        else:
            yield from misfits(symbols, text, part)
        return
    for child in part.children:
        if isinstance(child, Node) or child.kind == "WORD":
            yield from no_numbers(symbols, text, child)


def misfits(symbols: Symbols, text: str, function: Node) -> Iterator[Node | Token]:
    """The arguments of a function that are no texts where it takes one, or no numbers where it takes those."""
    name = text[function.start : function.children[0].end].upper()
    arguments = arguments_of(function)
    if name in OF_TEXT and arguments:
        first, arguments = arguments[0], arguments[1:]
        word = symbols.find(text[first.start + 1 : first.end]) if first.kind == "WORD" else None
        if word is not None and not word.is_text:
            yield first
    for argument in arguments:
        yield from no_numbers(symbols, text, argument)


def is_plain(part: Node | Token) -> bool:
    """Whether a value is written with neither words nor functions: for a text word it is the text as it stands."""
    return not any(each.kind in ("WORD", "function", "job") for each in walk(part))
