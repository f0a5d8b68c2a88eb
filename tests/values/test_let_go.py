"""What is kept of the values of a program holds nothing of it: a document that is edited away goes, however long what was found for its lines stays."""

from __future__ import annotations

import gc
from collections import OrderedDict
from weakref import ref

import pytest
from benchmarks.macros import macros

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr.values import proving
from deburr.values.graph import Node
from deburr.values.kept import Kept
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document


@pytest.mark.parametrize("name", NAMES)
def test_a_document_goes_with_its_analysis(name: str) -> None:
    dialect = by_name(name)
    document = Document.parse(macros(name, 400), dialect)
    analysis = Analysis(document, RuleSet(dialect), prove=proving)
    analysis.findings()
    gone = ref(document)
    analysis.let_go()
    del document, analysis
    gc.collect()
    assert gone() is None


# Nodes of MetaGCODE are kept by their lines, not with graphs.
@pytest.mark.parametrize("name", sorted({*NAMES} - {"metagcode"}))
def test_a_graph_that_is_kept_no_longer_goes_without_a_look_for_garbage(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialect = by_name(name)
    kept = [each for each in gc.get_objects() if isinstance(each, Kept)]
    for each in kept:
        monkeypatch.setattr(each, "_found", OrderedDict())
        monkeypatch.setattr(each, "lines", 0)
    with Analysis(Document.parse(macros(name, 400), dialect), RuleSet(dialect), prove=proving) as analysis:
        analysis.findings()
    del analysis
    gc.collect()
    several = nodes()
    gc.disable()
    try:
        for each in kept:
            each._found.clear()
        left = nodes()
        gc.collect()
        assert nodes() == left < several
    finally:
        gc.enable()


def nodes() -> int:
    """How many there are, whether anybody has them or not."""
    return sum(isinstance(each, Node) for each in gc.get_objects())
