"""One definition of every operator and function of each language, for constants in a line, proven values and the expander alike.

A module is named after its dialect and found by that name. Results are values or
`ArithmeticFault`s; a fault is never raised, because a faulty program is no error of ours.
"""

from collections.abc import Callable
from dataclasses import dataclass

from deburr_grammar.tree import Node, Token


@dataclass(frozen=True, slots=True)
class ArithmeticFault:
    """An operation that the control refuses: the rule's short name, what to blame, and why in the user's words."""

    rule: str
    part: Node | Token
    why: str


class Refusal(Exception):
    """Inside arithmetic and interpreters: the control refuses an operation. ``rule`` is a short name, ``why`` in the user's words."""

    def __init__(self, rule: str, why: str) -> None:
        super().__init__(why)
        self.rule = rule
        self.why = why


def tried(
    apply: Callable[..., float], part: Node, divisor: Node | Token, *values: float | ArithmeticFault | None
) -> float | ArithmeticFault | None:
    """A result, or the first fault among the values, or what the control refuses; None if a value is not known."""
    for value in values:
        if isinstance(value, ArithmeticFault):
            return value
    if None in values:
        return None
    try:
        return apply(*values)
    except Refusal as refused:
        return ArithmeticFault(refused.rule, divisor if refused.rule == "divide-by-zero" else part, refused.why)
