"""The checks have teeth: each core invariant, broken on purpose, is noticed. A mutant whose text is gone from the source must be written anew."""

from __future__ import annotations

import inspect
import re
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from types import ModuleType
from typing import Any
from unittest import mock

import pytest

from deburr_grammar import chunk, document, editing, fold, line, outline, search, shape, structure, text
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import by_name
from deburr_grammar.line import LineNode, shapes_of
from deburr_grammar.text import Edit, Pos
from support import naive
from support.equality import Case, check, check_reading
from support.strategies import fixed_cases

DIALECT = by_name("rs274")
USERS = (document, editing, fold, outline, search, chunk)
"""Modules that import each other's functions by name."""


@contextmanager
def rewritten(module: ModuleType, name: str, old: str, new: str) -> Iterator[None]:
    """A function of a module, or a method written `Class.method`, with one piece of its source exchanged."""
    holder: Any = module
    *outer, last = name.split(".")
    for part in outer:
        holder = getattr(holder, part)
    source = textwrap.dedent(inspect.getsource(inspect.getattr_static(holder, last)))
    assert source.count(old) == 1, f"the mutant of {name} no longer applies: {old!r} is not in\n{source}"
    scope = dict(vars(module))
    exec(compile("from __future__ import annotations\n" + source.replace(old, new), module.__name__, "exec"), scope)
    with ExitStack() as stack:
        for user in {holder, *(USERS if not outer else ())}:
            if hasattr(user, last):
                stack.enter_context(mock.patch.object(user, last, scope[last]))
        yield


@contextmanager
def cold() -> Iterator[None]:
    """No answer from before helps a mutant, and none of its own outlives it."""
    forget()
    yield
    forget()


def forget() -> None:
    outline._step.cache_clear()
    line._parse.cache_clear()
    shapes_of(DIALECT).clear()


def cases() -> Iterator[Case]:
    """Hand-made cases for each mutant, then random ones."""
    programs = (
        "o1 if [1]\n  o2 while [1]\n  G1 X1\n  o2 endwhile\no1 endif\nM2\n",
        "o1 sub\no1 endsub\nG0 X1\rG0 X2\r\nX3\n(a 1)\n",
        "G1 X10 M2\nG0 X100 (comment 12)\n(DEBUG, #12 and #<a>)\no5 if [1]\n",
    )
    for program in programs:
        for size in (3, 20, 300):
            yield Case(program, (Edit(Pos(0, 0), Pos(0, 0), "o9 endif\n\n"),), size, frozenset({0}))
            yield Case(
                program,
                (Edit(Pos(1, 0), Pos(1, 0), "o3 sub\nM2\no3 endsub\n"), Edit(Pos(0, 0), Pos(1, 0), "")),
                size,
                frozenset({0, 1}),
            )
            yield Case(
                program, (Edit(Pos(0, 99), Pos(0, 99), "\r"), Edit(Pos(1, 0), Pos(1, 0), "\n")), size, frozenset({0, 1})
            )
            yield Case(
                program, (Edit(Pos(2, 1), Pos(2, 2), "\r"), Edit(Pos(3, 0), Pos(4, 0), "\nX")), size, frozenset({0, 1})
            )
    yield Case("aaa\rb\n", (Edit(Pos(1, 0), Pos(1, 1), ""),), 3, frozenset({0}))
    yield Case("o1 if [1]\no2 sub\no1 endif\no2 endsub\no1 if [1]\n", (), 300)
    yield Case(
        "G1 X1\n" * 40, (Edit(Pos(0, 0), Pos(10, 3), ""), Edit(Pos(3, 1), Pos(12, 1), "")), 64, frozenset({0, 1})
    )
    yield from fixed_cases(DIALECT, 60)


def run_all(checks: Sequence[Callable[..., None]]) -> None:
    for case in cases():
        for each in checks:
            each(DIALECT, case)


def check_shapes(dialect: Dialect, case: Case) -> None:
    """Trees and problems from shapes equal those of the lines."""
    for said in naive.lines_of(case.text):
        node = LineNode(said, dialect.readings[0], shapes_of(dialect)[dialect.folding.fold(said)])
        tree, problems = naive.read_directly(dialect, node.reading.start, said)
        assert (node.tree, node.problems) == (tree, problems)


CHECKS = (check, check_reading, check_shapes)

MUTANTS = {
    "a newline does not join the carriage return before it": (editing, "replaced", 'text[a : a + 1] == "\\n"', "False"),
    "a newline joins no carriage return of another chunk": (editing, "replaced", "elif not a", "elif False"),
    "line starts behind the edit are not shifted": (
        editing,
        "_patched",
        "start + moved for start in kept",
        "start for start in kept",
    ),
    "shapes behind the edit are shifted by one": (
        editing,
        "_patched",
        "below[damage.last + 1 :]",
        "below[damage.last + 2 :] + below[-1:]",
    ),
    "every line of a chunk is read anew": (editing, "_patched", "above is None or below is None", "True"),
    "line starts of a joined chunk are not shifted": (editing, "_joined", "start + len(region.text)", "start"),
    "pieces keep the line starts of the whole": (editing, "_cut", "start - a for start", "start for start"),
    "faults are kept with absolute lines": (structure, "Reduction.moved", "not lines or self == NOTHING", "True"),
    "a summary is kept without the state before it": (
        outline,
        "Outliner.key",
        "(self.facts, before.state,",
        "(self.facts, None,",
    ),
    "a summary is kept without the depth before it": (
        outline,
        "Outliner.key",
        "before.balance.openers if node.needs_depth else -1",
        "-1",
    ),
    "a branch sums its children without their depth": (
        outline,
        "Outliner._sum",
        "running.then(found.balance)",
        "running",
    ),
    "a fold forgets the state that it came with": (
        fold,
        "carried",
        "(fold, state, outliner.key(node, before))",
        "(fold, outliner.key(node, before))",
    ),
    "a fold ignores where readings change": (fold, "through", "runs.get(index, reading)", "reading"),
    "closers are not carried over a stretch": (structure, "Balance.then", "self.closers + left", "self.closers"),
    "a cut does not cut": (structure, "Balance.then", "after.openers if after.cut else", ""),
    "pairs across chunks are not compared": (
        structure,
        "Reduction.then",
        "if (found := _compared(*pair))",
        "if (found := None)",
    ),
    "a search runs over region boundaries": (search, "_scan", "bracket.role in CUTS", "False"),
    "a search skips a stretch by its closers alone": (search, "Partners._visit", "depth - near + far", "depth - near"),
    "digits of G and M codes are folded": (shape, "_fold_digits", "codes & digits", "codes & 0"),
    "a code ends at its first digit": (shape, "_fold_digits", "kept |= more", "pass"),
    "a blank before a code's number ends it": (shape, "_fold_digits", "if codes & blanks or", "if"),
    "a point ends a code": (shape, "_fold_digits", "or behind & points or", "or"),
    "columns forget that digits were folded": (
        shape,
        "Columns.__call__",
        "col + self.growths",
        "col + 0 * self.growths",
    ),
}


@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_mutant_is_caught(name: str) -> None:
    module, function, old, new = MUTANTS[name]
    with (
        cold(),
        rewritten(module, function, old, new),
        pytest.raises((AssertionError, IndexError, ValueError, StopIteration, RuntimeError)),
    ):
        run_all(CHECKS)


def test_mutant_that_splits_at_form_feeds_is_caught() -> None:
    """A mutant of the endings themselves: what counts as one."""
    with cold(), mock.patch.object(text, "EOL", re.compile(r"\r\n|[\n\r\f\x85\u2028]")), pytest.raises(AssertionError):
        run_all([check])


def test_mutant_that_drops_active_comments_is_caught() -> None:
    """Over-eager folding: the body of a comment that says something."""
    folding = shape.Folding(DIALECT.folding.codes, "", r"\((?<=(\())[^()\n]*(\))|;(?<=(;))[^\n]*")
    dialect = replace(DIALECT, folding=folding)
    with cold(), pytest.raises(AssertionError):
        for case in cases():
            check(dialect, case)


def test_mutant_that_keeps_a_stale_step_is_caught() -> None:
    """An outline's answer kept by the line's text alone, whatever the state before it."""
    kept: dict[object, object] = {}
    step = outline._step.__wrapped__

    def stale(dialect: Any, facts: Any, state: Any, depth: int, shape: Any, said: str) -> Any:
        return kept.setdefault(said, step(dialect, facts, state, depth, shape, said))

    stale.cache_clear = lambda: None  # type: ignore[attr-defined]
    with cold(), mock.patch.object(outline, "_step", stale), pytest.raises(AssertionError):
        run_all([check])


def test_the_core_itself_passes() -> None:
    """What the mutants are measured against."""
    with cold():
        run_all(CHECKS)
