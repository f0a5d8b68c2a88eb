"""How MetaGCODE's directives are laid out. They print nothing; all other lines are printed with their blanks, so they stay as they are (spec/metagcode.md §2, §5.5)."""

from deburr_grammar.layout import Between, Case, Gap, Layout
from deburr_grammar.tree import Node, Token

_DIRECTIVES = frozenset(("if", "endif", "loop", "endloop", "file"))
_FORMS = ("condition", "partial", "header", "loose", "group")


def _gap(between: Between) -> Gap:
    # A label, and what is glued to the item before it, would be something else with a blank before it.
    apart = between.right.kind not in ("LABEL", "GLUED")
    return Gap.ONE if apart and (between.node.kind in _DIRECTIVES or between.node.kind in _FORMS) else Gap.KEEP


def _case(node: Node, token: Token) -> Case:
    return Case.UPPER if node.kind in _DIRECTIVES and token is node.children[0] else Case.ANY


LAYOUT = Layout(gap=_gap, case=_case, indented=_DIRECTIVES, trimmed=_DIRECTIVES)
