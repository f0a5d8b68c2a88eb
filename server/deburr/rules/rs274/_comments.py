"""What rules on comments share: the comments of a line, and which of them the control acts upon (spec/rs274.md §1.5)."""

import re

from deburr.rule import Line
from deburr_grammar.tree import Node, Token, tokens, walk

ACTIVE = r"(?i:\([ \t]*(?:(?:msg|debug|print|log|logopen|logappend|abort|py|pyrun),|(?:logclose|probeopen|probeclose|pyreload)\b))"
"""How a comment starts that does something."""
_ACTIVE = re.compile(ACTIVE)


def comments(line: Line) -> list[Node | Token]:
    """The comments in brackets, in order."""
    return [part for part in walk(line.node.tree) if part.kind in ("COMMENT", "active")]


def tail(line: Line) -> Token | None:
    """The comment from a `;` to the end of the line."""
    return next((part for part in tokens(line.node.tree) if part.kind == "SEMICOLON_COMMENT"), None)


def active(line: Line, comment: Node | Token) -> str:
    """The word for which the control acts upon a comment, in capitals: `MSG`; nothing if it does not."""
    match = _ACTIVE.match(line.said(comment))
    return match[0].strip("(, \t").upper() if match else ""
