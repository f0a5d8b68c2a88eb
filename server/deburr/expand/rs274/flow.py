"""O-words, calls and returns as closures (spec/rs274.md §6). Looks at no word but M98 and M99."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING

from deburr.expand.rs274.files import loaded
from deburr.expand.rs274.state import ARGUMENTS, Activation, Loop
from deburr.expand.rs274.unit import Block, Op, Unit
from deburr.expand.rs274.values import Get, Values
from deburr.fault import Entered, Frame, Halt
from deburr.suggest import suggestion
from deburr_grammar.dialects.rs274.outline import label_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.rs274.lines import Line
    from deburr.expand.rs274.run import Run
    from deburr_grammar.line import LineNode

ELSEWHERE, END = -1, -2
"""What a line gives instead of the next row: the run goes on in another file or subprogram, or is over."""
DEEPEST = 9
"""Calls that may be active at once (spec/rs274.md §6)."""


class Flow:
    """The flow of one run."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._state = run.state
        self._units: dict[str, Unit | None] = {}
        self._subs: dict[str, tuple[Unit, int]] = {}
        """Subprograms that were passed or found, by label; the first counts, whatever its file."""

    def compiled(self, unit: Unit, row: int, node: LineNode) -> Op:
        """A line with an O-word."""
        o_line = next(node.find("o_line"))
        command = next((part for part in o_line.children if isinstance(part, Token) and part.kind in _COMMANDS), None)
        delete = self._run.job.inputs.block_delete if node.tree.find("DELETE") is not None else False
        if delete is True:
            return lambda: row + 1
        if delete is None:
            raise self._run.undecided(unit, row, node)
        if command is None:
            return lambda: row + 1
        return _COMMANDS[command.kind](self, unit, row, _Parts(self, unit, row, node, o_line))

    def sub(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """A definition in the way is passed over, and known from then on."""
        jump = self._jump(unit, row, unit.ends[row] + 1)

        def passed() -> int:
            if parts.literal is not None:
                self._subs.setdefault(parts.literal, (unit, row))
            return jump()

        return passed

    def endsub(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """The end of the subprogram that runs."""
        return self._back(unit, row, parts.value) if self._state.calls else lambda: row + 1

    def back(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`return`."""
        return self._back(unit, row, parts.value) if self._state.calls else lambda: row + 1

    def call(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """A call with its arguments."""
        arguments, label, state = parts.arguments, parts.label, self._state
        span = parts.span
        if len(arguments) > ARGUMENTS:
            message = f"{len(arguments)} arguments; a subprogram takes at most {ARGUMENTS}"
            raise state.fault("sub-arguments", unit.file, row, span, message)

        def called() -> int:
            values = [get() for get in arguments]
            target, start = self._found(label(), unit, row, span)
            self._activate(unit, row, span, len(values))
            state.params[1 : ARGUMENTS + 1] = values + [0.0] * (ARGUMENTS - len(values))
            state.locals = {}
            state.value = state.value_returned = 0.0
            self._run.unit, self._run.row = target, start + 1
            return ELSEWHERE

        return called

    def branch(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`if`: the first branch whose condition holds."""
        block, condition = self._block(unit, row, parts), parts.value
        assert condition is not None
        others = self._others(unit, block, row)
        start, first = row + 1, self._jump(unit, row, (block.middles or [block.close])[0])
        last = self._behind_else(unit, block)

        def chosen() -> int:
            if condition():
                return start
            first()
            for at, get, skip in others:
                if get():
                    return at + 1
                skip()
            return last

        return chosen

    def other_branch(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`elseif` or `else` behind a branch that ran: the control still calculates the conditions that follow."""
        block = self._block(unit, row, parts)
        conditions = [get for _, get, _ in self._others(unit, block, row - 1)]
        jump = self._jump(unit, row, block.close + 1)

        def passed() -> int:
            for get in conditions:
                get()
            return jump()

        return passed

    def nothing(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """A line that only marks a place."""
        return lambda: row + 1

    def loop(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`while`, which opens a loop or ends a `do`."""
        block, condition = self._block(unit, row, parts), parts.value
        assert condition is not None
        if block.open != row:
            return self._end_of_do(unit, row, block, condition)
        state, leave = self._state, self._jump(unit, row, block.close + 1)

        def tested() -> int:
            if not state.loops or state.loops[-1].first != row:
                state.loops.append(Loop(row, state.frame))
                passes = 0
            else:
                passes = state.frame.number if state.frame is not None else 0
            outer = state.loops[-1].outer
            if condition():
                state.frame = Frame(outer, unit.file, row, Entered.LOOP, passes + 1)
                return row + 1
            state.loops.pop()
            state.frame = outer
            return leave()

        return tested

    def end_of_while(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """Back to the test."""
        first = self._block(unit, row, parts).open
        return lambda: first

    def do(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """The first pass of a loop that is tested at its end."""
        state = self._state

        def entered() -> int:
            state.loops.append(Loop(row, state.frame))
            state.frame = Frame(state.frame, unit.file, row, Entered.LOOP, 1)
            return row + 1

        return entered

    def repeat(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """A counted loop; the count is rounded half to even."""
        block, count, state = self._block(unit, row, parts), parts.value, self._state
        assert count is not None
        leave = self._jump(unit, row, block.close + 1)

        def entered() -> int:
            times = round(count())
            if times <= 0:
                return leave()
            state.loops.append(Loop(row, state.frame, times - 1))
            state.frame = Frame(state.frame, unit.file, row, Entered.LOOP, 1)
            return row + 1

        return entered

    def end_of_repeat(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """The next pass, if there is one left."""
        first, state = self._block(unit, row, parts).open, self._state

        def ended() -> int:
            _, outer, left = loop = state.loops.pop()
            if not left:
                state.frame = outer
                return row + 1
            passes = state.frame.number + 1 if state.frame is not None else 1
            state.loops.append(loop._replace(left=left - 1))
            state.frame = Frame(outer, unit.file, first, Entered.LOOP, passes)
            return first + 1

        return ended

    def leave(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`break`: out of the loop of that label; the condition of a `do` is still calculated."""
        target = self._loop_of(unit, row, parts)
        jump = self._jump(unit, row, target.close + 1)
        ending = self._condition(unit, target.close) if target.kind == "do" else None
        state = self._state

        def left() -> int:
            while (loop := state.loops.pop()).first != target.open:
                pass
            state.frame = loop.outer
            if ending is not None:
                ending()
            return jump()

        return left

    def go_on(self, unit: Unit, row: int, parts: _Parts) -> Op:
        """`continue`: the test of the loop of that label."""
        target = self._loop_of(unit, row, parts)
        to = target.close if target.kind == "do" else target.open
        state = self._state

        def skipped() -> int:
            while state.loops[-1].first != target.open:
                state.frame = state.loops.pop().outer
            return to

        return skipped

    def numbered_call(self, unit: Unit, row: int, line: Line) -> Op:
        """`M98 Pn Ln`: a program that shares all parameters with its caller."""
        words = {word.letter: word.get for word in line.words if word.letter in "PL"}
        pieces = line.pieces(frozenset(("M98", "P", "L")), self._run.job.inputs.keep_n)
        before = self._run.written(unit, row, line, pieces, row)
        span, state = Span(0, len(line.node.text.rstrip())), self._state

        def called() -> int:
            before()
            number, times = round(words["P"]()), round(words["L"]()) if "L" in words else 1
            if times <= 0:
                return row + 1
            target, start = self._numbered(str(number), unit, row, span)
            self._activate(unit, row, span, 0)
            state.calls[-1].again = (target, start, times - 1)
            self._run.unit, self._run.row = target, start + 1
            return ELSEWHERE

        return called

    def numbered_end(self, unit: Unit, row: int, line: Line) -> Op:
        """`M99`: back, or once more."""
        pieces = line.pieces(frozenset(("M99",)), self._run.job.inputs.keep_n)
        before = self._run.written(unit, row, line, pieces, row)
        state = self._state

        def ended() -> int:
            before()
            again = state.calls[-1].again
            if again is not None and again[2]:
                target, start, left = again
                state.calls[-1].again = (target, start, left - 1)
                self._run.unit, self._run.row = target, start + 1
                return ELSEWHERE
            return self._return(unit, row)

        return ended

    def _return(self, unit: Unit, row: int) -> int:
        state = self._state
        if state.restores:
            self._run.job.emit("M72", unit.file, row, state.frame)
        call = state.calls.pop()
        if call.again is None:
            state.params[1 : ARGUMENTS + 1] = call.arguments
            state.locals = call.locals
        state.loops, state.frame, state.restores = call.loops, call.frame, call.restores
        self._run.unit, self._run.row = call.unit, call.row + 1
        return ELSEWHERE

    def _back(self, unit: Unit, row: int, value: Get | None) -> Op:
        state = self._state

        def returned() -> int:
            if value is not None:
                state.value, state.value_returned = value(), 1.0
            return self._return(unit, row)

        return returned

    def _activate(self, unit: Unit, row: int, span: Span, count: int) -> None:
        state = self._state
        if len(state.calls) >= DEEPEST:
            message = f"{DEEPEST} calls are active already; the control takes no more"
            raise state.fault("sub-depth", unit.file, row, span, message)
        state.calls.append(Activation(unit, row, state))
        state.loops, state.restores = [], False
        state.frame = Frame(state.frame, unit.file, row, Entered.CALL, count)

    def _found(self, label: str, unit: Unit, row: int, span: Span) -> tuple[Unit, int]:
        """The subprogram of a label: one that is known, that of a file of its name, or one further on in this file."""
        found = self._subs.get(label)
        for known in (self._load(label), unit) if found is None else ():
            if known is not None and label in known.subs:
                found = self._subs[label] = known, known.subs[label]
                break
        if found is None:
            message = f"there is no subprogram `o<{label}>`, neither here nor in a file `{label}.ngc`"
            message += suggestion(label, {*self._subs, *unit.subs})
            raise self._state.fault("sub-unknown", unit.file, row, span, message)
        self._sound(*found)
        return found

    def _numbered(self, label: str, unit: Unit, row: int, span: Span) -> tuple[Unit, int]:
        """The program that M98 means: in this file, or in one of its number."""
        for known in (unit, self._load(label)):
            if known is not None and label in known.numbered:
                return known, known.numbered[label]
            if known is not None and label in known.subs:
                return known, known.subs[label]
        message = f"there is no program `O{label}`, neither here nor in a file `{label}.ngc`"
        raise self._state.fault("sub-unknown", unit.file, row, span, message)

    def _load(self, label: str) -> Unit | None:
        """The file of a label, read when it is first asked for."""
        if label not in self._units:
            self._units[label] = loaded(self._run.job, label)
        return self._units[label]

    def _sound(self, unit: Unit, row: int) -> None:
        """Stop where a subprogram in another file is wrong as it stands; the program itself has been checked before."""
        if unit is self._run.main:
            return
        for at, finding in unit.errors(self._run.job).items():
            if row <= at <= unit.ends.get(row, row):
                place = finding.place
                raise self._state.fault(
                    finding.rule.partition(".")[2], unit.file, at, Span(place.col, place.end_col), finding.message
                )

    def _jump(self, unit: Unit, row: int, to: int) -> Op:
        """A way past lines that do not run. The control calculates what `return` and `endsub` in them give, undefined names excepted."""
        skipped = [get for at in unit.skipped_returns(row, to) if (get := self._optional(unit, at)) is not None]
        if not skipped:
            return lambda: to

        def jumped() -> int:
            for get in skipped:
                try:
                    get()
                except Halt as halt:
                    if halt.fault.kind != "named-undefined":
                        raise
            return to

        return jumped

    def _optional(self, unit: Unit, row: int) -> Get | None:
        node = unit.document.node(row)
        group = next((part for o_line in node.find("o_line") for part in o_line.nodes() if part.kind == "group"), None)
        return Values(self._state, unit.file, row, node.text).value(group) if group is not None else None

    def _condition(self, unit: Unit, row: int) -> Get:
        found = self._optional(unit, row)
        assert found is not None, "a condition is part of the grammar"
        return found

    def _others(self, unit: Unit, block: Block, behind: int) -> list[tuple[int, Get, Op]]:
        """The `elseif` lines of a block below a row: where they stand, their conditions, and the way to what follows them."""
        rows = [row for row in block.middles if row > behind]
        return [
            (row, self._condition(unit, row), self._jump(unit, row, following))
            for row, following in pairwise([*rows, block.close])
            if "ELSEIF" in unit.document.node(row).kinds
        ]

    def _behind_else(self, unit: Unit, block: Block) -> int:
        last = block.middles[-1] if block.middles else block.close
        is_else = last != block.close and "ELSEIF" not in unit.document.node(last).kinds
        return last + 1 if is_else else block.close + 1

    def _end_of_do(self, unit: Unit, row: int, block: Block, condition: Get) -> Op:
        state = self._state

        def tested() -> int:
            outer = state.loops[-1].outer
            if condition():
                passes = state.frame.number + 1 if state.frame is not None else 1
                state.frame = Frame(outer, unit.file, block.open, Entered.LOOP, passes)
                return block.open + 1
            state.loops.pop()
            state.frame = outer
            return row + 1

        return tested

    def _block(self, unit: Unit, row: int, parts: _Parts) -> Block:
        """The block that a line is part of. Only a program whose faults were not heeded has lines without one."""
        block = unit.blocks.get(row)
        if block is None:
            message = f"`{parts.said}` belongs to no block; the control stops here"
            raise self._state.fault("o-unopened", unit.file, row, parts.span, message)
        return block

    def _loop_of(self, unit: Unit, row: int, parts: _Parts) -> Block:
        label = parts.literal
        for block in unit.blocks[row].outward() if row in unit.blocks else ():
            if block.kind in ("while", "do") and (label is None or block.label in (None, label)):
                return block
        message = f"no `while` or `do` of that label is open around `{parts.said}`"
        raise self._state.fault("break-target", unit.file, row, parts.span, message)


class _Parts:
    """What stands on a line with an O-word."""

    def __init__(self, flow: Flow, unit: Unit, row: int, node: LineNode, o_line: Node) -> None:
        values = Values(flow._state, unit.file, row, node.text)
        groups = [part for part in o_line.nodes() if part.kind == "group"]
        self.arguments: list[Get] = [values.value(group) for group in groups]
        self.value: Get | None = self.arguments[0] if self.arguments else None
        label = o_line.node("label")
        assert label is not None
        self.literal = label_of(node.text, label)
        self.span = Span(o_line.start, o_line.end)
        self.said = node.text[o_line.start : o_line.end]
        self.label: Callable[[], str] = self._label(values, label)

    def _label(self, values: Values, label: Node) -> Callable[[], str]:
        if (literal := self.literal) is not None:
            return lambda: literal
        number = values.integer(label.children[0], "o-label-integer")
        return lambda: str(number())


_COMMANDS: dict[str, Callable[[Flow, Unit, int, _Parts], Op]] = {
    "SUB": Flow.sub,
    "ENDSUB": Flow.endsub,
    "RETURN": Flow.back,
    "CALL": Flow.call,
    "IF": Flow.branch,
    "ELSEIF": Flow.other_branch,
    "ELSE": Flow.other_branch,
    "ENDIF": Flow.nothing,
    "WHILE": Flow.loop,
    "ENDWHILE": Flow.end_of_while,
    "DO": Flow.do,
    "REPEAT": Flow.repeat,
    "ENDREPEAT": Flow.end_of_repeat,
    "BREAK": Flow.leave,
    "CONTINUE": Flow.go_on,
}
