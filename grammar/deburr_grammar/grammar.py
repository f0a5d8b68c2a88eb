"""A dialect's Lark grammar at work: one line in, a tree or a fault out. Never looks at more than one line.

The tables that Lark builds from `line.lark` ship beside it as `line.tables`
(`python -m deburr_grammar.tables` writes them, a test proves them fresh), because
building them costs some thirty times as much as loading them.
"""

from __future__ import annotations

import io
import pickle
import pkgutil
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr_grammar.problem import Part, SyntaxFault
from deburr_grammar.tree import Node, Token, tokens

if TYPE_CHECKING:
    from lark import Lark

CORE = "deburr_grammar.core"
DEEPEST = 256
"""Levels of a tree: no line of 256 characters has more, and whoever walks a tree may do so by recursion."""
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
        from lark.exceptions import UnexpectedInput

        try:
            tree = self._lark.parse(text, start)
        except UnexpectedInput as unexpected:
            if _too_deep(unexpected.state.value_stack):
                return _DEEP
            return _faulty(text, start, unexpected)
        return _DEEP if _too_deep([tree]) else Parsed(_as_node(tree, start), None)

    def following(self, start: str, text: str) -> frozenset[str]:
        """The terminals that could follow the start of a line; none if that itself cannot be read."""
        from lark.exceptions import UnexpectedInput

        parser = self._lark.parse_interactive(text, start)
        try:
            parser.exhaust_lexer()
        except UnexpectedInput:
            return frozenset()
        return _accepted(parser.parser_state)

    def build(self) -> Lark:
        """The parser, made from the grammar text."""
        from lark import Lark

        source = (_data(self._package, "line.lark") or b"").decode("utf-8")
        return Lark(source, start=list(self._starts), import_paths=[_from_core], **_OPTIONS)

    def tables(self) -> bytes:
        """The content of `line.tables`."""
        buffer = io.BytesIO(self._key)
        buffer.seek(0, io.SEEK_END)
        self.build().save(buffer)
        return buffer.getvalue()

    @property
    def fresh(self) -> bool:
        """Whether `line.tables` is there and made from the grammar as it is."""
        return (_data(self._package, "line.tables") or b"").startswith(self._key)

    @cached_property
    def _lark(self) -> Lark:
        from lark import Lark

        tables = _data(self._package, "line.tables")
        key = self._key
        if tables is None or not tables.startswith(key):
            # Tables of another grammar or of another Lark: slower, never wrong.
            return self.build()
        try:
            return Lark.load(io.BytesIO(tables[len(key) :]))
        except (
            pickle.UnpicklingError,
            AttributeError,
            EOFError,
            ImportError,
            IndexError,
            KeyError,
            TypeError,
            ValueError,
        ):
            return self.build()

    @property
    def _key(self) -> bytes:
        """All that the tables are made from. It stands before them, so they say for themselves whether they are fresh."""
        from lark import __version__

        source = _data(self._package, "line.lark") or b""
        imported = [_data(CORE, f"{name.decode()}.lark") for name in re.findall(rb"(?m)^%import core\.(\w+)", source)]
        return repr((__version__, sorted(_OPTIONS.items()), self._starts, source, imported)).encode()


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


def _too_deep(parts: list[Any]) -> bool:
    for _ in range(DEEPEST):
        parts = [child for part in parts for child in getattr(part, "children", ())]
        if not parts:
            return False
    return True


def _as_node(tree: Any, start: str) -> Node:
    node = _convert(tree)
    return node if isinstance(node, Node) else Node(start, node.start, node.end, (node,))


def _convert(tree: Any) -> Node | Token:
    if not hasattr(tree, "children"):
        return Token(str(tree.type), tree.start_pos, tree.end_pos)
    children = tuple(_convert(child) for child in tree.children)
    if not children:
        return Node(str(tree.data), 0, 0, ())
    return Node(str(tree.data), children[0].start, children[-1].end, children)


def _faulty(text: str, start: str, unexpected: Any) -> Parsed:
    from lark.exceptions import UnexpectedCharacters

    token: Any = getattr(unexpected, "token", None)
    at: int
    if isinstance(unexpected, UnexpectedCharacters):
        at, found = int(unexpected.pos_in_stream or 0), ""
        end = at + 1
    elif token is not None and token.type != "$END":
        at, end, found = token.start_pos, token.end_pos, str(token.type)
    else:
        at, end, found = len(text), len(text), "$END"
    parts = tuple(_read_before(unexpected.state.value_stack))
    stack = tuple(Part(part.kind, part.start, part.end) for part in parts)
    tree = Node(start, parts[0].start if parts else 0, parts[-1].end if parts else 0, parts)
    return Parsed(tree, SyntaxFault(text, at, end, found, _accepted(unexpected.state), stack, _last_tokens(parts)))


def _accepted(state: Any) -> frozenset[str]:
    """The terminals that could stand next. The lookahead sets of an LALR state hold too many, so each is tried."""
    states = state.parse_conf.parse_table.states
    return frozenset(
        name
        for name in states[state.state_stack[-1]]
        if name.isupper() or name == "$END"
        if _fits(states, state.state_stack, name)
    )


def _fits(states: Any, stack: list[Any], terminal: str) -> bool:
    stack = list(stack)
    while True:
        found = states[stack[-1]].get(terminal)
        if found is None:
            return False
        action, argument = found
        if action.name == "Shift":
            return True
        # A reduction: the rule's parts leave the stack, the rule itself takes their place.
        size = len(argument.expansion)
        del stack[len(stack) - size :]
        stack.append(states[stack[-1]][argument.origin.name][1])


def _read_before(values: list[Any]) -> Iterator[Node | Token]:
    from lark import Tree

    for value in values:
        # A helper rule of a repetition (`__block_star_0`) is no part of the tree: only what it holds is.
        helper = isinstance(value, Tree) and value.data.startswith("_")
        for part in value.children if helper else [value]:
            yield _convert(part)


def _last_tokens(parts: tuple[Node | Token, ...]) -> tuple[Part, ...]:
    return tuple(Part(token.kind, token.start, token.end) for part in parts for token in tokens(part))
