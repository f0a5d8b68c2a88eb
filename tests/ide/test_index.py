"""The index of names: what it finds by region is what a look at every line finds."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.symbols.index import all_symbols, mentions_of, on_line, region
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

    holds()
