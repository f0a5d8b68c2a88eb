"""What commands make of the values: settings, marks, rows of tables, formats, calls (spec/cgt.md §5). Knows no flow within a section."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.cgt import equal
from deburr.templates.template import target
from deburr.templates.types import value_of
from deburr.values.cgt.words import ALL, END, RETURNED, Shown, unshown, without
from deburr.values.domain import ANY, NO, YES, Value, any_of
from deburr.values.graph import Env, Key, Proof

if TYPE_CHECKING:
    from deburr.templates.items import Item
    from deburr.templates.symbols import Word
    from deburr.values.cgt.expressions import Expressions
    from deburr.values.cgt.words import Vocabulary
    from deburr.values.graph import Summary
    from deburr_grammar.text import Span
    from deburr_grammar.tree import Node

_AWAY = 1e-3
"""So far from a row's number no index counts as that."""
_MOST = 100_000
"""Rows and passes that are counted exactly enough for that."""
Change = Callable[[Env], Env]


class Outcome(NamedTuple):
    """What a command makes of the values, and the keys that it sets."""

    change: Change
    sets: tuple[Key, ...] = ()


def outcome(item: Item, expressions: Expressions, words: Vocabulary) -> Outcome | None:
    """What a command does; None of one that does nothing to values."""
    assert item.node is not None
    make = _COMMANDS.get(item.kind)
    return make(item, item.node, expressions, words) if make is not None else None


def tracked(word: Word | None, words: Vocabulary) -> Shown | None:
    """The key for what is output of a word; None of one that changes by itself."""
    if word is None or word.type == "block" or words.computes(word):
        return None
    return Shown(word.name)


def shown(env: Env, keys: tuple[Shown, ...], quiet: bool) -> Env:
    """Behind the output of words. Where lines are not output, that counts for nothing; ``quiet``: that may be so."""
    missing = [key for key in keys if env.get(key) != YES]
    if not missing:
        return env
    return without(env, *missing) if quiet else {**env, **dict.fromkeys(missing, YES)}


def row_checked(count: int, name: str, span: Span) -> Callable[[Value], None]:
    """What raises a `Proof` where no number that an index can be is one of a table's rows."""

    def checked(value: Value) -> None:
        if value.empty or value.wild:
            return
        if value.low == value.high:
            number = round(value.low)
            wrong = not (equal(value.low, number) and 0 <= number < count)
        else:
            beyond = value.low >= count - 1 + _AWAY or value.high <= -_AWAY
            wrong = (count < _MOST and beyond) or not count
        if wrong:
            said = f"row {value.low:g}" if value.low == value.high else "none of these"
            has = f"rows 0 to {count - 1}" if count else "no rows"
            raise Proof("table-index", span, f"{said} of `@{name}` is asked for here; it has {has}")

    return checked


def merged(env: Env, found: Summary) -> Env | None:
    """The values behind a call; None: it does not come back."""
    if found.env is None:
        return None
    if found.written is None:
        return dict(found.env)
    after = {key: value for key, value in env.items() if key not in found.written}
    after.update(found.env)
    return unshown(after) if ALL in found.written else after


def computed(word: Word, env: Env, found: Summary) -> Env | None:
    """The values behind a section that computes a word."""
    after = merged(env, found)
    if after is None:
        return None
    value = after.get(RETURNED, ANY)
    after = without(after, END, RETURNED, word.name, Shown(word.name))
    if bool(value.texts) == word.is_text and value != ANY:
        after[word.name] = value
    return after


def before_computing(word: Word, env: Env) -> Env:
    """The values with which a section that computes a word is run."""
    first = any_of(frozenset(("",))) if word.is_text else NO
    return {**without(env, END), RETURNED: first}


def _put(env: Env, key: Key, value: Value, label: Shown | None = None) -> Env:
    """The values with another one; what was output of it before, under ``label``, is no more what it would print."""
    found = env.copy()
    found[key] = value
    if value == ANY:
        del found[key]
    if label in found:
        del found[label]
    return found


def _eval(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    left, value = node.children[2], value_of(node, "EQUAL")
    word, key = expressions.word(left), expressions.key(left)
    label = tracked(word, words)
    sets = tuple(each for each in (key, label) if each is not None)
    if word is not None and word.is_text:
        texts = expressions.text(value)
        get: Callable[[Env], Value] = lambda env: _of_texts(texts(env))  # noqa: E731  # one of two sorts of values
    elif value is not None:
        get = expressions.number(value)
    else:
        return Outcome(lambda env: env)

    def put(env: Env) -> Env:
        found = get(env)
        if key is None:
            return without(env, label)
        old = env.get(key)
        same = old == found and (found.exact or len(found.texts) == 1)
        return env if same else _put(env, key, found, label)

    return Outcome(put, sets)


def _of_texts(texts: frozenset[str] | None) -> Value:
    return ANY if texts is None else any_of(texts)


def _macro(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    value = value_of(node, "EQUAL")
    if item.name == "EVMS" or value is None:
        return _looked(expressions.text(value))
    return _looked(expressions.number(value))


def _looked(get: Callable[[Env], object]) -> Outcome:
    """Something is calculated, and nothing set."""

    def calculated(env: Env) -> Env:
        get(env)
        return env

    return Outcome(calculated)


def _mark(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    keys = [tracked(expressions.word(part), words) for part in node.children if part.kind == "WORD"]
    marks: Env = dict.fromkeys((key for key in keys if key is not None), NO if item.name == "RESET" else YES)
    return Outcome(lambda env: {**env, **marks}, tuple(marks))


def _lookup(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    name, index = target(item)[0], node.children[-2]
    get, rows = expressions.number(index), words.rows(name)
    if rows is None:
        return Outcome(lambda env: env)
    check = row_checked(rows, name, expressions.span(index))
    return _looked(lambda env: check(get(env)))


def _fmt(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    return Outcome(unshown, (ALL,))


def _block(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    return _looked(expressions.number(node.children[2]))


def _returned(item: Item, node: Node, expressions: Expressions, words: Vocabulary) -> Outcome:
    value = value_of(node, "OPEN")
    if item.name == "RETSTR" or value is None:
        texts = expressions.text(value)
        return Outcome(lambda env: _put(env, RETURNED, _of_texts(texts(env))), (RETURNED,))
    get = expressions.number(value)
    return Outcome(lambda env: _put(env, RETURNED, get(env)), (RETURNED,))


_COMMANDS: dict[str, Callable[[Item, Node, Expressions, Vocabulary], Outcome]] = {
    "eval": _eval,
    "macro": _macro,
    "mark": _mark,
    "lookup": _lookup,
    "fmt": _fmt,
    "block": _block,
    "returned": _returned,
}
