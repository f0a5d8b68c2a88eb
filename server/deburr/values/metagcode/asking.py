"""MetaGCODE's conditions as nodes: what is learned on both ways, and what is told where one of them is never gone (spec/metagcode.md §5.3). Knows no loop."""

from __future__ import annotations

from deburr.finding import Severity
from deburr.values.domain import truth
from deburr.values.graph import Calls, Dead, Env, Flows, Key, Node
from deburr.values.metagcode.conditions import COMPARED, Item, as_number, finite, spelled_alike, under
from deburr.values.metagcode.orders import Order, Standing, standing
from deburr_grammar.text import Span

CONSTANT = "condition-constant"


def asked(left: Item, word: str, right: Item, numeric: bool, ways: tuple[int, int], own: bool) -> Node:
    """The node of a condition. ``ways``: where it goes on where it holds, and where it does not; ``own``: whether it stands in the text itself."""
    then, otherwise = ways
    span = Span(left.span.start, right.span.end)
    names = frozenset(item.name for item in (left, right) if item.name is not None)
    order = standing(left, word, right, numeric)
    ask = _as_numbers if numeric else _as_texts

    def decided(env: Env, calls: Calls) -> Flows:
        known = order.holds(env) if order is not None else None
        flows: list[tuple[int, Env]] = []
        for to, holds in ((then, True), (otherwise, False)):
            learned = ask(env, left, word, right, holds)
            if learned is not None and known in (None, holds):
                flows.append((to, learned if order is None else order.under(learned, holds)))
        return flows

    used: frozenset[Key] = names if order is None else names | {order.key}
    said = f"`{left.said} {word} {right.said}`"
    return Node(0, decided, used, condition=span, dead=_dead(said, order, ways, span) if own and names else ())


def with_all_orders(nodes: dict[int, Node]) -> dict[int, Node]:
    """The nodes, of which each that asks for the text of a variable also uses what others say of that text."""
    told: dict[str, set[Key]] = {}
    for node in nodes.values():
        for key in node.used:
            if isinstance(key, Order) and key.is_text:
                told.setdefault(key.name, {key.name}).add(key)
    shared = {name: frozenset(keys) for name, keys in told.items()}
    of = {key: shared[name] for name, keys in told.items() for key in keys if isinstance(key, Order)}
    found = {}
    for at, node in nodes.items():
        asked = next((of[key] for key in node.used if key in of), None)
        found[at] = node if asked is None else node._replace(used=asked)
    return found


def _dead(said: str, order: Standing | None, ways: tuple[int, int], span: Span) -> tuple[Dead, ...]:
    """What is told of a condition that never holds, or always does."""
    then, otherwise = ways
    kind, why = "if-contradiction", "what the conditions around it say contradicts this one"
    if order is not None and order.is_of_one:
        kind, why = CONSTANT, f"{said} never holds, because it compares a variable with itself"
    always = f"{said} always holds here, so that it decides nothing"
    return (
        Dead(then, kind, span, f"{why}: its lines are never generated"),
        Dead(otherwise, CONSTANT, span, always, Severity.INFO),
    )


def _as_numbers(env: Env, left: Item, word: str, right: Item, holds: bool) -> Env | None:
    """The values under which a comparison of numbers is true, or false; None: it never is."""
    found: Env = {item.name: as_number(item, env) for item in (left, right) if item.name is not None}
    env = {**env, **found}
    known = truth(COMPARED[word](finite(left.of(env)), finite(right.of(env))))
    return under(env, left, word, right, holds) if known in (None, holds) else None


def _as_texts(env: Env, left: Item, word: str, right: Item, holds: bool) -> Env | None:
    """The values under which a comparison of texts is true, or false; None: it never is."""
    is_same = word == "equalto" if holds else word == "notequalto"
    return spelled_alike(env, left, right) if is_same else env
