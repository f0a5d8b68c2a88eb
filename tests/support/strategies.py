"""Random programs and edits. The seeds are fixed, so a run is the same each time; DEBURR_FUZZ=N makes it random and N times as long."""

from __future__ import annotations

import os
import random
from collections.abc import Iterator
from functools import cache

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

from deburr_grammar.dialect import Dialect
from deburr_grammar.text import Edit, Pos
from support.alphabets import pieces
from support.equality import Case

FACTOR = int(os.environ.get("DEBURR_FUZZ", "0"))
SIZES = (3, 3, 3, 1, 2, 5, 8, 20, 64, 300)


def steady(examples: int) -> settings:
    """Settings of a property test: that many cases, the same each time."""
    return settings(
        max_examples=examples * max(FACTOR, 1),
        derandomize=not FACTOR,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )


@cache
def texts(dialect: Dialect, most: int = 25) -> st.SearchStrategy[str]:
    """Programs of the dialect: typical lines, broken ones, and odd signs in any order."""
    return st.lists(st.sampled_from(pieces(dialect)), max_size=most).map("".join)


@cache
def edits(dialect: Dialect) -> st.SearchStrategy[Edit]:
    """Replacements anywhere, most of them short, some reaching past the end."""
    line, col = st.integers(0, 24), st.integers(0, 16)
    near = st.builds(
        lambda line, col, lines, cols, text: Edit(Pos(line, col), Pos(line + lines, cols), text),
        line,
        col,
        st.integers(0, 2),
        col,
        texts(dialect, 4),
    )
    insertion = st.builds(
        lambda line, col, text: Edit(Pos(line, col), Pos(line, col), text), line, col, texts(dialect, 3)
    )
    far = st.builds(lambda a, b, c, d, text: Edit(Pos(a, b), Pos(c, d), text), line, col, line, col, texts(dialect, 4))
    return st.one_of(near, insertion, far)


@cache
def cases(dialect: Dialect) -> st.SearchStrategy[Case]:
    """A program, up to five edits, and before which of them it is read."""
    asked = st.frozensets(st.integers(0, 4))
    return st.builds(
        Case, texts(dialect), st.lists(edits(dialect), max_size=5).map(tuple), st.sampled_from(SIZES), asked
    )


def fixed_cases(dialect: Dialect, count: int, seed: int = 1) -> Iterator[Case]:
    """Cases from a plain random generator: the same few for every mutant."""
    rng = random.Random(seed)
    stock = pieces(dialect)

    def text(most: int) -> str:
        return "".join(rng.choices(stock, k=rng.randint(0, most)))

    def edit() -> Edit:
        line, col = rng.randint(0, 12), rng.randint(0, 8)
        return Edit(Pos(line, col), Pos(line + rng.randint(0, 2), rng.randint(0, 8)), text(3))

    for _ in range(count):
        yield Case(
            text(18),
            tuple(edit() for _ in range(rng.randint(1, 4))),
            rng.choice(SIZES),
            frozenset(range(rng.randint(0, 4))),
        )
