"""Every rule's page: its examples give exactly that rule at exactly the marked places, and the frame alone gives nothing."""

import re

import pytest

from deburr.analysis import Analysis
from deburr.catalogue import rules_of
from deburr.rule import Ran, Rule
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from support.pages import checked, examples, refused

RULES = [(name, rule) for name in NAMES for rule in rules_of(name)]


@pytest.mark.parametrize(("dialect", "rule"), RULES, ids=[rule.name for _, rule in RULES])
def test_examples_give_exactly_the_rule_at_the_marked_places(dialect: str, rule: Rule) -> None:
    blocks = list(examples(rule, by_name(dialect)))
    assert any(not block.good for block in blocks) and any(block.good for block in blocks)
    for block in blocks:
        say = refused if rule.input and isinstance(rule.trigger, Ran) else checked
        findings = say(block, by_name(dialect), lambda each: each.default or each.name == rule.name)
        found = [(f.rule, f.place.file, f.place.line, f.place.col, f.place.end_col) for f in findings]
        places = [*(("", *place) for place in block.places), *block.elsewhere]
        assert found == [(rule.name, *place) for place in places], block.program
        assert bool(found) is not block.good


@pytest.mark.parametrize(("dialect", "rule"), RULES, ids=[rule.name for _, rule in RULES])
def test_pages_are_complete(dialect: str, rule: Rule) -> None:
    lines = rule.page.strip().split("\n")
    assert lines[0].endswith(".") and len(lines[0]) <= 80
    assert re.search(r"^Source: (?:spec/|interface\.md|deburr)", rule.page, re.M)
    assert re.fullmatch(rf"{dialect}\.[a-z0-9]+(-[a-z0-9]+)*", rule.name)


@pytest.mark.parametrize("dialect", NAMES)
def test_frame_alone_gives_nothing(dialect: str) -> None:
    language = by_name(dialect)
    program = language.frame.replace("{}\n", "").replace("{}", "")
    assert Analysis(Document.parse(program, language), RuleSet(language)).findings() == []
