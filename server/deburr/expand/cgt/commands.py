"""Commands that put texts on a line or change words: `#EVAL`, `#FMT`, `#TABLE`, `#RESET` and their like, as closures (spec/cgt.md §4, §5). Calls no section."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.expand.cgt.figures import format_of
from deburr.expand.cgt.lines import Place
from deburr.templates.types import value_of

if TYPE_CHECKING:
    from deburr.expand.cgt.state import State
    from deburr.expand.cgt.values import Values
    from deburr.templates.items import Item
    from deburr_grammar.tree import Node

Put = Callable[[list[str]], object]
"""Puts texts on the line that is being put together, or changes something."""


def command(state: State, values: Values, item: Item) -> Put | None:
    """What a command does; None if it does nothing."""
    assert item.node is not None
    return _COMMANDS[item.kind](state, values, item, item.node)


def place_of(item: Item) -> Place:
    """Where an item stands."""
    return Place(item.line, item.span)


def _eval(state: State, values: Values, item: Item, node: Node) -> Put:
    """`#EVAL`: a word gets a value."""
    target, value = node.children[2], value_of(node, "EQUAL")
    cell = values.cell(target) if target.kind == "WORD" else None
    if cell is None or not cell.settable:
        raise values.halt("eval-target", target, f"`{values.said(target)}` cannot be set; assign to a word of your own")
    if cell.is_text:
        text = values.text(value)
        return lambda _: cell.set(values.checked_length(node, text()))
    if value is None:
        raise values.halt("eval-type", node, f"`{item.text}` gives a number word no number")
    get = values.number(value)

    def put(out: list[str]) -> None:
        found = get()
        if found != cell.value:
            cell.value, cell.text = found, None

    return put


def _macro(state: State, values: Values, item: Item, node: Node) -> Put:
    """A macro variable: nothing reads it here, but it keeps its type."""
    macros = state.macros
    name, value = values.said(node.children[2]), value_of(node, "EQUAL")
    get: Callable[[], object] = values.text(value) if item.name == "EVMS" or value is None else values.number(value)

    def put(out: list[str]) -> None:
        kind, _ = macros.setdefault(name, (item.name, None))
        if kind != item.name:
            raise values.halt("eval-type", node, f"`{name}` was set by `#{kind}`; its type cannot change")
        macros[name] = (kind, get())

    return put


def _mark(state: State, values: Values, item: Item, node: Node) -> Put:
    """`#RESET` and `#UPDATE`."""
    shown, reset = state.shown, item.name == "RESET"
    words = [(values.cell(part), values.place(part)) for part in node.children if part.kind == "WORD"]

    def put(out: list[str]) -> None:
        for cell, at in words:
            cell.last = None if reset else cell.text if cell.text is not None else shown(cell, at)

    return put


def _lookup(state: State, values: Values, item: Item, node: Node) -> Put | None:
    """`#TABLE`: a row; nothing of a table that there is not."""
    row_of = state.row_of
    name, index = values.said(node.children[2]), node.children[-2]
    rows = state.words.rows(name)
    if rows is None:
        return None
    get, at = values.number(index), values.place(index)
    return lambda out: out.append(row_of(name, rows, get(), at))


def _fmt(state: State, values: Values, item: Item, node: Node) -> Put:
    """`#FMT`, until the section that gives it ends."""
    word = node.children[2]
    said, *width = (part for part in node.children if part.kind == "FORMAT")
    form = format_of(values.said(said), *map(values.said, width))
    if form is None:
        raise values.halt("format", said, f"`{values.said(said)}` is no format that a number can have")
    name = values.said(word)[1:]
    target = name if name in state.words.formats else values.cell(word)
    return lambda _: state.form(target, form)


def _block(state: State, values: Values, item: Item, node: Node) -> Put:
    """`#GETBLK` and `#SETBLK`."""
    get, lines, at = values.number(node.children[2]), state.lines, place_of(item)
    if item.name == "GETBLK":
        return lambda out: out.append(lines.marked(get(), item.text, at))
    cell, shown = state.words["BLK"], state.shown
    return lambda _: lines.mark(get(), shown(cell, at))


def numbered(state: State, item: Item) -> Put:
    """`#ONBLK`: lines have numbers from here on."""
    cell, at, step = state.words["BLK"], place_of(item), state.words.block_step

    def number() -> str:
        text = state.shown(cell, at)
        cell.last, cell.text = text, None
        cell.value = float(cell.value or 0.0) + step
        return f"N{text} "

    return lambda _: state.lines.number_with(number)


def _returned(state: State, values: Values, item: Item, node: Node) -> Put:
    """`#RETNUM` and `#RETSTR`."""
    value, at = value_of(node, "OPEN"), place_of(item)
    if item.name == "RETSTR" or value is None:
        text = values.text(value)
        return lambda _: state.returned(values.checked_length(node, text()), at)
    get = values.number(value)
    return lambda _: state.returned(get(), at)


_COMMANDS: dict[str, Callable[[State, Values, Item, Node], Put | None]] = {
    "eval": _eval,
    "macro": _macro,
    "mark": _mark,
    "lookup": _lookup,
    "fmt": _fmt,
    "block": _block,
    "returned": _returned,
}
