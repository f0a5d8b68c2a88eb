"""What is kept of the values of a program holds nothing of it: a document that is edited away goes, however long what was found for its lines stays."""

from __future__ import annotations

import gc
from weakref import ref

import pytest
from benchmarks.macros import macros

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr.values import proving
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document


@pytest.mark.parametrize("name", NAMES)
def test_a_document_goes_with_its_analysis(name: str) -> None:
    dialect = by_name(name)
    document = Document.parse(macros(name, 400), dialect)
    analysis = Analysis(document, RuleSet(dialect), prove=proving)
    analysis.findings()
    gone = ref(document)
    analysis.memo.clear()
    del document, analysis
    gc.collect()
    assert gone() is None
