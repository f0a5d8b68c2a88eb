"""A dialect's grammar: one line in, a tree or a fault out. Never looks at more than one line.

Lark reads `line.lark` and makes its tables, which ship beside it as `line.tables`
(`python -m deburr_grammar.tables` writes them, a test proves them fresh). `lalr.py` reads lines
by them: so a check of a small program does not wait for Lark, and large ones wait less for each line.
"""

from __future__ import annotations

import marshal
import pkgutil
import re
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr_grammar.lalr import Parser, Stopped, Tables, read_parts
from deburr_grammar.problem import Part, SyntaxFault
from deburr_grammar.tree import Node, Token, tokens

if TYPE_CHECKING:
    from lark import Lark

CORE = "deburr_grammar.core"
DEEPEST = 256
"""Levels of a tree: no line of 256 characters has more, and whoever walks a tree may do so by recursion."""
_FORM = 1
"""Of `line.tables`; another one is another key."""
_OPTIONS: dict[str, Any] = {
    "parser": "lalr",
    "lexer": "contextual",
    "keep_all_tokens": True,
    "maybe_placeholders": False,
    # Without it `K` (kelvin) is a `k` and `ſ` an `s` wherever case is ignored.
    "g_regex_flags": re.ASCII,
}


class Parsed(NamedTuple):
    """What a line was read as: the tree as far as it goes, and the fault if there is one. ``deep``: it nests too deep to be given."""

    tree: Node
    fault: SyntaxFault | None
    deep: bool = False


class Grammar:
    """The whole-line grammar of one dialect. ``starts`` are its start rules, one for each kind of reading."""

    def __init__(self, package: str, starts: tuple[str, ...]) -> None:
        self._package = package
        self._starts = starts

    def parse(self, start: str, text: str) -> Parsed:
        """Read one line (or one shape) under a start rule."""
        found = self._parser.parse(start, text)
        if isinstance(found, Stopped):
            return _DEEP if _too_deep(text, found.values) else self._faulty(text, start, found)
        if _too_deep(text, [found]):
            return _DEEP
        return Parsed(found if isinstance(found, Node) else Node(start, found.start, found.end, (found,)), None)

    def following(self, start: str, text: str) -> frozenset[str]:
        """The terminals that could follow the start of a line; none if that itself cannot be read."""
        return self._parser.following(start, text)

    def build(self) -> Lark:
        """Lark's own parser, made from the grammar text."""
        from lark import Lark

        source = (_data(self._package, "line.lark") or b"").decode("utf-8")
        return Lark(source, start=list(self._starts), import_paths=[_from_core], **_OPTIONS)

    def tables(self) -> bytes:
        """The content of `line.tables`."""
        return self._key + marshal.dumps(tuple(_tables_of(self.build())), 2)

    @property
    def fresh(self) -> bool:
        """Whether `line.tables` is there and made from the grammar as it is."""
        return (_data(self._package, "line.tables") or b"").startswith(self._key)

    @cached_property
    def _parser(self) -> Parser:
        tables, key = _data(self._package, "line.tables"), self._key
        if tables is not None and tables.startswith(key):
            try:
                return Parser(Tables(*marshal.loads(tables[len(key) :])))
            except (EOFError, ValueError, TypeError):
                pass
        # Tables of another grammar, or damaged ones: slower, never wrong.
        return Parser(_tables_of(self.build()))

    @property
    def _key(self) -> bytes:
        """All that the tables are made from. It stands before them, so they say for themselves whether they are fresh."""
        source = _data(self._package, "line.lark") or b""
        imported = [_data(CORE, f"{name.decode()}.lark") for name in re.findall(rb"(?m)^%import core\.(\w+)", source)]
        return repr((_FORM, sorted(_OPTIONS.items()), self._starts, source, imported)).encode()

    def _faulty(self, text: str, start: str, stopped: Stopped) -> Parsed:
        parts = tuple(read_parts(stopped.values))
        stack = tuple(Part(part.kind, part.start, part.end) for part in parts)
        tree = Node(start, parts[0].start if parts else 0, parts[-1].end if parts else 0, parts)
        expected = self._parser.accepted(stopped.states)
        fault = SyntaxFault(text, stopped.start, stopped.end, stopped.found, expected, stack, _last_tokens(parts))
        return Parsed(tree, fault)


def _tables_of(lark: Lark) -> Tables:
    """What Lark has made, in plain values."""
    parser: Any = lark.parser
    table, lexer = parser.parser._parse_table, parser.lexer
    rules = sorted(lark.rules, key=str)
    numbers = {rule: number for number, rule in enumerate(rules)}
    states = _in_order(table)
    actions: list[dict[str, int]] = [{} for _ in states]
    gotos: list[dict[str, int]] = [{} for _ in states]
    for state, number in states.items():
        for name, (action, argument) in sorted(table.states[state].items()):
            if action.name != "Shift":
                actions[number][name] = ~numbers[argument]
            elif name.isupper():
                actions[number][name] = states[argument]
            else:
                gotos[number][name] = states[argument]
    looks = [_pattern(lexer.lexers[state].scanner) for state in states]
    scanners = list(dict.fromkeys(looks))
    return Tables(
        actions,
        gotos,
        [_rule(rule) for rule in rules],
        scanners,
        [scanners.index(pattern) for pattern in looks],
        _pattern(lexer.root_lexer.scanner),
        {name: _pattern(unless.scanner) for name, unless in sorted(lexer.root_lexer.callback.items())},
        sorted(lark.ignore_tokens),
        {start: (states[table.start_states[start]], states[table.end_states[start]]) for start in lark.options.start},
        int(lark.options.g_regex_flags),
    )


def _in_order(table: Any) -> dict[int, int]:
    """Lark's states with numbers that are the same each time: as they are met from the start rules on."""
    waiting = [table.start_states[start] for start in sorted(table.start_states)]
    found: dict[int, int] = {}
    for state in waiting:
        if state not in found:
            found[state] = len(found)
            waiting += [to for _, (action, to) in sorted(table.states[state].items()) if action.name == "Shift"]
    return found


def _rule(rule: Any) -> tuple[str, str, int, bool, bool]:
    origin, helper = str(rule.origin.name), rule.origin.name.startswith("_")
    assert not (helper and (rule.alias or rule.options.expand1)), f"`{rule}` only helps and has no name of its own"
    return origin, str(rule.alias or origin), len(rule.expansion), bool(rule.options.expand1 and not rule.alias), helper


def _pattern(scanner: Any) -> str:
    """What a scanner looks for: where nothing can stand, nothing."""
    return "|".join(each.pattern for each in scanner._mres) or "(?!)"


def _from_core(_base: str | None, path: str) -> tuple[str, str]:
    """Lark's import hook: `%import core.terminals.X` reads the shared fragments."""
    found = _data(CORE, path.removeprefix("core/"))
    if found is None:
        raise OSError(path)
    return f"{CORE}/{path}", found.decode("utf-8")


def _data(package: str, file: str) -> bytes | None:
    """A file of a package; None if there is none. `importlib.resources` costs more to load than a small program takes to check."""
    try:
        found: bytes | None = pkgutil.get_data(package, file)
    except FileNotFoundError:
        return None
    return found


_DEEP = Parsed(Node("", 0, 0, ()), None, True)


def _too_deep(text: str, values: list[Any]) -> bool:
    if len(text) < DEEPEST:
        return False
    for _ in range(DEEPEST):
        parts = (value if isinstance(value, list) else getattr(value, "children", ()) for value in values)
        values = [part for each in parts for part in each]
        if not values:
            return False
    return True


def _last_tokens(parts: tuple[Node | Token, ...]) -> tuple[Part, ...]:
    return tuple(Part(token.kind, token.start, token.end) for part in parts for token in tokens(part))
