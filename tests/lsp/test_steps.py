"""How much a check does between two moments at which a key that is pressed meanwhile is looked at: a bounded amount, however long the program is."""

from __future__ import annotations

import pytest

from deburr_grammar.dialects import NAMES
from support.large import large
from support.pace import Effort, drive

PARTS = 350
"""Of some ten lines each."""
MOST = 120_000
"""Calls of functions in one step, which take about 30 ms. To read a template of this length at once takes some 580,000."""


@pytest.mark.parametrize("dialect", NAMES)
def test_no_step_of_a_check_does_much(dialect: str) -> None:
    # What is loaded with the first program of a language is no part of what a check does.
    drive(Effort(), dialect, large(dialect, 20))
    effort = Effort()
    drive(effort, dialect, large(dialect, PARTS))
    assert 0 < effort.most < MOST, effort.where
