"""How CGT commands are laid out. Outside the parentheses of a command all blanks of a template are printed, so they stay as they are (spec/cgt.md §2, §5.3)."""

import re

from deburr_grammar.layout import Between, Case, Gap, Layout
from deburr_grammar.tree import Node, Token

_COMMANDS = (
    "eval", "macro", "call", "mark", "lookup", "fmt", "block", "returned", "if", "repeat", "tests", "string_tests", "test",
    "string_test", "sum", "product", "quotient", "power", "signed", "group", "function", "job", "negative",
)  # fmt: skip
_SETS = ("eval", "macro", "returned")
_NUMERIC = re.compile(r"#(?:eval\([ \t]*#[uv][0-9]+[ \t]*=|evm[di]\(|retnum\()", re.IGNORECASE)
"""What sets or returns a number for certain."""
_OPERATORS = ("EQUAL", "RELATION", "STRING_RELATION", "SIGN", "STAR", "SLASH", "POWER")
_NAMED = (
    "DECLARE", "EVAL", "MACRO", "CALL", "GOTO", "RESET", "UPDATE", "TABLE", "FMT", "GETBLK", "SETBLK", "RETNUM", "RETSTR",
    "IF", "IFSTR", "IFCHG", "REPEAT", "LOGIC", "OPERATOR", "ELSE", "EXIT", "EXITC", "ONBLK",
)  # fmt: skip


def _gap(between: Between) -> Gap:
    node, left, right = between.node, between.left, between.right
    if node.kind == "declaration":
        return Gap.KEEP if right.kind == "DECLARE_COMMA" else Gap.FEW
    if node.kind not in _COMMANDS or _may_be_text(between):
        return Gap.KEEP
    if "COMMA" in (left.kind, right.kind) or "LOGIC" in (left.kind, right.kind):
        return Gap.NONE if right.kind == "COMMA" else Gap.FEW
    operates = left.kind in _OPERATORS or right.kind in _OPERATORS
    return Gap.EVEN if operates and node.kind not in ("signed", "negative") else Gap.NONE


def _may_be_text(between: Between) -> bool:
    """Whether a place is inside a value that may be a string: then `1 - 2` is text as it is written, and not computed (spec/cgt.md §5.8)."""
    command = next((node for node in between.around if node.kind in _SETS), None)
    if command is None or command is between.node:
        return False
    said = between.text[command.start : between.around[-1].start]
    return _NUMERIC.match(said) is None


def _case(node: Node, token: Token) -> Case:
    return Case.UPPER if token.kind in _NAMED else Case.ANY


LAYOUT = Layout(gap=_gap, case=_case, trimmed=frozenset(("header", "COMMENT")))
