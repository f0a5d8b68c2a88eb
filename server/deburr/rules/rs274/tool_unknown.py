"""Tool that is not in the tool table.

Where the setting `tool-table` (`--tool-table`) gives the machine's tools, the control must find there each tool that a line selects
(T, `M61`), whose length it takes (`G43`, `G43.2`), whose radius it compensates (`G41`, `G42`), or which it measures (`G10` with L1, L10 or
L11). 0 is no tool and always there. The control stops with "Requested tool not found in the tool table". Without a table nothing is said.

Source: spec/rs274.md §5

Bad (tool-table=tool.tbl):

    T9 M6
    ^^
    T1 M6
    G43 H9
        ^^
    -- tool.tbl --
    T1 P1 Z25.4 D6.35

Good (tool-table=tool.tbl):

    T1 M6
    G43 H1
    -- tool.tbl --
    T1 P1 Z25.4 D6.35

Good:

    T9 M6
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.formats.tools import read
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.rs274._words import report, said, values, words
from deburr.steps import paced
from deburr_grammar.dialect import Reading
from deburr_grammar.line import Shape

_WORDS = re.compile("[TtHhDdQqPp]")
_NAMED_BY = {"T": (), "H": ("G43", "G43.2"), "D": ("G41", "G42"), "Q": ("M61",), "P": ("G10",)}
"""The codes for which a letter names a tool; T does by itself."""
_MEASURES = (1, 10, 11)
"""The L words with which the P of `G10` is a tool."""


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the word that names the tool."""
    path = str(analysis.settings["tool-table"])
    text = analysis.host.read(path) if path else None
    table = None if text is None else read(text)
    if table is None or table.faults:
        return
    name = path.rpartition("/")[2]
    for at in paced(_lines(analysis)):
        if at is None:
            yield None
            continue
        line = Line(analysis.document.node(at), analysis.settings)
        for letter, number in _tools(line):
            if number not in table.words:
                word = words(line).first(letter)
                message = f"`{said(line, word)}` is tool {number}, which the tool table `{name}` does not have"
                yield report(line, word, f"{message}; the control stops here")._replace(line=at)


def _lines(analysis: Analysis) -> Iterator[int]:
    """The lines that may name a tool."""
    for piece in analysis.document.pieces():
        yield from (piece.line + index for index, _, _ in piece.where(_may_name))


def _may_name(reading: Reading, shape: Shape) -> bool:
    return "word" in shape.facts(reading).kinds and bool(_WORDS.search(shape.text))


def _tools(line: Line) -> Iterator[tuple[str, int]]:
    """The tools that a line names for certain, each with the letter of its word."""
    found = words(line)
    if not found.clear:
        return
    numbers = values(line)
    for letter, codes in _NAMED_BY.items():
        number = numbers.get(letter)
        named = not codes or not found.has.isdisjoint(codes)
        # A fraction or a number below 0 is no tool in any table: other rules say so.
        if number and named and number > 0 and number.is_integer() and (letter != "P" or numbers.get("L") in _MEASURES):
            yield letter, int(number)
