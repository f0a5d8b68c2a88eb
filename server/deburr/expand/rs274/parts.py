"""What stands on a line with an O-word: its label and its values. Runs nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.expand.rs274.source import Source
from deburr.expand.rs274.values import Get, Values
from deburr.fault import Halt
from deburr_grammar.dialects.rs274.outline import label_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

if TYPE_CHECKING:
    from deburr.expand.rs274.state import State
    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.line import LineNode


class Parts:
    """A line with an O-word taken apart. ``literal``: its label, if the line alone tells it."""

    def __init__(self, state: State, unit: Unit, row: int, node: LineNode, o_line: Node) -> None:
        values = Values(state, Source(unit.file, row, node.text))
        self.arguments: list[Get] = [values.value(part) for part in o_line.nodes() if part.kind == "group"]
        self.value: Get | None = self.arguments[0] if self.arguments else None
        label = o_line.node("label")
        assert label is not None, "an O-word has a label"
        self.literal = label_of(node.text, label)
        self.span = Span(o_line.start, o_line.end)
        self.said = node.text[o_line.start : o_line.end]
        self.label = self._label(values, label)

    @property
    def condition(self) -> Get:
        """The value of a command that must have one."""
        assert self.value is not None, "the grammar asks for it"
        return self.value

    def _label(self, values: Values, label: Node) -> Callable[[], str]:
        if (literal := self.literal) is not None:
            return lambda: literal
        number = values.integer(label.children[0], "o-label-integer")
        return lambda: str(number())


def condition(state: State, unit: Unit, row: int) -> Get | None:
    """The bracketed value of an O-word on another line of a file; None if it has none."""
    node = unit.document.node(row)
    groups = (part for o_line in node.find("o_line") for part in o_line.nodes() if part.kind == "group")
    group = next(groups, None)
    return Values(state, Source(unit.file, row, node.text)).value(group) if group is not None else None


def last_values(state: State, unit: Unit, row: int) -> str:
    """What the parameters of a loop's condition hold, in the user's words; ``row`` is the loop's first or its last line."""
    block = unit.blocks.get(row)
    at = block.close if block is not None and block.kind == "do" and block.close < len(unit.code) else row
    node = unit.document.node(at)
    values = Values(state, Source(unit.file, at, node.text))
    said = {}
    for param in node.find("param"):
        try:
            said[values.said(param)] = values.value(param)()
        except Halt:
            continue
    return f", with {', '.join(f'`{name}` = {value:g}' for name, value in said.items())}" if said else ""
