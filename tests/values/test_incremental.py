"""After edits, what is kept of the program before them gives the same values as a program that is seen for the first time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, lru_cache
from inspect import unwrap
from random import Random
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr.values import ledger, values_of
from deburr.values.kept import Kept
from deburr.values.metagcode import flow
from deburr.values.metagcode import lines as metagcode
from deburr.values.program import Program
from deburr.values.rs274 import lines as rs274
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos
from support import metagcode as texts
from support import programs, templates, z32programs
from support.pages import MemoryHost
from support.values import MAIN

Source = tuple[str, dict[str, str], str]
"""A program, the files around it, and the folder that is set for those that it calls."""
EDITS = 5
PROGRAMS = 25
KEPT = (
    "deburr.values.again._kept",
    "deburr.values.ledger._kept",
    "deburr.values.ledger._latest",
    "deburr.values.rs274.split._graphs",
    "deburr.values.z32.split._graphs",
    "deburr.values.cgt.split._kept",
    "deburr.values.metagcode.flow._graphs",
)
"""Where anything is kept by what lines say."""
KEPT_LINES = ((flow, "_node"), (flow, "_made"), (metagcode, "_line"), (rs274, "_line"))
"""Where something is kept for each line."""


def _rs274(seed: int) -> Source:
    found = programs.generated(seed)
    return found.text, found.files, ""


def _z32(seed: int) -> Source:
    found = z32programs.generated(seed)
    return found.text, found.files, str(found.settings["cmos-dir"])


def _cgt(seed: int) -> Source:
    return templates.template(Random(seed)), {}, ""


def _metagcode(seed: int) -> Source:
    return texts.program(Random(seed)), {}, ""


SOURCES: dict[str, Callable[[int], Source]] = {
    "rs274": _rs274,
    "z32": _z32,
    "cgt": _cgt,
    "metagcode": _metagcode,
}


@pytest.mark.parametrize("dialect", SOURCES)
def test_what_is_kept_gives_the_same_values(dialect: str) -> None:
    told = sum(_compared(dialect, seed) for seed in range(PROGRAMS))
    assert told > PROGRAMS


def test_a_stale_answer_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof that values are compared: with what was told before taken for what is told now, some differ."""
    monkeypatch.setattr(ledger, "_told_alike", lambda versions, asked, program: [] if asked else _believed(versions))
    with _fresh(), pytest.raises(AssertionError, match="seed"):
        for seed in range(10 * PROGRAMS):
            _compared("rs274", seed)


def _believed(versions: list[Any]) -> list[Any]:
    known = versions[0]
    return [known._replace(solved=known.solved._replace(asked=[]))]


def _compared(dialect: str, seed: int) -> int:
    """Edit the program of a seed; after how many edits anything was said of it."""
    text, files, folder = SOURCES[dialect](seed)
    language, host, rules = by_name(dialect), MemoryHost(files), _rules(dialect, folder)
    document, rng, told = Document.parse(text, language), Random(seed), 0
    values_of(Analysis(document, rules, MAIN, host))
    for number in range(EDITS):
        document = document.edit(_edit(document, rng))
        kept = _said(values_of(Analysis(document, rules, MAIN, host)))
        with _fresh():
            new = _said(values_of(Analysis(Document.parse(document.text, language), rules, MAIN, host)))
        assert kept == new, f"seed {seed}, edit {number}"
        told += bool(new)
    return told


@cache
def _rules(dialect: str, folder: str) -> RuleSet:
    return RuleSet(by_name(dialect), {**z32programs.SETTINGS, "cmos-dir": folder} if dialect == "z32" else {})


def _edit(document: Document, rng: Random) -> Edit:
    """Another digit, a line less, or a line twice."""
    line = rng.randrange(document.line_count)
    text, sort = document.line(line), rng.random()
    digits = [col for col, sign in enumerate(text) if sign.isdigit()]
    if sort < 0.7 and digits:
        col = rng.choice(digits)
        return Edit(Pos(line, col), Pos(line, col + 1), str(rng.randint(0, 9)))
    if sort < 0.85 and line + 1 < document.line_count:
        return Edit(Pos(line, 0), Pos(line + 1, 0), "")
    return Edit(Pos(line, 0), Pos(line, 0), f"{text}\n")


@contextmanager
def _fresh() -> Iterator[None]:
    """With nothing kept."""
    with pytest.MonkeyPatch.context() as patch:
        for name in KEPT:
            patch.setattr(name, Kept[Any]())
        for module, name in KEPT_LINES:
            patch.setattr(module, name, lru_cache(unwrap(getattr(module, name))))
        yield


def _said(program: Program | None) -> dict[str, Any]:
    """All that is known of a program, node by node."""
    if program is None:
        return {}
    general = program.general
    for _ in general.solving() if general is not program else ():
        pass
    return {**_of(program), **{f"general {name}": said for name, said in _of(general).items()}}


def _of(program: Program) -> dict[str, Any]:
    return {
        name: {
            "entry": program.entry(name),
            "summary": program.summary(name),
            "before": solved.solution.before,
            "targets": {node: solved.solution.targets(node) for node in solved.solution.before},
            "proofs": {node: (proof.kind, proof.span) for node, proof in solved.solution.proofs.items()},
            "remarks": {node: (proof.kind, proof.span) for node, proof in solved.solution.remarks.items()},
            "doubtful": solved.solution.doubtful,
            "called": solved.called,
        }
        for name, solved in program.solved.items()
    }
