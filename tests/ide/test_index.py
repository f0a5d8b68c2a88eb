"""The index of names: what it finds by region is what a look at every line finds."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.symbols import SOUGHT
from deburr.symbols.index import all_symbols, between, locals_of, mentions_of, on_line, region
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.strategies import steady

LINES = (
    "o<a> sub",
    "o<a> endsub",
    "o<b> sub",
    "o<b> endsub",
    "#<x>=1",
    "#1=#<x>",
    "G0 X#1",
    "",
    "o<a> return",
    "#<_x>=#<y>",
)


@pytest.mark.parametrize("size", [3, 20, 300])
def test_names_of_a_region_are_found_without_a_look_into_others(size: int) -> None:
    @given(st.lists(st.sampled_from(LINES), max_size=25))
    @steady(150)
    def holds(lines: list[str]) -> None:
        document = Document.parse("\n".join(lines), by_name("rs274"), size)
        seen = [
            (number, mention, region(document, number) if mention.symbol.local else None)
            for number in range(document.line_count)
            for mention in on_line(document, number)
        ]
        regions = {region(document, number) for number in range(document.line_count)}
        for symbol in all_symbols(document):
            for where in regions if symbol.local else (None,):
                expected = [each for each in seen if each[1].symbol == symbol and each[2] == where]
                assert list(mentions_of(document, symbol, where)) == expected
        for where in regions:
            named = Counter(each[1].symbol for each in seen if each[1].symbol.local and each[2] == where)
            sought = {symbol: min(several, 2) for symbol, several in named.items() if symbol.sort in SOUGHT}
            assert locals_of(document, where) == sought

    holds()


@pytest.mark.parametrize("size", [3, 300])
def test_what_is_named_between_two_lines(size: int) -> None:
    document = Document.parse("\n".join(LINES), by_name("rs274"), size)
    for first in range(len(LINES)):
        for last in range(first, len(LINES) + 2):
            found = [(line, each.symbol.name, each.span) for line, each in between(document, first, last)]
            expected = [
                (line, each.symbol.name, each.span)
                for line in range(first, min(last + 1, len(LINES)))
                for each in on_line(document, line)
                if each.symbol.sort in SOUGHT and not each.passing
            ]
            assert sorted(found) == sorted(expected)
