"""ISO blocks as closures: words are calculated and stored from left to right, and what is left of the block is written (spec/z32.md §6.1, §6.7)."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.z32 import constant
from deburr.expand.z32.state import END, Place
from deburr.expand.z32.values import Values
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.z32.state import State
    from deburr.expand.z32.unit import Op, Unit
    from deburr.fault import Halt
    from deburr_grammar.line import LineNode

_BLANKS = re.compile(r"[ \t]*")
_ENDS = (2.0, 30.0)
"""M2 and M30."""


class Stored(NamedTuple):
    """A literal word of an axis or of the system: what it stores and how it is written."""

    name: str
    value: float
    text: str


Piece = str | Stored | Callable[[], str]


class Block:
    """What an ISO block holds, part by part."""

    def __init__(self, state: State, unit: Unit, row: int, node: LineNode) -> None:
        self._state = state
        self._unit = unit
        self._row = row
        self._text = node.text
        self._values = Values(state, unit.file, row, node.text)
        self._optional = optional(state, node)
        self._pieces: list[Piece] = []
        self._ends = self._returns = self._calculates_m = False
        self._depends = False
        """Whether the blocks behind it do other things if it is passed over."""
        self._sets: list[Callable[[], str]] = []
        """The names of the axis and system parameters that it sets."""
        self._written = self._cut = False
        """Whether anything of it is written, and whether its last part is not."""
        self._take_all(node.tree)

    def op(self, back: Callable[[], int]) -> Op:
        """The block as it runs. ``back``: what G26 does."""
        behind = self._row + 1
        if self._optional:
            return lambda: behind
        if self._optional is None and self._depends:
            raise undecided(self._state, self._unit, self._row, self._text)
        if self._ends and self._optional is not None:
            behind = END
        run = self._literal_op(behind) or self._calculated_op(behind)
        if self._optional is None:
            return self._uncertain(run)
        return self._ended(run, back) if self._returns or self._calculates_m else run

    def _take_all(self, tree: Node) -> None:
        """What is not written takes the blanks behind it along."""
        at = 0
        for part in tree.children:
            self._pieces.append(self._text[at : part.start])
            at = part.end
            kept = self._take(part)
            if not kept:
                match = _BLANKS.match(self._text, at)
                at = match.end() if match is not None else at
            self._cut = not kept
        self._pieces.append(self._text[at:])

    def _take(self, part: Node | Token) -> bool:
        """Add the pieces of a part; whether it is written."""
        match part.kind:
            case "DELETE":
                return self._copy(part, self._optional is None)
            case "nword":
                return self._copy(part, self._state.job.inputs.keep_n)
            case "COMMENT":
                self._written = True
                return self._copy(part, True)
            case "g_word":
                return self._g_word(part)
            case "word":
                return self._word(part)
            case "axis_alias":
                self._depends = True
                self._pieces.append(self._set_alias(self._values.said(part)[-3:].upper()))
        return False

    def _copy(self, part: Node | Token, kept: bool) -> bool:
        if kept:
            self._pieces.append(self._values.said(part))
        return kept

    def _g_word(self, part: Node | Token) -> bool:
        if isinstance(part, Node) and part.children[0].kind == "G26":
            self._returns = self._depends = True
            return False
        self._written = True
        return self._copy(part, True)

    def _set_alias(self, axes: str) -> Callable[[], str]:
        state = self._state

        def set_alias() -> str:
            state.alias = axes
            return ""

        return set_alias

    def _word(self, part: Node | Token) -> bool:
        assert isinstance(part, Node)
        target, value = part.children
        literal = constant(self._text, value) if value.kind != "angle" else None
        if not self._is_output(target):
            self._depends = True
            stored = self._values.store(target, value)
            self._pieces.append(lambda: _nothing(stored))
            return False
        self._written = True
        if target.kind == "alias_name":
            self._sets.append(self._values.axis(target))
        else:
            name = self._values.name(target)
            self._sets.append(lambda: name)
            if name == "M":
                self._ends = self._ends or literal in _ENDS
                self._calculates_m = literal is None
            if isinstance(literal, float):
                self._pieces.append(Stored(name, literal, self._values.said(part)))
                return True
        self._pieces.append(self._output(target, value))
        return True

    def _is_output(self, target: Node | Token) -> bool:
        """Axis and system parameters are, those of the user are not (spec/z32.md §6.1, §11)."""
        said = self._values.said(target).upper()
        return target.kind != "vector" and (len(said) == 1 or target.kind == "alias_name" or said in self._state.system)

    def _output(self, target: Node | Token, value: Node | Token) -> Callable[[], str]:
        """A word with what is calculated of it in its place."""
        stored, said = self._values.store(target, value), self._values.said(value)
        shown = self._values.printed(stored, value) if value.kind == "angle" else None
        between = self._text[target.end : value.start]
        if target.kind == "alias_name":
            axis = self._values.axis(target)
            if shown is None:

                def aliased() -> str:
                    stored()
                    return axis() + between + said

                return aliased
            return lambda: axis() + between + shown()
        assert shown is not None
        head = self._text[target.start : value.start]
        return lambda: head + shown()

    def _literal_op(self, behind: int) -> Op | None:
        """The block if nothing in it is calculated."""
        stored = [piece for piece in self._pieces if isinstance(piece, Stored)]
        texts = [piece.text if isinstance(piece, Stored) else piece for piece in self._pieces]
        known = [text for text in texts if isinstance(text, str)]
        if len(known) < len(texts):
            return None
        text = "".join(known).rstrip(" \t") if self._cut else "".join(known)
        if not self._written:
            return lambda: behind
        run = copied(self._state, self._unit, self._row, text, {each.name: each.value for each in stored})
        return run if behind != END else lambda: run() and END

    def _calculated_op(self, behind: int) -> Op:
        pieces = [self._storing(piece) if isinstance(piece, Stored) else piece for piece in self._pieces if piece]
        state, emit, file, row, cut = self._state, self._state.job.emit, self._unit.file, self._row, self._cut
        if not self._written:
            calls = [piece for piece in pieces if not isinstance(piece, str)]

            def stored() -> int:
                for call in calls:
                    call()
                return behind

            return stored

        def calculated() -> int:
            text = "".join([piece if piece.__class__ is str else piece() for piece in pieces])  # type: ignore[operator]  # what is no text is called
            emit(text.rstrip(" \t") if cut else text, file, row, state.frame)
            return behind

        return calculated

    def _storing(self, stored: Stored) -> Callable[[], str]:
        params = self._state.params
        name, value, text = stored

        def put() -> str:
            params[name] = value
            return text

        return put

    def _uncertain(self, run: Op) -> Op:
        """An optional block that is kept: what it sets is not known behind it, nor whether M2 or M30 in it ended the run."""
        state, ends, calculated = self._state, self._ends, self._calculates_m

        def kept() -> int:
            before, state.unsure = state.unsure, True
            behind = run()
            state.unsure = before or ends or (calculated and state.params["M"] in _ENDS)
            for name in [each() for each in self._sets]:
                state.params.pop(name, None)
                state.uncertain.add(name)
            return behind

        return kept

    def _ended(self, run: Op, back: Callable[[], int]) -> Op:
        """A block with G26, or with an M code that is calculated."""
        params, returns, calculated = self._state.params, self._returns, self._calculates_m

        def ended() -> int:
            behind = run()
            if calculated and params["M"] in _ENDS:
                return END
            return back() if returns and behind != END else behind

        return ended


def copied(state: State, unit: Unit, row: int, text: str, values: Mapping[str, float]) -> Op:
    """A block in which nothing is calculated."""
    params, emit, file, behind = state.params, state.job.emit, unit.file, row + 1

    def copied_and_stored() -> int:
        params.update(values)
        emit(text, file, row, state.frame)
        return behind

    return copied_and_stored


def optional(state: State, node: LineNode) -> bool | None:
    """Whether a line is passed over; None if only the operator knows."""
    return state.job.inputs.block_delete if "DELETE" in node.kinds else False


def undecided(state: State, unit: Unit, row: int, text: str) -> Halt:
    """The end of a run that hangs on the operator's switch."""
    switch = state.job.inputs.ways.switch
    message = f"whether this line runs is decided by the operator's switch, and the blocks behind it depend on what it does; say {switch}"
    span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
    return state.fault("optional-state", Place(unit.file, row, span), message)


def _nothing(stored: Callable[[], float]) -> str:
    stored()
    return ""
