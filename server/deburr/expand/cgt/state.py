"""What a template's run is in: sections that run, loops, formats, and what words print now. Reads no template line."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from deburr.arithmetic.cgt import equal
from deburr.expand.cgt.figures import Format, free
from deburr.expand.cgt.lines import Lines, Place
from deburr.fault import Entered, Fault, Frame, Halt

if TYPE_CHECKING:
    from deburr.expand.cgt.words import Cell, Words
    from deburr.expand.job import Job

Op = Callable[[], int]
"""An operation: it runs and gives the number of the next one."""
END = -1
"""What an operation gives when the section that the generator ran is over."""
DEEPEST = 64
"""Calls that may be active at once (spec/cgt.md §8)."""
_SETS = {
    "FEED": "FEDRAT",
    "SPEED": "SPINDL",
    "SPNDL": "SPINDL",
    "TOOL": "LOADTL",
    "NTOOL": "LOADTL",
    "COOLNT": "COOLNT",
    "DCOMP": "CUTCOM",
    "DOFF": "CUTCOM",
    "CYCLE": "CYCLE",
    "UNITS": "UNITS",
    "FILE": "PARTNO",
    "DWELL": "DELAY",
    **dict.fromkeys(("MOV", "XPOS", "YPOS", "ZPOS", "XST", "YST", "ZST"), "GOTO"),
    **dict.fromkeys(("XCTR", "YCTR", "ZCTR", "ARAD"), "CIRCLE"),
}
"""The statements of CL text that set words."""


class Label:
    """A place in the code that is known when what stands before it is compiled; ``loops``: in so many loops it stands."""

    __slots__ = ("at", "loops")

    def __init__(self) -> None:
        self.at = END
        self.loops = 0


class Unit:
    """A section as operations. ``rows``: the template row of each."""

    __slots__ = ("name", "ops", "rows")

    def __init__(self, name: str) -> None:
        self.name = name
        self.ops: list[Op] = []
        self.rows: list[int] = []


class Loop:
    """A `#REPEAT` that runs: where it stands, how often it runs, the pass that it is in, and the frame around it."""

    __slots__ = ("count", "number", "outer", "row", "said")

    def __init__(self, row: int, said: str, count: int, outer: Frame | None) -> None:
        self.row = row
        self.said = said
        self.count = count
        self.number = 1
        self.outer = outer


class Activation:
    """A section that runs, and what goes on when it ends. ``said``: where `#EXITC` goes on; None if nothing called it. ``cell``: the word that it computes."""

    __slots__ = (
        "back",
        "begun",
        "caller",
        "cell",
        "formats",
        "frame",
        "inside",
        "loops",
        "loud",
        "out",
        "returned",
        "row",
        "said",
    )

    def __init__(self, state: State, back: int, said: Label | None, inside: Frame | None, cell: Cell | None) -> None:
        lines = state.lines
        self.caller = state.unit
        self.back = back
        self.said = said
        self.loops = state.loops
        self.frame = lines.frame
        self.inside = inside
        self.cell = cell
        self.out, self.row, self.begun, self.loud = lines.out, lines.row, lines.begun, lines.loud
        self.returned: float | str = "" if cell is not None and cell.is_text else 0.0
        self.formats: list[tuple[Cell | str, Format | None]] | None = []
        """Formats to be restored when it ends; None where they are kept."""


class State:
    """All of it; operations and values read and write here."""

    def __init__(self, job: Job, file: str, words: Words, unit_of: Callable[[str], Unit | None]) -> None:
        self.job = job
        self.file = file
        self.words = words
        self.lines = Lines(job, file)
        self.unit_of = unit_of
        self.left = 0
        """Steps until the run is left for a moment."""
        self.unit = Unit("")
        self.loops: list[Loop] = []
        self.calls: list[Activation] = []
        self.macros: dict[str, tuple[str, object]] = {}
        """Macro variables: the command that set each, which is its type, and its value."""

    def fault(self, kind: str, at: Place, message: str, input: bool = False) -> Halt:
        """The end of the run."""
        return Halt(Fault(kind, self.file, at.row, at.span, message, self.lines.frame, input))

    def warn(self, kind: str, at: Place, message: str) -> None:
        """Something that the run passes."""
        self.job.meet(Fault(kind, self.file, at.row, at.span, message, self.lines.frame))

    # What words print.

    def shown(self, cell: Cell, at: Place) -> str:
        """What a word prints now; it is kept until the word or its format changes."""
        value = cell.value
        if value is None:
            raise self.unset(cell, at)
        if isinstance(value, str):
            text = value
        elif cell.type == "table":
            text = self._row(cell, value, at)
        else:
            text = self.figures(cell.name, self.words.printed(cell), value, at)
        cell.text = text
        return text

    def changed(self, cell: Cell, at: Place) -> bool:
        """Whether a word would print something else than it did last; one that was never output, was reset or has no value counts as changed."""
        if cell.last is None or cell.value is None:
            return True
        return cell.last != (cell.text if cell.text is not None else self.shown(cell, at))

    def figures(self, name: str, form: Format | None, value: float, at: Place) -> str:
        """A number in a format."""
        if form is None:
            return free(value)
        if (text := form.quick(value)) is not None:
            return text
        digits = form.digits(value)
        if len(digits.whole) > form.before:
            message = f"`#{name}` is {free(value)} here, which needs {len(digits.whole)} digits before the point; its format has {form.before}"
            raise self.fault("format-overflow", at, message)
        if digits.negative and form.sign == "!":
            self.warn("format-unsigned", at, f"`#{name}` is {free(value)} here, and its format prints no minus")
        return form.text(digits)

    def row_of(self, name: str, rows: Sequence[str], value: float, at: Place) -> str:
        """A row of a table by its number from 0 on."""
        number = round(value)
        if equal(value, number) and 0 <= number < len(rows):
            return rows[number]
        has = f"rows 0 to {len(rows) - 1}" if rows else "no rows"
        raise self.fault("table-index", at, f"row {value:g} of `@{name}` is asked for here; it has {has}")

    def unset(self, cell: Cell, at: Place) -> Halt:
        """The end of the run at a word that nothing has set."""
        statement = _SETS.get(cell.name)
        way = f"a `{statement}` before it in the toolpath, or " if statement else ""
        given = self.job.inputs.ways.define.format(f"{cell.name}=VALUE")
        message = f"nothing has set `#{cell.name}` here; {way}{given} gives it a value"
        return self.fault("word-unset", at, message, True)

    def _row(self, cell: Cell, value: float, at: Place) -> str:
        rows = self.words.codes(cell)
        return self.row_of(cell.name, rows, value, at) if rows is not None else ""

    # Sections and what they are in.

    def start(self, unit: Unit, frame: Frame | None, declares: bool) -> int:
        """Run a section that the generator runs. ``declares``: it outputs nothing, and its formats stay."""
        first = self._enter(unit, END, None, frame, None)
        if declares:
            self.calls[-1].formats = None
        self.lines.silence(not declares)
        return first

    def call(self, name: str, at: Place, back: int, said: Label) -> int:
        """`#CALL`."""
        unit = self._target(name, at)
        self._deep(name, at)
        return self._enter(unit, back, said, Frame(self.lines.frame, self.file, at.row, Entered.CALL, 0), None)

    def compute(self, cell: Cell, at: Place, back: int) -> int:
        """Run the section that computes a word; its lines are not output."""
        unit = self._target(cell.section, at)
        self._deep(cell.section, at)
        frame = Frame(self.lines.frame, self.file, at.row, Entered.CALL, 0)
        first = self._enter(unit, back, None, frame, cell)
        self.lines.out = []
        self.lines.silence(False)
        return first

    def go_to(self, name: str, at: Place) -> int:
        """`#GOTO`: another section in place of the one that runs, which counts as ended when that one ends."""
        self.unit = self._target(name, at)
        self.loops = []
        self.lines.frame = Frame(self.calls[-1].inside, self.file, at.row, Entered.JUMP, 0)
        return 0

    def back(self) -> int:
        """The end of the section that runs."""
        ended, lines = self.calls.pop(), self.lines
        for target, form in reversed(ended.formats or ()):
            self.words.give(target, form)
        self.unit, self.loops, lines.frame = ended.caller, ended.loops, ended.frame
        if ended.cell is not None:
            ended.cell.set(ended.returned)
            lines.out, lines.row, lines.begun = ended.out, ended.row, ended.begun
            lines.silence(ended.loud)
        return ended.back

    def exit(self) -> int:
        """`#EXIT`: the whole section that the generator ran, or the one that computes a word, is over."""
        while self.calls[-1].said is not None:
            self.back()
        return self.back()

    def exit_called(self, at: Place, is_called: bool) -> int:
        """`#EXITC`: on behind the line of the call. Without a call it is `#EXIT`; ``is_called``: elsewhere the section has one."""
        said = self.calls[-1].said
        if said is None:
            if is_called:
                message = f"`@{self.unit.name}` was not called here, so `#EXITC` ends it as `#EXIT` does"
                self.warn("exitc-outside-call", at, message)
            return self.exit()
        self.back()
        while len(self.loops) > said.loops:
            self.lines.frame = self.loops.pop().outer
        return said.at

    def form(self, target: Cell | str, form: Format) -> None:
        """`#FMT`: until the section that gives it ends."""
        kept = self.calls[-1].formats
        before = self.words.give(target, form)
        if kept is not None:
            kept.append((target, before))

    def returned(self, value: float | str, at: Place) -> None:
        """`#RETNUM` and `#RETSTR`: the value of the word that is being computed."""
        computing = next((each for each in reversed(self.calls) if each.cell is not None), None)
        if computing is None or computing.cell is None:
            return
        if isinstance(value, str) and not computing.cell.is_text:
            raise self.fault("eval-type", at, f"`#{computing.cell.name}` is a number, and `#RETSTR` gives it a text")
        computing.returned = value

    def where(self) -> str:
        """The innermost loop or jump, in the user's words."""
        if self.loops:
            loop = self.loops[-1]
            return f"pass {loop.number:,} of {loop.count:,} of `{loop.said}` in line {loop.row + 1}"
        frame = self.lines.frame
        jumped = frame is not None and frame.kind is Entered.JUMP
        return (
            f"`@{self.unit.name}`, reached by `#GOTO`" if jumped else f"`@{self.unit.name}`" if self.unit.name else ""
        )

    def _enter(self, unit: Unit, back: int, said: Label | None, frame: Frame | None, cell: Cell | None) -> int:
        self.calls.append(Activation(self, back, said, frame, cell))
        self.unit, self.loops, self.lines.frame = unit, [], frame
        return 0

    def _target(self, name: str, at: Place) -> Unit:
        unit = self.unit_of(name)
        if unit is None:
            raise self.fault("section-missing", at, f"there is no section `@{name}` to run")
        return unit

    def _deep(self, name: str, at: Place) -> None:
        if len(self.calls) > DEEPEST:
            message = f"`@{name}` would be call {DEEPEST + 1} inside each other; {DEEPEST} are the limit, so sections that call each other without end stop here"
            raise self.fault("limit", at, message)
