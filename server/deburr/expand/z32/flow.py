"""Jumps, returns and calls as closures (spec/z32.md §6.3, §6.4). Looks at no word of a block."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import shown
from deburr.expand.z32.form import judge
from deburr.expand.z32.programs import Programs
from deburr.expand.z32.state import DEEPEST, ELSEWHERE, END, WAITING, Activation, Pending, Place, Return, State
from deburr.fault import Entered, Frame
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from collections.abc import Iterable

    from deburr.expand.z32.fields import Step
    from deburr.expand.z32.unit import Op, Program, Unit
    from deburr.expand.z32.values import Values


class Flow:
    """The flow of one run."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.programs = Programs(state)
        self._judged: set[Unit] = {state.main}
        self._ran_off: set[tuple[str, int]] = set()

    def jump(self, field: Node, row: int, values: Values) -> Step:
        """`GONn` and `GONn-Nm`."""
        part = field.children[1]
        target = self._target(part, row, values, values.place(part), "jump-target-missing")
        end = field.node("range_end")
        if end is not None:
            return self._range(field, row, values, target)
        state = self.state
        straight = state.arrive

        def jumped() -> int:
            to = target()
            if state.loop is not None:
                straight(to)
            return to

        return jumped

    def call(self, field: Node, row: int, values: Values) -> Step:
        """`GOPn` and `GOSn`."""
        part, temporary = field.children[1], field.children[0].kind == "GOS"
        message = "there is no program {}: the number of a program is an integer; the control stops here"
        number = values.integer(part, values.value(part), "program-number", message)
        place, said = values.place(part), values.said(field)
        programs = self.programs

        def called() -> int:
            program = programs.numbered(number(), temporary, place)
            return self._enter(program, row, place, said, Entered.CALL)

        return called

    def file_call(self, field: Node, row: int, values: Values) -> Step:
        """`:L254-` and a path."""
        part, programs = field.children[1], self.programs
        place, path, said = values.place(part), values.said(part), values.said(field)

        def called() -> int:
            return self._enter(programs.file(path, place), row, place, said, Entered.FILE)

        return called

    def back(self, unit: Unit, row: int, part: Node | None) -> Callable[[], int]:
        """G26."""
        state = self.state
        place = Place(unit.file, row, Span(part.start, part.end) if part is not None else Span(0, 0))

        def returned() -> int:
            if not state.calls:
                # What is run here as the main program may be a subprogram; where that is certain, the check says it.
                message = f"`G26` ends a subprogram; in the main program the control stops here{_run_into(unit, row)}"
                raise state.fault("g26-outside", place, message, True)
            return self._leave()

        return returned

    def run_off(self) -> int:
        """The end of the text of the program that runs."""
        state = self.state
        if not state.calls:
            return END
        program, call = state.program, state.calls[-1]
        if (program.unit.file, program.first) not in self._ran_off:
            self._ran_off.add((program.unit.file, program.first))
            self._missing(program, call)
        return self._leave()

    def close(self) -> None:
        """The end of the run: returns that are still pending never happen."""
        state = self.state
        for call in reversed(state.calls):
            self._open(state.pending.all())
            state.pending = call.pending
        self._open(state.pending.all())

    def around(self, unit: Unit, row: int, op: Op) -> Op:
        """A line with what happens besides: a loop starts or has been left there, a jump returns from there."""
        if row in unit.turns:
            op = self._turn(unit, row, op)
        return self._returning(row, op) if row in unit.ends else op

    def _turn(self, unit: Unit, row: int, op: Op) -> Op:
        state, last = self.state, unit.loops.get(row)

        def turned() -> int:
            state.arrive(row)
            if last is not None:
                state.repeat(unit, row, last)
            return op()

        return turned

    def _returning(self, row: int, op: Op) -> Op:
        """The last block of a range. It is run, then the newest return that waits for it happens."""
        state = self.state

        def returned() -> int:
            found = state.pending.take(row)
            if found is None:
                return op()
            calls, waiting = len(state.calls), state.pending.count
            to = op()
            if to == END or len(state.calls) < calls:
                self._open((found,))
                return to
            if len(state.calls) > calls:
                state.calls[-1] = state.calls[-1]._replace(behind=found.behind, loop=found.loop, frame=found.frame)
                return to
            if state.pending.count > waiting:
                state.pending.redirect(found)
                return to
            state.loop, state.frame = found.loop, found.frame
            return found.behind

        return returned

    def _range(self, field: Node, row: int, values: Values, target: Callable[[], int]) -> Step:
        last = field.node("range_end")
        assert last is not None
        state = self.state
        file = values.place(field).file
        place = Place(file, row, Span(last.start + 1, last.end))
        end = self._target(last.children[1], row, values, place, "range-end-missing")
        said = values.said(field)

        def jumped() -> int:
            to, until = target(), end()
            unit = state.program.unit
            if until not in unit.ends:
                unit.ends.add(until)
                unit.code[until] = None
            if state.pending.count == WAITING:
                message = f"{WAITING:,} jumps wait for a return that never comes, the last of them `{said}`"
                raise state.fault("limit", place, message)
            state.pending.push(Return(until, row + 1, state.loop, state.frame, place, said))
            state.frame = Frame(state.frame, file, row, Entered.JUMP, 0)
            state.loop = None
            return to

        return jumped

    def _target(self, part: Node | Token, row: int, values: Values, place: Place, missing: str) -> Callable[[], int]:
        """The line of a block number, looked for in the program that runs."""
        state, get, computed = self.state, values.value(part), part.kind == "angle"
        known: dict[tuple[int, int, float], int] = {}

        def found() -> int:
            program, value = state.program, get()
            key = (program.first, program.last, value)
            to = known.get(key)
            if to is None:
                if len(known) > WAITING:
                    known.clear()
                to = known[key] = self._row_of(program, row, value, computed, place, missing)
            return to

        return found

    def _row_of(self, program: Program, row: int, value: float, computed: bool, place: Place, missing: str) -> int:
        rows = program.unit.rows_of(program, row, value, computed)
        if not rows:
            raise self.state.fault(missing, place, self._missing_number(program, value, missing))
        if len(rows) > 1:
            message = f"{len(rows)} blocks have the number N{shown(value)}; the control may take either"
            raise self.state.fault("jump-target-duplicate", place, message)
        if rows[0] == program.unit.first_line and missing == "jump-target-missing":
            message = f"N{shown(value)} is the first line of the program, where the control does not look; put a line before it"
            self.state.warn("jump-first-line", place, message)
        return rows[0]

    def _missing_number(self, program: Program, value: float, missing: str) -> str:
        from deburr.expand.z32.nearest import meant

        part = "" if program == program.unit.whole else " of this section"
        so = (
            "so the control stops at this jump"
            if missing == "jump-target-missing"
            else "so the program never comes back from this jump"
        )
        inside = [
            number
            for number in program.unit.numbers
            if any(program.first <= row < program.last for row in program.unit.labels[number])
        ]
        return f"no block{part} has the number N{shown(value)}, {so}{meant(inside, value)}"

    def _enter(self, program: Program, row: int, place: Place, said: str, kind: Entered) -> int:
        state = self.state
        if len(state.calls) >= DEEPEST:
            message = f"{DEEPEST} calls are under way already; the control takes no more, a condition must end them"
            raise state.fault("call-depth", place, message)
        frame = Frame(state.frame, place.file, row, kind, 0)
        if program.unit not in self._judged:
            self._judged.add(program.unit)
            judge(state.job, program.unit, frame)
        state.calls.append(Activation(state.program, row + 1, state.loop, state.frame, state.pending, place, said))
        state.program, state.loop, state.frame, state.pending = program, None, frame, Pending()
        state.row = program.first
        return ELSEWHERE

    def _leave(self) -> int:
        state = self.state
        self._open(state.pending.all())
        call = state.calls.pop()
        state.program, state.loop, state.frame, state.pending = call.program, call.loop, call.frame, call.pending
        state.row = call.behind
        return ELSEWHERE

    def _open(self, pending: Iterable[Return]) -> None:
        """Say of each jump that waits for a return that it does not come."""
        for each in pending:
            message = f"the program ended before `{each.said}` came back, so what stands behind this jump was not done"
            self.state.warn("range-open-at-end", each.place, message)

    def _missing(self, program: Program, call: Activation) -> None:
        """Say that a program has no G26: at its last block, or at the call if it stands in another file."""
        if program.unit is not self.state.main:
            message = f"what `{call.said}` calls runs off the end of its file; `G26` is missing there"
            self.state.warn("g26-missing", self._first_call(call), message)
            return
        row = program.unit.last_block(program)
        text = program.unit.document.line(row)
        span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
        message = f"the section that `{call.said}` calls runs off its end; `G26` is missing behind this block"
        self.state.warn("g26-missing", Place(program.unit.file, row, span), message)

    def _first_call(self, call: Activation) -> Place:
        """Where a program says for the first time what a call says."""
        unit = call.program.unit
        for row in unit.rows_with("call", "file_call"):
            node = unit.document.node(row)
            for field in node.find("call", "file_call"):
                if node.text[field.start : field.end] == call.said:
                    part = field.children[1]
                    return Place(unit.file, row, Span(part.start, part.end))
        return call.place


def _run_into(unit: Unit, row: int) -> str:
    """The end of a message on a G26 in a section: the section is a subprogram, into which the main program ran."""
    start = next((at for at in reversed(unit.sections) if at < row), None)
    return (
        f"; it ran on into `{unit.document.line(start).strip()}`, so M30 is missing before that"
        if start is not None
        else ""
    )
