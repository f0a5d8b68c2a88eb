"""The items of lines and what their commands make of values, made once for all lines that say the same. Knows no flow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.templates.items import Item
from deburr.templates.template import items_of
from deburr.templates.types import is_plain
from deburr.values.cgt.brackets import Changed
from deburr.values.cgt.conditions import Test, tests
from deburr.values.cgt.expressions import Expressions
from deburr.values.cgt.outcomes import Outcome, outcome, tracked
from deburr.values.kept import Kept

if TYPE_CHECKING:
    from deburr.templates.symbols import Word
    from deburr.values.cgt.words import Vocabulary
    from deburr.values.graph import Key
    from deburr_grammar.line import LineNode
    from deburr_grammar.tree import Node


class Command(NamedTuple):
    """What a command does: the words that are computed before it, what it makes of the values, the keys that it reads.

    ``setting``: the word that it sets, with whether that is a constant that stands there.
    """

    computed: tuple[Word, ...]
    outcome: Outcome | None
    used: tuple[Key, ...]
    setting: tuple[Key, bool] | None


class Asked(NamedTuple):
    """What an `#IF`, `#IFSTR` or `#IFCHG` asks: its test, the keys that it reads, the words that are computed before it."""

    test: Test
    used: tuple[Key, ...]
    computed: tuple[Word, ...]


class Commands:
    """What lines say where words have one meaning. Columns are those of a line, so that they hold for every line that says the same."""

    def __init__(self, words: Vocabulary) -> None:
        self.words = words
        self._items: Kept[tuple[Item, ...]] = Kept()
        self._commands: Kept[Command] = Kept()
        self._asked: Kept[Asked] = Kept()

    def items(self, row: int, node: LineNode) -> Iterator[Item]:
        """The items of a line that stands in a row."""
        key = (node.text, node.reading.name)
        found = self._items.get(key)
        if found is None:
            found = self._items.add(key, tuple(items_of(row, node, self.words.symbols)), 1)
        return (Item(kind, row, start, end, text, name, command) for kind, _, start, end, text, name, command in found)

    def command(self, item: Item, node: Node, text: str) -> Command:
        """What a command does. ``text``: the line that it stands on."""
        key = (item.kind, item.start, item.text)
        found = self._commands.get(key)
        return self._commands.add(key, self._command(item, node, text), 1) if found is None else found

    def asked(self, item: Item, node: Node, text: str) -> Asked:
        """What a condition asks. ``text``: the line that it stands on."""
        key = (item.start, item.text)
        found = self._asked.get(key)
        return self._asked.add(key, self._condition(node, text), 1) if found is None else found

    def _command(self, item: Item, node: Node, text: str) -> Command:
        expressions = Expressions(text, self.words)
        runs = item.kind not in ("declaration", "fmt") and item.name != "RESET"
        computed = tuple(expressions.computed(node)) if runs else ()
        found = outcome(item, expressions, self.words)
        key = expressions.key(node.children[2]) if item.kind == "eval" else None
        setting = (key, is_plain(node.children[-2])) if key is not None else None
        return Command(computed, found, tuple(expressions.used), setting)

    def _condition(self, node: Node, text: str) -> Asked:
        expressions = Expressions(text, self.words)
        computed = tuple(expressions.computed(node))
        asked = node.node("tests") or node.node("string_tests")
        if asked is not None:
            return Asked(tests(expressions, asked), tuple(expressions.used), computed)
        words = [expressions.word(part) for part in node.children if part.kind == "WORD"]
        changed = Changed(tuple((False, tracked(word, self.words)) for word in words), ())
        return Asked(changed.ways, changed.keys, computed)
