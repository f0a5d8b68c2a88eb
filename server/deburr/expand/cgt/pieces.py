"""Items and brackets that stay on a line as closures that put texts on it (spec/cgt.md §5.2, §5.4, §5.7, §5.8). Calls no section, ends no line."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from deburr.expand.cgt.commands import Put, command, numbered, place_of
from deburr.expand.cgt.values import Test, Values
from deburr.expand.cgt.words import Cell
from deburr.templates.items import Body, Item
from deburr.templates.parts import TRAILING, Branch, parts_of

if TYPE_CHECKING:
    from deburr.expand.cgt.events import JobData
    from deburr.expand.cgt.lines import Place
    from deburr.expand.cgt.state import State
    from deburr.fault import Halt
    from deburr.templates.parts import Part
    from deburr.templates.template import Template

_FLOW = frozenset(("call", "exit"))


class Pieces:
    """Compiles what stays on a line."""

    def __init__(self, state: State, template: Template, given: JobData) -> None:
        self._state = state
        self._template = template
        self._given = given
        self._lines: dict[int, Values] = {}

    def values(self, row: int) -> Values:
        """The compiler of a line's values."""
        found = self._lines.get(row)
        if found is None:
            found = self._lines[row] = Values(self._state, self._given, row, self._template.text(row))
        return found

    def stays(self, part: Part) -> bool:
        """Whether a part neither leaves its line nor needs a section to be run first."""
        if isinstance(part, Item):
            return part.kind not in _FLOW and not self.computed(part)
        if isinstance(part, Body):
            return False
        bodies = [body for body in part if body is not None]
        if any(body.opener is None or body.closer is None or body.opener.line != body.closer.line for body in bodies):
            return False
        return not self.computed_tests(part.body) and all(
            self.stays(each) for body in bodies for each in parts_of(body)
        )

    def computed(self, item: Item) -> list[tuple[Cell, Place]]:
        """The words that must be computed before an item is executed."""
        if item.kind == "word":
            cell = self._state.words.find(item.name)
            return [(cell, place_of(item))] if cell is not None and cell.section else []
        if item.node is None or item.kind in ("declaration", "fmt") or item.name == "RESET":
            return []
        return self.values(item.line).computed(item.node)

    def computed_tests(self, body: Body) -> list[tuple[Cell, Place]]:
        """The words that must be computed before a body's test."""
        if body.head is not None:
            return self.computed(body.head)
        found = ((cell, at) for _, cell, at in self._tested(body) if cell.section)
        return list({cell.name: (cell, at) for cell, at in found}.values())

    def sequence(self, parts: Iterable[Part]) -> Put:
        """Parts one after the other."""
        puts = tuple(self._puts(list(parts)))
        if len(puts) == 1:
            return puts[0]

        def put(out: list[str]) -> None:
            for each in puts:
                each(out)

        return put

    def test(self, body: Body) -> Test:
        """Whether a bracket or the body of an `#IF` is output."""
        if body.head is None:
            return self._bracket_test(body)
        node = body.head.node
        assert node is not None
        values = self.values(body.head.line)
        tests = node.node("tests") or node.node("string_tests")
        if tests is not None:
            return values.test(tests)
        words = [(values.cell(part), values.place(part)) for part in node.children if part.kind == "WORD"]
        changed = self._state.changed
        return lambda: any(changed(cell, at) for cell, at in words)

    def halt(self, kind: str, item: Item, message: str, input: bool = False) -> Halt:
        """The end of the run at an item."""
        return self._state.fault(kind, place_of(item), message, input)

    def _puts(self, parts: list[Part]) -> Iterator[Put]:
        at = 0
        while at < len(parts):
            part, behind = parts[at], parts[at + 1] if at + 1 < len(parts) else None
            at += 1
            if isinstance(part, Branch):
                yield self._branch(part)
                continue
            assert isinstance(part, Item)
            if part.kind == "text" and isinstance(behind, Item) and behind.kind == "word":
                at += 1
                yield self._word(behind, part.text)
            elif (put := self._item(part)) is not None:
                yield put

    def _item(self, item: Item) -> Put | None:
        text = item.text
        match item.kind:
            case "text":
                return lambda out: out.append(text)
            case kind if kind == TRAILING:
                return lambda out: out.append(text) if any(out) else None
            case "word":
                return self._word(item, "")
            case "declaration" | "operator":
                return None
            case "onblk":
                return numbered(self._state, item)
            case "head" | "else" | "repeat":
                raise self.halt(*_LOST[item.kind](item))
            case _:
                return command(self._state, self.values(item.line), item)

    def _word(self, item: Item, before: str) -> Put:
        cell, at = self._cell(item), place_of(item)
        shown, lines = self._state.shown, self._state.lines

        def put(out: list[str]) -> None:
            text = cell.text
            if text is None:
                text = shown(cell, at)
            if lines.loud:
                cell.last = text
            out.append(before + text)

        return put

    def _cell(self, item: Item) -> Cell:
        cell = self._state.words.find(item.name) if item.name else None
        if cell is None:
            message = f"`{item.text}` has no value that is known, so the template cannot be expanded"
            raise self.halt("word-unknown", item, message, True)
        return cell

    def _branch(self, branch: Branch) -> Put:
        inside = list(parts_of(branch.body))
        other = self.sequence(parts_of(branch.other)) if branch.other is not None else None
        if other is None and (put := self._lone_word(branch.body, inside)) is not None:
            return put
        test, inner = self.test(branch.body), self.sequence(inside)

        def put_one(out: list[str]) -> None:
            if test():
                inner(out)
            elif other is not None:
                other(out)

        return put_one

    def _lone_word(self, body: Body, inside: list[Part]) -> Put | None:
        """`< X#XPOS>`, which is what most brackets are."""
        items = [part for part in inside if isinstance(part, Item)]
        if (
            body.head is not None
            or len(items) != len(inside)
            or [item.kind for item in items] not in (["text", "word"], ["word"])
        ):
            return None
        item, before = items[-1], items[0].text if len(items) > 1 else ""
        cell, at = self._cell(item), place_of(item)
        shown, lines = self._state.shown, self._state.lines

        def put(out: list[str]) -> None:
            text = cell.text
            if text is None:
                text = shown(cell, at)
            if text != cell.last:
                if lines.loud:
                    cell.last = text
                out.append(before + text)

        return put

    def _tested(self, body: Body) -> Iterator[tuple[bool, Cell, Place]]:
        """The tested words of a bracket, each with whether it must have changed too."""
        both = False
        for item in body.items():
            if item.kind == "operator":
                if item.name == "EXC":
                    return
                both = item.name == "AND"
            elif item.kind == "word":
                yield both, self._cell(item), place_of(item)

    def _bracket_test(self, body: Body) -> Test:
        tested, changed = list(self._tested(body)), self._state.changed
        if not tested:
            return lambda: True
        (_, first, at), *rest = tested
        if not rest:
            return lambda: changed(first, at)

        def found() -> bool:
            result = changed(first, at)
            for both, cell, place in rest:
                also = changed(cell, place)
                result = result and also if both else result or also
            return result

        return found


def _place(item: Item) -> Place:
    return Place(item.line, item.span)


_LOST: dict[str, Callable[[Item], tuple[str, Item, str]]] = {
    "head": lambda item: ("word-unknown", item, f"`{item.text}` is no known word, so the template cannot be expanded"),
    "else": lambda item: ("else-misplaced", item, f"`{item.text}` belongs to no test"),
    "repeat": lambda item: ("repeat-body", item, f"`{item.text}` has no body to repeat"),
}
