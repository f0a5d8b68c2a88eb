"""Findings of block structure while somebody types: what an edit costs where there are thousands of them, and that they are those of a fresh program."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.ide.moved import Structure, structural, structure_of
from deburr.ruleset import RuleSet
from deburr_grammar import structure as blocks
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos
from support.pages import MemoryHost

DIALECT = by_name("rs274")
RULES = RuleSet(DIALECT)
ALLOWS = "(deburr: allow rs274.o-unclosed)"


def program(faults: int) -> str:
    """Blocks that something of another kind closes, two lines of cutting after each."""
    return "".join(f"o{at} if [#1 GT {at}]\nG1 X{at} F100\no{at} endwhile\nG1 Y1\n" for at in range(faults)) + "M2\n"


def analysed(document: Document, rules: RuleSet = RULES) -> Analysis:
    return Analysis(document, rules, "main.ngc", MemoryHost({}))


def typed(document: Document, line: int, text: str = "5", cols: int = 0) -> Document:
    end = len(document.line(line))
    return document.edit(Edit(Pos(line, end - cols), Pos(line, end), text))


def test_a_key_looks_at_few_of_many_faults(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[object] = []

    def counted(owner: Any, name: str) -> None:
        real = getattr(owner, name)
        monkeypatch.setattr(owner, name, lambda *given: (looked.append(name), real(*given))[1])

    document = Document.parse(program(5_000), DIALECT)
    structure = structure_of(analysed(document))
    assert len(structure.faults) == 5_000
    # The first key of a stretch may have to say anew how it is put together.
    document = typed(document, 10_001)
    structure = structure_of(analysed(document))
    counted(blocks.StructureFault, "moved")
    counted(blocks.StructureFault, "__new__")
    counted(blocks, "_order")
    counted(Analysis, "fault_findings")
    for number in range(10):
        document = typed(document, 10_001 + number % 2 * 2)
        now = structure_of(analysed(document))
        if not now.stays(structure):
            structural(analysed(document), now)
        structure = now
    assert len(looked) < 10 * 300


@pytest.mark.parametrize(("comment", "least"), [("(no reason)", 100), (ALLOWS, 5)])
def test_a_structure_that_is_kept_is_that_of_a_fresh_program(comment: str, least: int) -> None:
    """Any edits: as long as the findings are said to stay, those of the program as it stands are the same."""
    rng, stayed = Random(7), 0
    document = Document.parse(program(40), DIALECT, 200)
    known, found = Structure(), list[object]()
    for _ in range(200):
        line = rng.randrange(document.line_count - 1)
        sort = rng.random()
        if sort < 0.6:
            document = typed(document, line, str(rng.randint(0, 9)))
        elif sort < 0.8:
            document = typed(document, line, "", min(rng.randint(1, 4), len(document.line(line))))
        else:
            document = typed(document, line, rng.choice(("\n", "\no7 endif", f" {comment}", "\no7 do")))
        analysis = analysed(document)
        now = structure_of(analysis)
        if now.stays(known):
            stayed += 1
        else:
            found = list(structural(analysis, now))
        known = now
        fresh = analysed(Document.parse(document.text, DIALECT))
        assert found == structural(fresh, structure_of(fresh)) == structural(analysis, now)
    assert stayed >= least


def test_other_rules_find_something_else() -> None:
    document = Document.parse(program(2), DIALECT)
    strict = RuleSet(DIALECT, severities={})
    assert structure_of(analysed(document)).stays(structure_of(analysed(document)))
    assert not structure_of(analysed(document)).stays(structure_of(analysed(document, strict)))


def test_a_comment_allows_what_it_stands_at() -> None:
    document = Document.parse(program(2), DIALECT)
    before = structure_of(analysed(document))
    document = typed(document, 1, f" {ALLOWS}")
    after = structure_of(analysed(document))
    assert after.faults is before.faults
    assert not after.stays(before) and not before.stays(after)
