"""Fixes over LinuxCNC's programs in which the hand has slipped once: they come to an end, and what is safe leaves what the interpreter makes of a program that it takes.

A few programs for each kind of slip; all of them if DEBURR_FUZZ asks for more.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from random import Random

import pytest

from deburr.analysis import Analysis
from deburr.mend import mended
from deburr_grammar.document import Document
from support.flat import DIALECT, RULES, Case
from support.oracle import SAMPLES
from support.samples import sample
from support.slips import SLIPS

pytestmark = pytest.mark.oracle
EVERY = int(os.environ.get("DEBURR_FUZZ", "1")) > 1
LONGEST = 100_000 if EVERY else 2_500
"""Characters of a program."""
MOST = 1_000 if EVERY else 4
"""Programs for each kind."""


RUNS = {"allowance left behind", "label of a return mistyped"}
"""Slips that a safe fix mends and the interpreter does not mind."""


@cache
def programs() -> list[Case]:
    paths = [path for path in SAMPLES.rglob("*.ngc") if path.stat().st_size <= LONGEST]
    return [sample(path) for path in sorted(paths)]


def mutants(kind: str) -> Iterator[Case]:
    """Programs with a slip, each time the same ones; those come first in which it can happen."""
    random, found = Random(kind), 0
    cases = list(programs())
    random.shuffle(cases)
    for case in cases:
        text = SLIPS[kind](case.text, random)
        if text is not None and text != case.text and found < MOST:
            found += 1
            yield replace(case, text=text)


def fixed(case: Case, text: str, *, unsafe: bool) -> str:
    def look(document: Document) -> Analysis:
        return Analysis(document, RULES, case.main, case.host)

    return mended(Document.parse(text, DIALECT), look, unsafe=unsafe).document.text


@pytest.mark.parametrize("kind", SLIPS)
def test_fixes_of_slips(kind: str) -> None:
    seen = compared = 0
    for case in mutants(kind):
        seen += 1
        for unsafe in (False, True):
            once = fixed(case, case.text, unsafe=unsafe)
            assert fixed(case, once, unsafe=unsafe) == once, (case.name, unsafe)
            if not unsafe and once != case.text and case.original.status == 0:
                compared += 1
                behind = replace(case, text=once).original
                assert (behind.status, behind.calls) == (0, case.original.calls), (case.name, behind.message)
    assert seen, "no program has a place for it"
    assert compared or kind not in RUNS, "nothing was mended that the interpreter takes"
