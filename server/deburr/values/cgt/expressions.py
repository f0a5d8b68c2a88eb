"""CGT's expressions on values as closures: the language's own operators and functions, on all that a word can hold (spec/cgt.md §5.8, §11)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic import Refusal
from deburr.arithmetic.cgt import arguments_of, function, part_of
from deburr.templates.symbols import functions
from deburr.templates.types import is_number, is_plain
from deburr.values import operations as on
from deburr.values.cgt.lifted import FUNCTIONS, OPERATORS
from deburr.values.cgt.words import FIXED
from deburr.values.domain import ANY, LARGEST, UNITS, Value, exactly
from deburr.values.graph import Env, Key, Proof
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr.templates.symbols import Word
    from deburr.values.cgt.words import Vocabulary

Get = Callable[[Env], Value]
Texts = Callable[[Env], frozenset[str] | None]
"""What gives the texts that there can be; None: who knows which."""
_OPERATIONS = frozenset(("sum", "product", "quotient", "power"))
_COUNT = Value(0.0, LARGEST, UNITS)


class Expressions:
    """Compiles the values of one part of a line. ``used``: the words that they read."""

    def __init__(self, text: str, words: Vocabulary) -> None:
        self._text = text
        self._words = words
        self.used: set[Key] = set()

    def number(self, part: Node | Token) -> Get:
        """What calculates a number."""
        if isinstance(part, Token):
            return self._token(part)
        if part.kind in _OPERATIONS:
            left, sign, right = part.children
            return self._applied(part, right, OPERATORS[self.said(sign)], left, right)
        match part.kind:
            case "group":
                return self.number(part.children[1])
            case "signed" | "negative":
                inner = self.number(part.children[1])
                return (lambda env: on.negative(inner(env))) if self._text[part.start] == "-" else inner
            case "function":
                return self._function(part)
            case _:
                return _unknown

    def text(self, part: Node | Token | None) -> Texts:
        """What makes a text."""
        if part is None:
            return lambda env: frozenset(("",))
        if part.kind == "WORD":
            return self._printed(part)
        if isinstance(part, Node) and part.kind == "function":
            return self._part_of(part)
        if part.kind == "job" or not (is_plain(part) or part.kind == "CHARS"):
            return _unknown_text
        texts = frozenset((self.said(part).strip(" \t"),))
        return lambda env: texts

    def key(self, part: Node | Token) -> str | None:
        """The word that a part is, if it holds what was set."""
        word = self.word(part)
        return word.name if word is not None and self._words.holds(word) else None

    def word(self, part: Node | Token) -> Word | None:
        """The word that a part names."""
        return self._words.find(self.said(part)) if part.kind == "WORD" else None

    def computed(self, part: Node | Token) -> list[Word]:
        """The words in a part that sections compute, each once."""
        if not self._words.has_computed:
            return []
        words = [word for each in walk(part) if (word := self.word(each)) is not None and self._words.computes(word)]
        return list(dict.fromkeys(words))

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        return self._text[part.start : part.end]

    def span(self, part: Node | Token) -> Span:
        """The columns of a part."""
        return Span(part.start, part.end)

    def proof(self, kind: str, part: Node | Token, message: str) -> Proof:
        """What is certain to go wrong at a part of this line."""
        return Proof(kind, Span(part.start, part.end), message)

    def _token(self, part: Token) -> Get:
        if part.kind == "WORD":
            return self._read(part)
        if part.kind == "CHARS":
            return _unknown
        found = function("PI")
        literal = exactly(float(self.said(part)) if part.kind == "NUMBER" or found is None else found.apply())
        return lambda env: literal

    def _read(self, token: Token) -> Get:
        word = self.word(token)
        if word is None:
            return _unknown
        if word.name in FIXED:
            fixed = FIXED[word.name]
            return lambda env: fixed
        if word.is_text:
            return self._number_in(token, word)
        key = self.key(token)
        if key is None:
            return _unknown
        self.used.add(key)

        def found(env: Env) -> Value:
            value = env.get(key)
            if value is None or value.low > value.high:
                # Nothing may have set it; who goes on has a number.
                return ANY
            return value

        return found

    def _number_in(self, token: Token, word: Word) -> Get:
        get = self._printed(token)

        def found(env: Env) -> Value:
            texts = get(env)
            if texts is None:
                return _unknown(env)
            numbers = [exactly(float(text)) for text in sorted(texts) if is_number(text)]
            if not numbers:
                said = " or ".join(f"`{text}`" for text in sorted(texts))
                raise self.proof("eval-type", token, f"`#{word.name}` is the text {said} here, which is no number")
            return on.union(numbers)

        return found

    def _printed(self, token: Token | Node) -> Texts:
        word, key = self.word(token), self.key(token)
        if word is None or key is None or not word.is_text:
            return _unknown_text
        self.used.add(key)
        return lambda env: env.get(key, ANY).texts or None

    def _applied(self, part: Node, divisor: Node | Token, apply: on.Lifted, *operands: Node | Token) -> Get:
        gets = [self.number(operand) for operand in operands]
        if len(gets) == 2:
            return self._applied_to_two(part, divisor, apply, *gets)

        def found(env: Env) -> Value:
            values = [get(env) for get in gets]
            try:
                value = apply(*values)
            except Refusal as refused:
                raise self._refused(part, divisor, refused) from None
            return _finite(value)

        return found

    def _applied_to_two(self, part: Node, divisor: Node | Token, apply: on.Lifted, left: Get, right: Get) -> Get:
        def found(env: Env) -> Value:
            one, two = left(env), right(env)
            try:
                value = apply(one, two)
            except Refusal as refused:
                raise self._refused(part, divisor, refused) from None
            return _finite(value) if value.wild else value

        return found

    def _refused(self, part: Node, divisor: Node | Token, refused: Refusal) -> Proof:
        blamed = refused.rule == "divide-by-zero" and part.kind != "power"
        return self.proof(
            refused.rule, divisor if blamed else part, f"`{self.said(part)}` is {refused.why} here; it has no value"
        )

    def _function(self, part: Node) -> Get:
        name, arguments = self.said(part.children[0]).upper(), arguments_of(part)
        counts = functions().get(name)
        if counts is None or not counts[0] <= len(arguments) <= counts[1]:
            return _unknown
        if name == "STRLEN":
            return self._length(arguments[0])
        if name == "TLEN":
            return self._applied(part, part, lambda step: ANY, arguments[0])
        if name not in FUNCTIONS:
            return _unknown
        return self._applied(part, arguments[-1] if arguments else part, FUNCTIONS[name], *arguments)

    def _length(self, part: Node | Token) -> Get:
        get = self.text(part)

        def found(env: Env) -> Value:
            texts = get(env)
            return _COUNT if texts is None else on.union([exactly(float(len(text))) for text in sorted(texts)])

        return found

    def _part_of(self, part: Node) -> Texts:
        arguments = arguments_of(part)
        if self.said(part.children[0]).upper() != "STRSUB" or len(arguments) != 3:
            return _unknown_text
        text, start, length = self.text(arguments[0]), self.number(arguments[1]), self.number(arguments[2])

        def found(env: Env) -> frozenset[str] | None:
            texts, first, count = text(env), start(env), length(env)
            try:
                return _parts(texts, first, count)
            except Refusal as refused:
                raise self._refused(part, part, refused) from None

        return found


def _parts(texts: frozenset[str] | None, first: Value, count: Value) -> frozenset[str] | None:
    if first.high < 1 or count.high < 0:
        part_of("", first.high if math.isfinite(first.high) else 0.0, min(count.high, LARGEST))
    if texts is None or not (first.exact and count.exact):
        return None
    return frozenset(part_of(text, first.low, count.low) for text in texts)


def _finite(value: Value) -> Value:
    """What who goes on has: a finite number."""
    return value._replace(wild=False) if value.wild else value


def _unknown(env: Env) -> Value:
    return ANY


def _unknown_text(env: Env) -> None:
    """Who knows which text."""
