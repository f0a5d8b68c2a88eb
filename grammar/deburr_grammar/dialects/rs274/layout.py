"""How RS274 lines are laid out: blanks and the case of letters mean nothing outside comments (spec/rs274.md §1). The style is that of LinuxCNC's samples."""

from deburr_grammar.dialects.rs274.outline import State
from deburr_grammar.layout import Between, Case, Gap, Layout
from deburr_grammar.tree import Node, Token

_COMMENTS = ("COMMENT", "ACTIVE_OPEN", "SEMICOLON_COMMENT")
_COMMANDS = (
    "O", "SUB", "ENDSUB", "CALL", "RETURN", "IF", "ELSEIF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "DO", "REPEAT", "ENDREPEAT",
    "BREAK", "CONTINUE",
)  # fmt: skip
_UPPER = ("LETTER", "N", "LOGIC", "COMPARE", "MOD", "FUNCTION", "ATAN", "EXISTS")


def _gap(between: Between) -> Gap:
    node, left = between.node, between.left
    if between.right.kind in _COMMENTS:
        return Gap.ASIDE
    match node.kind:
        case "line":
            return Gap.NONE if left.kind == "DELETE" else Gap.ONE
        case "o_line":
            return Gap.NONE if left.kind == "O" else Gap.ONE
        case "setting":
            return Gap.SOME
        case "comparison" | "logical" | "modulo":
            return Gap.ONE
        case "sum" | "product" | "quotient" | "power":
            return Gap.EVEN
        case "atan":
            return Gap.NONE if left.kind == "ATAN" else Gap.EVEN
        case "line_number" | "word" | "label" | "signed" | "param" | "group" | "function" | "exists":
            return Gap.NONE
    return Gap.KEEP


def _case(node: Node, token: Token) -> Case:
    if token.kind in _COMMANDS:
        return Case.LOWER
    return Case.UPPER if token.kind in _UPPER else Case.ANY


def _inside(state: State) -> int:
    return int(state.sub)


LAYOUT = Layout(
    gap=_gap,
    case=_case,
    indented=frozenset(("line",)),
    trimmed=frozenset(("line",)),
    empties=True,
    inside=_inside,
    parted=frozenset(("if",)),
    # Where lines end with CR and LF the control reads 251 characters.
    longest=251,
)
