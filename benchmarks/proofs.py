"""What proven values cost: the first time, and after an edit in one routine. Each function runs in a process of its own."""

from __future__ import annotations

from random import Random
from statistics import median
from time import process_time

from benchmarks.macros import macros
from deburr.analysis import Analysis
from deburr.lsp import garbage
from deburr.ruleset import RuleSet
from deburr.values import values_of
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos

_EDITS = 20


def proven(dialect: str, lines: int) -> tuple[float, float]:
    """Seconds of the processor until the values of a program are known that is read already, and the median after edits of one digit.

    Memory is looked through as in the server, where people wait for them.
    """
    rules = RuleSet(by_name(dialect))
    # The modules are loaded with the first program of a language.
    values_of(Analysis(_read(macros(dialect, lines, seed=2), dialect), rules))
    document, random = _read(macros(dialect, lines), dialect), Random(1)
    garbage.begin()
    first = _spent(document, rules)
    taken = []
    for _ in range(_EDITS):
        document = document.edit(_edit(document, random))
        taken.append(_spent(document, rules))
    return first, median(taken)


def _read(text: str, dialect: str) -> Document:
    document = Document.parse(text, by_name(dialect))
    assert not document.faults and not list(document.problems()), f"the program for {dialect} is right"
    return document


def _spent(document: Document, rules: RuleSet) -> float:
    start = process_time()
    assert values_of(Analysis(document, rules)) is not None, "the program has values"
    taken = process_time() - start
    garbage.set_aside()
    return taken


def _edit(document: Document, random: Random) -> Edit:
    """Another number behind a sign, in any routine."""
    while True:
        line = random.randrange(document.line_count)
        text = document.line(line)
        cols = [
            col for col in range(1, len(text)) if text[col].isdigit() and text[:col].endswith(("+", "*", "-", " F"))
        ]
        if cols and not text.startswith((":", "o", "N")):
            return Edit(Pos(line, cols[0]), Pos(line, cols[0] + 1), str(random.randint(1, 9)))
