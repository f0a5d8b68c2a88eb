"""What is made of two things, made again of the same two: the object that it was then. So after an edit what is alike is mostly the same object. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TypeVar

from deburr.values.kept import Kept

One = TypeVar("One", bound=Collection[object])
Two = TypeVar("Two", bound=Collection[object])
Made = TypeVar("Made")
_VARIABLES = 20_000
"""Variables in all that something is kept of: some megabytes."""
_kept: Kept[tuple[Collection[object], Collection[object], object]] = Kept(_VARIABLES)
"""What was made, with what it was made of: as long as it is kept, no other object can be in the place of that."""


def again(make: Callable[[One, Two], Made], one: One, two: Two) -> Made:
    """What ``make`` gives, which may hang on nothing but the two. Nobody may change them, nor what it gives."""
    key = (make, id(one), id(two))
    found = _kept.get(key)
    if found is None:
        found = _kept.add(key, (one, two, make(one, two)), len(one) + len(two))
    made: Made = found[2]  # type: ignore[assignment]  # what was kept under it was made by it
    return made
