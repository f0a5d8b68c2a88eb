"""How Z32's advanced lines and expressions are laid out. Of an ISO block all else is printed as it is written (spec/z32.md §6.7, §11)."""

from deburr_grammar.layout import Between, Case, Gap, Layout
from deburr_grammar.tree import Node, Token

_RELATIONS = ("EQ", "LANGLE", "RANGLE")
_PRINTED = ("line", "word", "g_word", "movement")
_NAMED = ("IF", "EB", "CP", "PC", "GON", "GOP", "GOS", "FUNCTION", "PI", "NAME")


def _gap(between: Between) -> Gap:
    node, left, right = between.node, between.left, between.right
    match node.kind:
        case "line":
            return _between_parts(between)
        case "advanced":
            return _between_fields(between)
        case "if":
            return Gap.ONE
        case "comparison":
            return Gap.NONE if left.kind in _RELATIONS and right.kind in _RELATIONS and _is_part(between) else Gap.EVEN
        case "assign" | "sum" | "product":
            return Gap.EVEN
        case "config":
            return Gap.EVEN if "EQ" in (left.kind, right.kind) else Gap.FEW if left.kind == "COMMA" else Gap.NONE
        case "jump" | "range_end" | "call" | "file_call" | "vector" | "angle" | "unary" | "function" | "group":
            return Gap.NONE
    return Gap.KEEP


def _between_parts(between: Between) -> Gap:
    """Of a block what stands before a `;` is printed without the blanks at its end."""
    if between.right.kind in ("TAIL", "SEMI"):
        return Gap.ASIDE
    return Gap.FEW if between.right.kind == "BANG" else Gap.KEEP


def _between_fields(between: Between) -> Gap:
    left, right = between.left, between.right
    if right.kind in ("REST", "TAIL"):
        return Gap.ASIDE
    if left is between.node.children[0] or right.kind in ("SEMI", "BANG", "END"):
        return Gap.NONE
    return Gap.ONE


def _is_part(between: Between) -> bool:
    """Whether both tokens belong to the relation itself, not to the expressions beside it."""
    return between.left in between.node.children and between.right in between.node.children


def _case(node: Node, token: Token) -> Case:
    return Case.UPPER if token.kind in _NAMED and node.kind not in _PRINTED else Case.ANY


LAYOUT = Layout(
    gap=_gap,
    case=_case,
    trimmed=frozenset(("advanced", "text", "section", "config", "PERCENT")),
    empties=True,
)
