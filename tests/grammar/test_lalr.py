"""The tables read lines as Lark itself does: the same tree, or the same fault with all that is known of it."""

import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from lark import Lark, Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedInput

from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.problem import Part
from deburr_grammar.tree import Node, Token, tokens
from support import naive
from support.alphabets import alphabet, pieces

EXAMPLES = Path(__file__).parents[2] / "examples"


def check_reads_as_lark(dialect: Dialect, lark: Lark, line: str) -> None:
    for start in dialect.starts:
        parsed = dialect.grammar.parse(start, line)
        fault = parsed.fault
        if fault is None:
            assert as_node(lark.parse(line, start), start) == parsed.tree, line
            continue
        with pytest.raises(UnexpectedInput) as raised:
            lark.parse(line, start)
        state: Any = raised.value.state
        parts = tuple(read_before(state.value_stack))
        assert parsed.tree.children == parts, line
        assert (fault.start, fault.end, fault.found) == place(raised.value, line), line
        assert fault.stack == tuple(Part(part.kind, part.start, part.end) for part in parts), line
        read = tuple(Part(token.kind, token.start, token.end) for part in parts for token in tokens(part))
        assert fault.tokens == read, line
        assert fault.expected == fitting(state), line
        assert dialect.grammar.following(start, line) == following(lark, line, start), line


def as_node(tree: Any, start: str) -> Node:
    found = converted(tree)
    return found if isinstance(found, Node) else Node(start, found.start, found.end, (found,))


def converted(tree: Any) -> Node | Token:
    if not isinstance(tree, Tree):
        return Token(str(tree.type), tree.start_pos, tree.end_pos)
    parts = tuple(map(converted, tree.children))
    return Node(str(tree.data), parts[0].start if parts else 0, parts[-1].end if parts else 0, parts)


def read_before(values: list[Any]) -> Iterator[Node | Token]:
    for value in values:
        helper = isinstance(value, Tree) and str(value.data).startswith("_")
        yield from map(converted, value.children if helper else [value])


def place(unexpected: UnexpectedInput, line: str) -> tuple[int, int, str]:
    if isinstance(unexpected, UnexpectedCharacters):
        at = unexpected.pos_in_stream or 0
        return at, at + 1, ""
    token: Any = getattr(unexpected, "token")  # noqa: B009  Lark's own type does not say that it has one.
    return (len(line), len(line), "$END") if token.type == "$END" else (token.start_pos, token.end_pos, token.type)


def fitting(state: Any) -> frozenset[str]:
    """The terminals that a copy of the parser takes."""
    known = state.parse_conf.parse_table.states[state.state_stack[-1]]
    return frozenset(name for name in known if name.isupper() and takes(state, name))


def takes(state: Any, name: str) -> bool:
    from lark import Token as LarkToken

    copied = state.copy(deepcopy_values=False)
    copied.parse_conf = type(state.parse_conf)(state.parse_conf.parse_table, {}, state.parse_conf.start)
    try:
        copied.feed_token(LarkToken(name, ""))
    except UnexpectedInput:
        return False
    return True


def following(lark: Lark, line: str, start: str) -> frozenset[str]:
    parser = lark.parse_interactive(line, start)
    try:
        parser.exhaust_lexer()
    except UnexpectedInput:
        return frozenset()
    return fitting(parser.parser_state)


@pytest.mark.parametrize("name", NAMES)
def test_lines_of_all_sorts_are_read_as_lark_reads_them(name: str) -> None:
    """Typical lines, each with a character exchanged too, and signs put together by chance."""
    dialect, rng = by_name(name), random.Random(5)
    lark, own = dialect.grammar.build(), alphabet(dialect)
    stock = "".join(own.lines) + "".join(own.signs)
    for line in own.lines:
        check_reads_as_lark(dialect, lark, line)
        at = rng.randrange(len(line) + 1)
        check_reads_as_lark(dialect, lark, naive.lines_of(line[:at] + rng.choice(stock) + line[at + 1 :])[0])
    for _ in range(300):
        check_reads_as_lark(dialect, lark, naive.lines_of("".join(rng.choices(pieces(dialect), k=4)))[0])


@pytest.mark.parametrize("name", NAMES)
def test_examples_are_read_as_lark_reads_them(name: str) -> None:
    dialect = by_name(name)
    lark = dialect.grammar.build()
    texts = (path.read_text("utf-8", "replace") for path in sorted((EXAMPLES / name).rglob("*")) if path.is_file())
    for line in sorted({dialect.folding.fold(line) for text in texts for line in naive.lines_of(text)}):
        check_reads_as_lark(dialect, lark, line)
