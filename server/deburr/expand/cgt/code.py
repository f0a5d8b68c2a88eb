"""Sections as operations: lines, branches, loops, calls (spec/cgt.md §5.3 to §5.6, §11, *Lines*). Calculates nothing itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic.cgt import equal
from deburr.expand.cgt.commands import Put, place_of
from deburr.expand.cgt.lines import Place
from deburr.expand.cgt.state import END, Label, Loop, Op, Unit
from deburr.fault import Entered, Frame
from deburr.templates.items import DEEPEST, Body, Item, Section
from deburr.templates.parts import Branch, by_line, first_line, last_line, parts_of, starts_with_break
from deburr.templates.template import target

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deburr.expand.cgt.pieces import Pieces
    from deburr.expand.cgt.state import State
    from deburr.expand.cgt.words import Cell
    from deburr.templates.parts import Part

PASSES = 100_000
"""Passes that one `#REPEAT` may make (spec/cgt.md §8)."""


class Compiler:
    """Compiles one section."""

    def __init__(self, state: State, pieces: Pieces, section: Section, is_called: bool) -> None:
        self._state = state
        self._lines = state.lines
        self._pieces = pieces
        self._section = section
        self._is_called = is_called
        self._unit = Unit(section.name)
        self._row = section.line
        self._loops = 0
        self._faulty: set[int] = set()
        """Rows with faults at which nothing stops yet."""
        self._waiting: list[list[Label]] = []
        """Where `#EXITC` comes back to, by the bodies around: the next template line of the innermost that has one."""

    def unit(self) -> Unit:
        """The section as operations."""
        self._body(self._section.body, False)
        self._op(self._state.back)
        return self._unit

    def reached(self, rows: range) -> Unit:
        """The same of a section with faults that are held: each stops the run at its line; where no line is run, at the section."""
        job, file = self._state.job, self._state.file
        self._faulty = {row for row, found in job.held.in_file(file).items() if found and row in rows}
        unit = self.unit()
        if self._faulty:
            job.held.come(job, file, min(self._faulty), self._lines.frame)
        return unit

    def _stops(self, parts: Sequence[Part]) -> bool:
        """Whether the run ends at these parts, because a line on which one begins has faults."""
        at = next((first_line(part) for part in parts if first_line(part) in self._faulty), None)
        if at is None:
            return False
        self._row = at
        state, row, file = self._state, at, self._state.file

        def stopped() -> int:
            state.job.held.come(state.job, file, row, state.lines.frame)
            return END

        self._op(stopped)
        self._faulty -= set(range(first_line(parts[0]), last_line(parts[-1]) + 1))
        return True

    def _op(self, op: Op) -> int:
        """Add an operation; its number."""
        self._unit.ops.append(op)
        self._unit.rows.append(self._row)
        return len(self._unit.ops) - 1

    @property
    def _next(self) -> int:
        """The number of the next operation."""
        return len(self._unit.ops)

    def _body(self, body: Body, is_repeat: bool) -> None:
        """What stands in a body, with its line breaks; the ones directly behind `<` and before `>` end no line."""
        self._check(body)
        self._waiting.append([])
        opener = body.opener.line if body.opener is not None else None
        line, quiet = opener, 1
        for parts in by_line(parts_of(body)):
            first = first_line(parts[0])
            if line is not None and first > line:
                self._break(first, opener is not None and first - line <= quiet)
            self._line(parts, first, opener)
            line, quiet = last_line(parts[-1]), 0
        if body.closer is not None and line is not None and body.closer.line > line:
            self._break(body.closer.line, body.closer.line - line <= quiet + 1)
        elif opener is None and line is not None:
            self._break(line, False)
        left = self._waiting.pop()
        if self._waiting:
            self._waiting[-1] += left
        else:
            self._resolve(left)
        if is_repeat and starts_with_break(body):
            self._op(self._flushing())

    def _break(self, row: int, silent: bool) -> None:
        """The end of a template line."""
        self._resolve(self._waiting[-1])
        self._waiting[-1].clear()
        if not silent:
            self._op(self._flushing())
        self._row = row

    def _resolve(self, labels: Sequence[Label]) -> None:
        for label in labels:
            label.at, label.loops = self._next, self._loops

    def _flushing(self) -> Op:
        flush, behind = self._lines.flush, self._next + 1

        def ended() -> int:
            flush()
            return behind

        return ended

    def _line(self, parts: list[Part], row: int, opener: int | None) -> None:
        """The parts of one line of a body that opens on a line, or of the section itself."""
        if self._faulty and self._stops(parts):
            return
        self._row = row
        if opener is None and all(self._pieces.stays(part) for part in parts):
            self._op(self._whole_line(self._pieces.sequence(parts), row))
            return
        if row != opener:
            self._op(self._counted())
        self._parts(parts)

    def _whole_line(self, put: Put, row: int) -> Op:
        state, write, behind = self._state, self._lines.write, self._next + 1

        def line() -> int:
            state.left -= 1
            out: list[str] = []
            put(out)
            if out:
                write(out, row)
            return behind

        return line

    def _counted(self) -> Op:
        """A step, where a line is executed in pieces."""
        state, behind = self._state, self._next + 1

        def counted() -> int:
            state.left -= 1
            return behind

        return counted

    def _parts(self, parts: Sequence[Part]) -> None:
        """Parts on one line, those that stay on it together."""
        staying: list[Part] = []
        for part in parts:
            if self._pieces.stays(part):
                staying.append(part)
                continue
            self._put(staying)
            staying = []
            self._row = first_line(part)
            if isinstance(part, Branch):
                self._branch(part)
            elif isinstance(part, Body):
                self._repeat(part)
            else:
                self._item(part)
        self._put(staying)

    def _put(self, parts: Sequence[Part]) -> None:
        if not parts:
            return
        put, lines, row, behind = self._pieces.sequence(parts), self._lines, self._row, self._next + 1

        def done() -> int:
            lines.begin(row)
            put(lines.out)
            return behind

        self._op(done)

    def _item(self, item: Item) -> None:
        place = place_of(item)
        state = self._state
        if item.kind == "call":
            name, span = target(item)
            self._call(item, name, Place(item.line, span))
        elif item.kind == "exit" and item.name == "EXIT":
            self._leave(state.exit)
        elif item.kind == "exit":
            self._leave(lambda: state.exit_called(place, self._is_called))
        else:
            self._compute(self._pieces.computed(item))
            self._put([item])

    def _leave(self, leave: Callable[[], int]) -> None:
        flush = self._lines.flush

        def left() -> int:
            flush()
            return leave()

        self._op(left)

    def _call(self, item: Item, name: str, at: Place) -> None:
        """What was put together before a call is a line of its own."""
        state, back, label = self._state, self._next + 1, Label()
        if item.name == "GOTO":
            self._leave(lambda: state.go_to(name, at))
            return
        self._waiting[-1].append(label)
        self._leave(lambda: state.call(name, at, back, label))

    def _compute(self, cells: Sequence[tuple[Cell, Place]]) -> None:
        for cell, at in cells:
            self._op(self._computing(cell, at))

    def _computing(self, cell: Cell, at: Place) -> Op:
        state, back = self._state, self._next + 1
        return lambda: state.compute(cell, at, back)

    def _branch(self, branch: Branch) -> None:
        """A bracket or an `#IF` that holds more than stays on its line."""
        self._compute(self._pieces.computed_tests(branch.body))
        test, other, end = self._pieces.test(branch.body), Label(), Label()
        inside = self._next + 1
        self._op(lambda: inside if test() else other.at)
        self._body(branch.body, False)
        if branch.other is not None:
            self._op(lambda: end.at)
        other.at = self._next
        if branch.other is not None:
            self._body(branch.other, False)
        end.at = self._next

    def _repeat(self, body: Body) -> None:
        head = body.head
        if body.kind != "repeat" or head is None or head.node is None:
            kind = "else-misplaced" if body.kind == "else" else "word-unknown"
            assert body.opener is not None
            raise self._pieces.halt(
                kind, head or body.opener, f"`{(head or body.opener).text}` cannot be run here", kind == "word-unknown"
            )
        self._compute(self._pieces.computed(head))
        state, lines, end = self._state, self._lines, Label()
        count, row, inside = self._count(head), head.line, self._next + 1

        def entered() -> int:
            passes = count()
            if not passes:
                return end.at
            state.loops.append(Loop(row, head.text, passes, lines.frame))
            lines.frame = Frame(lines.frame, state.file, row, Entered.LOOP, 1)
            return inside

        self._op(entered)
        self._loops += 1
        self._body(body, True)
        self._loops -= 1
        self._op(self._again(row, inside, place_of(head)))
        end.at = self._next

    def _again(self, row: int, inside: int, at: Place) -> Op:
        state, lines, behind = self._state, self._lines, self._next + 1

        def again() -> int:
            state.left -= 1
            loop = state.loops[-1]
            if loop.number == loop.count:
                state.loops.pop()
                lines.frame = loop.outer
                return behind
            if lines.out:
                lines.grown(at)
            loop.number += 1
            lines.frame = Frame(loop.outer, state.file, row, Entered.LOOP, loop.number)
            return inside

        return again

    def _count(self, head: Item) -> Callable[[], int]:
        """How often a body is repeated."""
        assert head.node is not None
        values, part = self._pieces.values(head.line), head.node.children[2]
        get = values.number(part)

        def found() -> int:
            value = get()
            passes = round(value)
            if passes < 0 or not equal(value, passes):
                message = f"`{values.said(part)}` is {value:g} here; a whole number from 0 on is needed"
                raise values.halt("repeat-count", part, message)
            if passes > PASSES:
                raise values.halt(
                    "limit", part, f"`{values.said(part)}` asks for {passes:,} passes; {PASSES:,} are the limit"
                )
            return passes

        return found

    def _check(self, body: Body) -> None:
        """What a check of the template has seen is wrong all the same where its rules are off."""
        if body.opener is None:
            return
        if body.closer is None:
            raise self._pieces.halt("bracket-unclosed", body.opener, "this bracket is not closed")
        if body.depth > DEEPEST:
            message = f"this bracket stands {body.depth} deep; {DEEPEST} are the limit"
            raise self._pieces.halt("limit", body.opener, message)
