"""Someone who types makes text that was never there with every key: what is kept of it has bounds. Counted in entries, not in bytes."""

from __future__ import annotations

import gc
from collections.abc import Mapping
from functools import cache
from typing import Any
from weakref import WeakSet

import pytest

from deburr.analysis import Analysis
from deburr.lsp.settings import Settings
from deburr.ruleset import RuleSet
from deburr.values import ledger, proving
from deburr.values.cgt.commands import Commands
from deburr.values.kept import Kept
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.line import Shape, Shapes, shapes_of

TYPED = 130
FEW = 20
BOUND = 200
"""Lines; more than twice of what one program has."""
LETTERS = "abcdefghij"
TEXTS: Mapping[str, str] = {
    "rs274": "o1 while [#1 LT 3]\n#<{0}> = 1\n#1 = [#1 + #<{0}>]\no1 endwhile\nG1 X[#1]\nM2\n",
    "metagcode": "#IF1 |z| lessthan {1} n\nG1 Z|z|\n#ENDIF1\n",
    "cgt": "@LINE\n#EVAL(#V1=2*{1})\n#EVAL(#V2=#V1)\n@\n",
    "z32": "HA{1}\nN10 X<HA>\n!HA=HA+10; IF HA<100; GON10!\n",
}
"""Programs that say a name or a number which is new each time."""

STORES: Mapping[str, str] = {
    "rs274": "rs274.split._graphs",
    "metagcode": "metagcode.flow._graphs",
    "cgt": "cgt.split._graphs",
    "z32": "z32.split._graphs",
}
"""Where the graphs of a dialect's programs are kept, below `deburr.values`."""


@cache
def ruleset(dialect: str) -> RuleSet:
    return RuleSet(by_name(dialect))


def word(number: int) -> str:
    return "new" + "".join(LETTERS[int(digit)] for digit in str(number))


def go_through(dialect: str, text: str) -> None:
    for _ in proving(Analysis(Document.parse(text, by_name(dialect)), ruleset(dialect), "a")):
        pass


@pytest.mark.parametrize("dialect", NAMES)
def test_shapes_that_no_document_holds_are_let_go(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Shapes, "LIMIT", FEW)
    few = RuleSet(by_name(dialect), steps=FEW)
    seen: WeakSet[Shape] = WeakSet()
    for number in range(TYPED):
        text = f"X1 ; {word(number)}" if dialect == "cgt" else f"{word(number)} ="
        document = Document.parse(f"G1 X1\n{text}\n", by_name(dialect))
        seen.update(document.node(line).shape for line in range(2))
        for _ in Analysis(document, few, "a").gathering(lambda found: iter(())):
            pass
    del document
    gc.collect()
    assert len(shapes_of(by_name(dialect))) <= FEW
    assert len(seen) <= 4 * FEW


@pytest.mark.parametrize("dialect", NAMES)
def test_what_is_kept_of_values_is_bounded_by_lines(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    graphs: Kept[Any] = Kept(BOUND)
    values: Kept[Any] = Kept(BOUND)
    where = STORES[dialect]
    monkeypatch.setattr(
        f"deburr.values.{where}", (lambda words: (Commands(words), graphs)) if dialect == "cgt" else graphs
    )
    monkeypatch.setattr(ledger, "_kept", values)
    for number in range(TYPED):
        go_through(dialect, TEXTS[dialect].format(word(number), number))
        assert graphs.lines <= BOUND
        assert values.lines <= BOUND
    # Both have been full.
    assert min(graphs.lines, values.lines) > BOUND * 3 // 4
    assert max(len(graphs), len(values)) < TYPED, (len(graphs), len(values))


def test_what_an_editor_keeps_bounds_no_other_rule_set() -> None:
    complaints: list[str] = []
    dialect = by_name("rs274")
    editors = Settings(complaints.append).ruleset(dialect, "/nowhere/a.ngc").steps
    assert (editors < RuleSet(dialect).steps, complaints) == (True, [])
