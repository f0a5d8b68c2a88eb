"""Advanced lines as closures: groups of fields between `!` and `!`, each a step (spec/z32.md §6.2). Moves nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import COMPARISONS, to_cartesian, to_polar
from deburr.expand.z32.values import Values
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.z32.flow import Flow
    from deburr.expand.z32.state import State
    from deburr.expand.z32.unit import Op, Unit
    from deburr_grammar.line import LineNode

SKIP = -9
"""What a false IF gives: the run goes on behind the next `!`."""
Step = Callable[[], int | None]
"""A field: it runs and gives the next row, `SKIP`, or None where the next field follows."""


def advanced(flow: Flow, unit: Unit, row: int, node: LineNode) -> Op:
    """An advanced line."""
    fields = Fields(flow, unit, row, node)
    groups = [[fields.step(field) for field in group] for group in _groups(next(node.find("advanced")))]
    return _one_group(groups[0], row + 1) if len(groups) == 1 else _several_groups(groups, row + 1)


class Fields:
    """Compiles the fields of one line."""

    def __init__(self, flow: Flow, unit: Unit, row: int, node: LineNode) -> None:
        self._flow = flow
        self._state: State = flow.state
        self._row = row
        self._text = node.text
        self._values = Values(flow.state, unit.file, row, node.text)

    def step(self, field: Node) -> Step:
        """One field."""
        match field.kind:
            case "if":
                return self._condition(field)
            case "assign":
                return self._assign(field)
            case "jump":
                return self._flow.jump(field, self._row, self._values)
            case "call":
                return self._flow.call(field, self._row, self._values)
            case "file_call":
                return self._flow.file_call(field, self._row, self._values)
            case "polar":
                return self._polar(field)
            case _:
                behind = self._row + 1
                return lambda: behind

    def _condition(self, field: Node) -> Step:
        comparison = field.children[1]
        assert isinstance(comparison, Node)
        left, *signs, right = comparison.children
        relation = "".join(self._text[sign.start : sign.end] for sign in signs)
        holds = COMPARISONS[relation.lower().replace("&lt", "<").replace("&gt", ">")]
        one, two = self._values.value(left), self._values.value(right)
        return lambda: None if holds(one(), two()) else SKIP

    def _assign(self, field: Node) -> Step:
        stored = self._values.store(field.children[0], field.children[2])

        def assigned() -> None:
            stored()

        return assigned

    def _polar(self, field: Node) -> Step:
        """CP and PC calculate with HX, HY, HR and HT."""
        params, part = self._state.params, field.children[0]
        if self._text[part.start].upper() == "P":
            radius, angle = self._values.read("HR", part), self._values.read("HT", part)

            def to_x_and_y() -> None:
                params["HX"], params["HY"] = to_cartesian(radius(), angle())

            return to_x_and_y
        x, y = self._values.read("HX", part), self._values.read("HY", part)

        def to_radius_and_angle() -> None:
            params["HR"], params["HT"] = self._turned(x(), y(), part)

        return to_radius_and_angle

    def _turned(self, x: float, y: float, part: Node | Token) -> tuple[float, float]:
        radius, angle = to_polar(x, y)
        if radius == 0:
            message = f"`{self._values.said(part)}` finds HX and HY at 0, where there is no angle; HR and HT become 0"
            self._state.warn("polar-origin", self._values.place(part), message)
        if radius == float("inf"):
            message = f"`{self._values.said(part)}` has a result beyond the largest number here; the control stops"
            raise self._values.halt("domain", part, message)
        return radius, angle


def _groups(line: Node) -> list[list[Node]]:
    """The fields between `!` and `!`."""
    found: list[list[Node]] = []
    for part in line.children:
        if isinstance(part, Node):
            found[-1].append(part)
        elif part.kind == "BANG":
            found.append([])
    return found


def _one_group(steps: list[Step], behind: int) -> Op:
    def executed() -> int:
        for step in steps:
            found = step()
            if found is not None:
                return behind if found == SKIP else found
        return behind

    return executed


def _several_groups(groups: list[list[Step]], behind: int) -> Op:
    def executed() -> int:
        for group in groups:
            for step in group:
                found = step()
                if found is not None:
                    if found == SKIP:
                        break
                    return found
        return behind

    return executed
