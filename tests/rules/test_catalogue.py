"""Rules as an index knows them are the rules in their files; what the index does not know of is loaded."""

import pytest

from deburr.catalogue import loaded, rule_names, rules_of
from deburr.rule import Modal, Nodes, Rule, Whole
from deburr.rules.cgt import _index
from deburr.ruleset import Searched
from deburr_grammar.dialects import NAMES


def weighed(rule: Rule) -> tuple[object, ...]:
    """All that decides whether a rule is asked, but for what it is asked by."""
    trigger = rule.trigger
    where = isinstance(trigger, Nodes | Modal) and trigger.where is not None
    ready = isinstance(trigger, Whole) and trigger.ready is not None
    plain = trigger._replace(where=None) if isinstance(trigger, Nodes | Modal) else trigger
    plain = trigger._replace(ready=None) if isinstance(trigger, Whole) else plain
    return rule.short, rule.severity, rule.default, rule.input, rule.met is not None, plain, where, ready


@pytest.mark.parametrize("name", NAMES)
def test_rules_are_known_as_they_are_in_their_files(name: str) -> None:
    known = {rule.module: weighed(rule) for rule in rules_of(name)}
    assert known == {
        rule.module: weighed(rule)
        for rule in (*loaded("deburr.rules.common"), *loaded(f"deburr.rules.{name}"))
        if rule.module in known
    }
    assert tuple(rule.name for rule in rules_of(name)) == rule_names(name)


def test_a_rule_of_which_the_index_does_not_know_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = [weighed(rule) for rule in rules_of("cgt")]
    monkeypatch.setattr(_index, "ROWS", _index.ROWS[1:])
    assert [weighed(rule) for rule in rules_of("cgt")] == wanted


def test_lines_are_searched_by_the_signs_with_which_matches_start() -> None:
    text = "a\n(x;x\n;y\n\n(x(x"
    for signs in ("(;", ";(", ""):
        assert list(Searched("[(;]x", signs).lines(text)) == [1, 4]
        assert Searched("[(;]x", signs).found(text) and not Searched("[(;]z", signs).found(text)
    assert list(Searched("^x", "").lines("x\ny\nx")) == [0, 2]
