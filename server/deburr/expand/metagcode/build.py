"""Phase 2 of a MetaGCODE run: the gathered text followed line by line, with values filled in (spec/metagcode.md §5.2 to §5.5)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple, NoReturn

from deburr.arithmetic.metagcode import DECIMALS, MOST_DECIMALS, Counted, number_meant, passes
from deburr.expand.metagcode.lines import Condition, Counter, Directive, Item
from deburr.expand.metagcode.signs import TWO_SIGNS, doubled
from deburr.fault import Entered, Fault, Frame, Halt
from deburr.suggest import suggestion
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.forms import names, number
from deburr_grammar.dialects.metagcode.limits import ALL_PASSES, PASSES
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from decimal import Decimal

    from deburr.expand.job import Job
    from deburr.expand.metagcode.gather import Gathered, Place

_LONG = 60
_UNCLOSED = "block-unclosed"
_VAST = 10**15


class Quantity(NamedTuple):
    """A value that is a number: the item that names it, its text, its value."""

    item: Item
    text: str
    value: Decimal


class Length(NamedTuple):
    """How long a loop is for one of its variables."""

    counter: Counter
    total: Quantity
    size: Quantity
    passes: int


class Loop:
    """A loop that is under way: its head's step, the frame around it, what it counts, and what its variables are behind it."""

    __slots__ = ("count", "counters", "frame", "frames", "head", "number", "outer", "saved")

    def __init__(
        self, head: int, outer: Frame | None, count: int, counters: dict[str, Counted], saved: dict[str, str]
    ) -> None:
        self.head = head
        self.outer = outer
        self.count = count
        self.counters = counters
        self.saved = saved
        self.number = 0
        """The pass, counted from 1."""
        self.frame: Frame | None = None
        self.frames: dict[Place, Frame] = {}
        """The frames of the snippets in this pass."""


class Run:
    """One run over a gathered text. ``unsure``: what it meets proves nothing of real programs."""

    def __init__(self, job: Job, gathered: Gathered, values: dict[str, str], unsure: bool) -> None:
        self._job = job
        job.where = self._where
        job.parts.append(self)
        self._gathered = gathered
        self._values = values
        self._unsure = unsure
        decimals = DECIMALS if job.inputs.decimals is None else job.inputs.decimals
        self._decimals = min(decimals, MOST_DECIMALS)
        self._loops: list[Loop] = []
        self._outside: dict[Place, Frame] = {}
        self._frames = self._outside
        """The frames of snippets in the innermost loop pass, or outside all loops."""
        self._passes = 0

    def steps(self) -> Iterator[None]:
        """Run to the end, in slices of executed lines."""
        steps, emit, filled, held = self._gathered.steps, self._job.emit, self._filled, bool(self._job.held)
        at = left = 0
        while at < len(steps):
            step = steps[at]
            if isinstance(step, Directive):
                if not left:
                    yield
                    left = self._slice(at, step.row)
                left -= 1
                if held:
                    self._come(at, step.row)
                at = self._directive(at, step)
                continue
            file, frame = step.text.file, self._frame(at)
            for row, line in enumerate(step.lines, step.first):
                if not left:
                    yield
                    left = self._slice(at, row)
                left -= 1
                if held:
                    self._come(at, row)
                emit(line if isinstance(line, str) else filled(at, row, line), file, row, frame)
            at += 1

    def _slice(self, at: int, row: int) -> int:
        return self._job.slice(self._gathered.steps[at].text.file, row, self._frame(at))

    def _where(self) -> str:
        """The innermost loop and what it counts, in words."""
        if not self._loops:
            return ""
        loop = self._loops[-1]
        head = self._gathered.steps[loop.head]
        assert isinstance(head, Directive)
        values = " and ".join(f"`|{name}|` = {_short(self._values[name])}" for name in loop.counters)
        return f"pass {loop.number:,} of {loop.count:,} of `{head.said}` with {values}"

    def _filled(self, at: int, row: int, line: tuple[str, ...]) -> str:
        values = self._values
        try:
            text = "".join([values[each] if index & 1 else each for index, each in enumerate(line)])
        except KeyError as missing:
            name = missing.args[0]
            self._undefined(at, row, name, self._reference(at, row, line[1::2].index(name)))
        if TWO_SIGNS.search(text) and (wrong := doubled(line, values)) is not None:
            span = self._reference(at, row, wrong.number)
            message = f"`|{line[1::2][wrong.number]}|` makes `{wrong.word}` here, which is no number; write the sign in the line or in the value, not in both"
            self._halt("double-sign", at, row, span, message)
        return text

    def _reference(self, at: int, row: int, number: int) -> Span:
        """The columns of a reference, counted from 0, in a line."""
        text = self._gathered.steps[at].text.document.line(row)
        start = next(islice(names(text), number, None))[0]
        return Span(start, text.index("|", start + 1) + 1)

    def _directive(self, at: int, step: Directive) -> int:
        """Follow a directive; the step that comes next."""
        opens = step.bracket.role is Role.OPEN
        if step.bracket.kind == "if":
            return at + 1 if not opens or self._holds(at, step, step.condition) else self._end(at, step) + 1
        return self._enter(at, step) if opens else self._again(at)

    def _come(self, at: int, row: int) -> None:
        """Stop at a line whose faults are held."""
        self._job.held.come(self._job, self._gathered.steps[at].text.file, row, self._frame(at), _UNCLOSED)

    def _end(self, at: int, step: Directive) -> int:
        """The step that ends a block, which is asked for: one that is missing or ill-matched stops the run here."""
        end = self._gathered.partners[at]
        if end < 0:
            self._halt(_UNCLOSED, at, step.row, step.bracket.span, f"`{step.said}` is never closed")
        closer = self._gathered.steps[end]
        if self._job.held and isinstance(closer, Directive):
            self._come(end, closer.row)
        return end

    def _holds(self, at: int, step: Directive, asked: Condition) -> bool:
        if asked.numeric:
            left, right = self._number(at, step, asked.left), self._number(at, step, asked.right)
            return asked.holds(left.value, right.value)
        one, two = self._text(at, step, asked.left), self._text(at, step, asked.right)
        if asked.left.is_name or asked.right.is_name:
            self._doubt(at, step, asked, one, two)
        return asked.holds(one, two)

    def _doubt(self, at: int, step: Directive, asked: Condition, one: str, two: str) -> None:
        """What is odd about two texts that are compared; of two that stand in the line the line's rules speak."""
        span = Span(asked.left.span.start, asked.right.span.end)
        if one != two and one.casefold() == two.casefold():
            message = f"{_short(one)} and {_short(two)} are different texts here: upper and lower case count"
            self._meet("alpha-case", at, step.row, span, message)
        if number(one) is not None and number(two) is not None:
            message = f"{_short(one)} and {_short(two)} are compared as text here, character by character; write `n` to compare numbers"
            self._meet("alpha-number", at, step.row, span, message)

    def _enter(self, at: int, step: Directive) -> int:
        """Begin a loop, or pass over it if it has no pass."""
        end = self._end(at, step)
        counted = [self._length(at, step, counter) for counter in step.counters]
        longest = max(counted, key=lambda each: each.passes)
        if not longest.passes:
            message = f"{_here(longest.total)}, so the loop has no pass and its lines are left out"
            self._meet("loop-zero", at, step.row, longest.counter.total.span, message)
            return end + 1
        if longest.passes > PASSES:
            self._halt("limit", at, step.row, longest.counter.total.span, _too_many(longest))
        counters = {
            each.counter.total.said: Counted(each.total.value, longest.passes, self._decimals, each.counter.relative)
            for each in counted
        }
        saved = {name: self._values[name] for name in counters}
        loop = Loop(at, self._frame(at), longest.passes, counters, saved)
        self._loops.append(loop)
        self._pass(loop)
        return at + 1

    def _length(self, at: int, step: Directive, counter: Counter) -> Length:
        total, size = self._number(at, step, counter.total), self._number(at, step, counter.step)
        if not size.value:
            message = f"{_here(size)}; a step of 0 never reaches the total, and the number of passes would be a division by zero"
            self._halt("loop-step-zero", at, step.row, counter.step.span, message)
        if size.value < 0 and counter.step.is_name:
            message = f"{_here(size)}; the sign is ignored, the direction is that of `|{counter.total.said}|`"
            self._meet("loop-step-negative", at, step.row, counter.step.span, message)
        return Length(counter, total, size, passes(total.value, size.value))

    def _again(self, end: int) -> int:
        """At the end of a loop: its next pass, or what follows it."""
        loop = self._loops[-1]
        if loop.number < loop.count:
            self._pass(loop)
            return loop.head + 1
        self._loops.pop()
        self._values.update(loop.saved)
        self._frames = self._loops[-1].frames if self._loops else self._outside
        return end + 1

    def _pass(self, loop: Loop) -> None:
        self._passes += 1
        step = self._gathered.steps[loop.head]
        assert isinstance(step, Directive)
        if self._passes > ALL_PASSES:
            message = f"all loops together make more than {ALL_PASSES:,} passes, last in {self._where()}"
            self._halt("limit", loop.head, step.row, step.bracket.span, message)
        loop.number += 1
        for name, counted in loop.counters.items():
            self._values[name] = counted.printed(loop.number)
        loop.frame = Frame(loop.outer, step.text.file, step.row, Entered.LOOP, loop.number)
        loop.frames = self._frames = {}

    def _frame(self, at: int) -> Frame | None:
        """The innermost loop pass or snippet around a step, whichever was entered last."""
        return self._around(self._gathered.places[at])

    def _around(self, place: Place) -> Frame | None:
        loop = self._loops[-1] if self._loops else None
        if place.outer is None or (loop is not None and loop.head >= place.before):
            return loop.frame if loop is not None else None
        if place not in self._frames:
            self._frames[place] = Frame(self._around(place.outer), place.outer.file, place.row, Entered.FILE, 0)
        return self._frames[place]

    def _text(self, at: int, step: Directive, item: Item) -> str:
        """What an item stands for, without outer blanks."""
        if not item.is_name:
            return item.said
        value = self._values.get(item.said)
        if value is None:
            self._undefined(at, step.row, item.said, item.span)
        return value.strip(" \t")

    def _number(self, at: int, step: Directive, item: Item) -> Quantity:
        text = self._text(at, step, item)
        value = number(text) if item.number is None else item.number
        if value is None:
            message = f"`|{item.said}|` is {_short(text)} here, which is no number, so there is nothing to calculate with{number_meant(text)}"
            self._halt("not-numeric", at, step.row, item.span, message)
        return Quantity(item, text, value)

    def _undefined(self, at: int, row: int, name: str, span: Span) -> NoReturn:
        alike = [each for each in self._values if each.casefold() == name.casefold()]
        hint = f"; did you mean `{alike[0]}`?" if len(alike) == 1 else suggestion(name, self._values)
        given = self._job.inputs.ways.define.format(f"{name}=...")
        message = f"`|{name}|` has no value, and is not taken for empty text; give it one with {given}{hint}"
        self._halt("undefined-variable", at, row, span, message)

    def _fault(self, kind: str, at: int, row: int, span: Span, message: str) -> Fault:
        file = self._gathered.steps[at].text.file
        return Fault(kind, file, row, span, message, self._frame(at), self._unsure)

    def _meet(self, kind: str, at: int, row: int, span: Span, message: str) -> None:
        self._job.meet(self._fault(kind, at, row, span, message))

    def _halt(self, kind: str, at: int, row: int, span: Span, message: str) -> NoReturn:
        raise Halt(self._fault(kind, at, row, span, message))


def _here(quantity: Quantity) -> str:
    """A value in words."""
    text = _short(quantity.text)
    return f"`|{quantity.item.said}|` is {text} here" if quantity.item.is_name else f"the value is {text}"


def _too_many(length: Length) -> str:
    said = f"{length.passes:,}" if length.passes <= _VAST else f"more than {_VAST:,}"
    steps = f"in steps of at most {_short(length.size.text)} that is {said} passes"
    return f"{_here(length.total)}; {steps}, and a loop may make {PASSES:,}"


def _short(text: str) -> str:
    """A value as it is quoted."""
    if not text:
        return "empty"
    return f"`{text}`" if len(text) <= _LONG else f"`{text[:_LONG]}...`"
