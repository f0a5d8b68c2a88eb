"""The fields of an advanced line in the groups that `!` makes of them (spec/z32.md §6.2)."""

from collections.abc import Iterator
from itertools import pairwise

from deburr_grammar.tree import Node, Token

STOPS = ("stop", "jump", "call", "file_call")
"""Fields that end the line when they run."""


def groups(advanced: Node) -> list[list[Node]]:
    """The fields between `!` and `!`; a false IF goes on with the next group."""
    found: list[list[Node]] = []
    for part in advanced.children:
        if isinstance(part, Node):
            found[-1].append(part)
        elif part.kind == "BANG":
            found.append([])
    return found


def terminated(advanced: Node) -> bool:
    """Whether the line has its last `!`."""
    return advanced.find("END") is not None


def trailing_block(advanced: Node) -> Node | None:
    """Words behind what was meant to be the last `!`: `!HA=1! G0 X1`."""
    last = advanced.children[-1]
    if not terminated(advanced) and isinstance(last, Node) and last.kind == "movement" and len(groups(advanced)) > 1:
        return last if len(groups(advanced)[-1]) == 1 else None
    return None


def empty_places(advanced: Node) -> Iterator[tuple[Token, Token]]:
    """Pairs of separators with no field between them."""
    for left, right in pairwise(advanced.children):
        if (
            isinstance(left, Token)
            and isinstance(right, Token)
            and left.kind in ("BANG", "SEMI")
            and right.kind != "TAIL"
        ):
            yield left, right


def goes_on(advanced: Node) -> bool:
    """Whether a run can go on with the next line: not if it jumps whatever the conditions are."""
    reached, skips = True, False
    for group in groups(advanced):
        reached, skips = reached or skips, False
        for field in group if reached else ():
            if field.kind in ("stop", "call", "file_call"):
                return True
            skips = skips or field.kind == "if"
            if field.kind == "jump":
                reached = False
                break
    return reached or skips


def certain(advanced: Node) -> Node | None:
    """The jump, call or EB that ends the line on every run; None if a condition comes first, or there is none."""
    for group in groups(advanced):
        for field in group:
            if field.kind == "if":
                return None
            if field.kind in STOPS:
                return field
    return None
