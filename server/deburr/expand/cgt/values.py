"""The values of a template line as closures, made once: expressions, texts, tests (spec/cgt.md §5.4, §5.8). Outputs nothing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from deburr.arithmetic import Refusal
from deburr.arithmetic.cgt import Function, arguments_of, function, holds, operation, part_of
from deburr.expand.cgt.lines import Place
from deburr.expand.cgt.words import LONGEST, Cell
from deburr.templates.symbols import functions, nearest
from deburr.templates.types import is_number, is_plain
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.expand.cgt.events import JobData
    from deburr.expand.cgt.state import State
    from deburr.fault import Halt

Get = Callable[[], float]
GetText = Callable[[], str]
Test = Callable[[], bool]
_OPERATIONS = frozenset(("sum", "product", "quotient", "power"))


class Values:
    """Compiles the values of one line."""

    def __init__(self, state: State, given: JobData, row: int, text: str) -> None:
        self._state = state
        self._given = given
        self._row = row
        self._text = text

    def number(self, part: Node | Token) -> Get:
        """What calculates a number."""
        if isinstance(part, Token):
            return self._token(part)
        if part.kind in _OPERATIONS:
            left, sign, right = part.children
            divisor = right if sign.kind == "SLASH" else part
            return self._two(part, divisor, operation(self.said(sign)), self.number(left), self.number(right))
        match part.kind:
            case "group":
                return self.number(part.children[1])
            case "signed" | "negative":
                inner = self.number(part.children[1])
                return (lambda: -inner()) if self._text[part.start] == "-" else inner
            case "job":
                return self._job_number(part)
            case _:
                return self._function(part)

    def text(self, part: Node | Token | None) -> GetText:
        """What makes a text: of a word what it prints, of a function its value, else the text as it stands."""
        if part is None:
            return lambda: ""
        if part.kind == "WORD":
            return self._printed(part)
        if part.kind == "job":
            return lambda: self._job(part)
        if isinstance(part, Node) and part.kind == "function":
            return self._part_of(part)
        if not is_plain(part) and part.kind != "CHARS":
            raise self.halt(
                "eval-type",
                part,
                f"`{self.said(part)}` is no text; a text is one word, one text function or unquoted text",
            )
        text = self.said(part).strip(" \t")
        return lambda: text

    def test(self, tests: Node) -> Test:
        """The tests of an `#IF` or `#IFSTR`, joined from left to right; all of them are calculated."""
        parts = [part for part in tests.children if part.kind != "COMMA"]
        made = [self._one_test(part) for part in parts[::2] if isinstance(part, Node)]
        ands = [self.said(part).upper() == "#AND" for part in parts[1::2]]
        first, rest = made[0], tuple(zip(ands, made[1:]))
        if not rest:
            return first

        def found() -> bool:
            result = first()
            for both, test in rest:
                also = test()
                result = result and also if both else result or also
            return result

        return found

    def cell(self, token: Token | Node) -> Cell:
        """The word that a token names."""
        said = self.said(token).removeprefix("#")
        cell = self._state.words.find(said)
        if cell is None:
            kind = "word-undeclared" if any("a" <= sign <= "z" for sign in said) else "word-unknown"
            raise self.halt(
                kind, token, f"`#{said}` has no value that is known, so the template cannot be expanded", True
            )
        return cell

    def computed(self, part: Node | Token) -> list[tuple[Cell, Place]]:
        """The words in a part that their own sections compute, each once."""
        tokens = [each for each in walk(part) if each.kind == "WORD"]
        found: dict[str, tuple[Cell, Place]] = {}
        for token in tokens:
            cell = self._state.words.find(self.said(token)[1:])
            if cell is not None and cell.section:
                found.setdefault(cell.name, (cell, self.place(token)))
        return list(found.values())

    def checked_length(self, part: Node | Token, text: str) -> str:
        """A text that a word can hold."""
        if len(text) > LONGEST:
            raise self.halt("string-length", part, f"this text has {len(text)} characters here; a word holds {LONGEST}")
        return text

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        return self._text[part.start : part.end]

    def place(self, part: Node | Token) -> Place:
        """Where a part stands."""
        return Place(self._row, Span(part.start, part.end))

    def halt(self, kind: str, part: Node | Token, message: str, input: bool = False) -> Halt:
        """The end of the run at a part of this line."""
        return self._state.fault(kind, self.place(part), message, input)

    def _token(self, part: Token) -> Get:
        if part.kind == "WORD":
            return self._word(part)
        if part.kind == "CHARS":
            raise self.halt("eval-type", part, f"`{self.said(part)}` is a text where a number is needed")
        found = function("PI")
        literal = float(self.said(part)) if part.kind == "NUMBER" or found is None else found.apply()
        return lambda: literal

    def _word(self, token: Token) -> Get:
        cell, at, state = self.cell(token), self.place(token), self._state
        if cell.is_text:
            return self._number_in(token, cell)

        def found() -> float:
            value = cell.value
            if value is None:
                raise state.unset(cell, at)
            return value  # type: ignore[return-value]  # a cell that is no text holds a number

        return found

    def _number_in(self, token: Token, cell: Cell) -> Get:
        """A text that holds a number is taken for it."""
        printed = self._printed(token)

        def found() -> float:
            text = printed()
            if not is_number(text):
                message = f"`#{cell.name}` is the text `{text}` here, which is no number"
                raise self.halt("eval-type", token, message)
            return float(text)

        return found

    def _printed(self, token: Token | Node) -> GetText:
        cell, at, state = self.cell(token), self.place(token), self._state
        return lambda: cell.text if cell.text is not None else state.shown(cell, at)

    def _two(self, part: Node, divisor: Node | Token, apply: Callable[[float, float], float], a: Get, b: Get) -> Get:
        def found() -> float:
            try:
                return apply(a(), b())
            except Refusal as refused:
                raise self._refused(part, divisor, refused) from None

        return found

    def _refused(self, part: Node, divisor: Node | Token, refused: Refusal) -> Halt:
        at = divisor if refused.rule == "divide-by-zero" else part
        return self.halt(refused.rule, at, f"`{self.said(part)}` is {refused.why} here; it has no value")

    def _function(self, part: Node) -> Get:
        said = self.said(part.children[0])
        name, arguments = said.upper(), arguments_of(part)
        counts = functions().get(name)
        if counts is None:
            close = nearest(name, functions())
            hint = f"; did you mean `{close}`?" if close else ""
            raise self.halt("function-unknown", part.children[0], f"there is no function `{said}`{hint}")
        if not counts[0] <= len(arguments) <= counts[1]:
            raise self.halt("function-arguments", part, f"`{name}` takes {counts[0]} arguments, not {len(arguments)}")
        if name == "STRLEN":
            text = self.text(arguments[0])
            return lambda: float(len(text()))
        if name == "TOTEL":
            return lambda: self._total(part, self._given.elements())
        if name == "TLEN":
            step = self.number(arguments[0])
            return lambda: self._total(part, self._given.length(step()))
        known = function(name)
        if known is None:
            raise self.halt("eval-type", part, f"`{self.said(part)}` is a text where a number is needed")
        return self._applied(part, known, arguments)

    def _applied(self, part: Node, known: Function, arguments: Sequence[Node | Token]) -> Get:
        gets = [self.number(argument) for argument in arguments]
        if known.takes == 2:
            return self._two(part, arguments[1], known.apply, *gets)

        def found() -> float:
            try:
                return known.apply(*[get() for get in gets])
            except Refusal as refused:
                raise self._refused(part, part, refused) from None

        return found

    def _total(self, part: Node, found: float | None) -> float:
        if found is None:
            raise self.halt(
                "word-unset", part, f"`{self.said(part)}` is not known of a list of events; CL text tells it", True
            )
        return found

    def _part_of(self, part: Node) -> GetText:
        name, arguments = self.said(part.children[0]).upper(), arguments_of(part)
        if name != "STRSUB" or len(arguments) != 3:
            raise self.halt("eval-type", part, f"`{self.said(part)}` is a number where a text is needed")
        text, start, length = self.text(arguments[0]), self.number(arguments[1]), self.number(arguments[2])

        def found() -> str:
            try:
                return part_of(text(), start(), length())
            except Refusal as refused:
                raise self._refused(part, part, refused) from None

        return found

    def _job(self, part: Node | Token) -> str:
        """Job data, which only the user can give."""
        assert isinstance(part, Node)
        tag = self.said(part.children[2])
        found = self._given.data(tag)
        if found is None:
            given = self._given.ways.define.format(f"JOS({tag})=VALUE")
            message = f"the job's `{tag}` is not known here; {given} gives it"
            raise self.halt("word-unset", part, message, True)
        return found

    def _job_number(self, part: Node) -> Get:
        def found() -> float:
            said = self._job(part)
            if not is_number(said):
                raise self.halt("eval-type", part, f"`{self.said(part)}` is the text `{said}` here, which is no number")
            return float(said)

        return found

    def _one_test(self, test: Node) -> Test:
        left, relation, *right = test.children
        sign = self.said(relation)
        if test.kind == "test":
            return self._compared(sign, self.number(left), self.number(right[0]))
        one, two, same = self.text(left), self._right_text(right), sign == "="
        return lambda: (one().strip(" \t") == two().strip(" \t")) == same

    def _right_text(self, right: Sequence[Node | Token]) -> GetText:
        if right and right[0].kind == "WORD":
            return self._printed(right[0])
        text = self.said(right[0]) if right else ""
        return lambda: text

    def _compared(self, sign: str, a: Get, b: Get) -> Test:
        return lambda: holds(sign, a(), b())
