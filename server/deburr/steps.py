"""Work that can be left at each of its steps, as generators. Knows nothing of what is done."""

from __future__ import annotations

from collections.abc import Callable, Generator, Hashable, Iterable, Iterator, MutableMapping
from gc import get_referents, is_tracked
from sys import getrefcount
from typing import Any, TypeVar

T = TypeVar("T")

MANY = 256
"""So many small things are done in one step."""
FEW = 32
"""So many lines are read or compiled in one step."""
_OURS = 2
"""References to an object that nothing else refers to: ours, and that of whoever counts."""


def done(work: Generator[None, None, T]) -> T:
    """What comes of work that nobody leaves."""
    while True:
        try:
            next(work)
        except StopIteration as end:
            found: T = end.value
            return found


def kept(
    memo: MutableMapping[Any, Any], key: Hashable, make: Callable[[], Generator[None, None, T]]
) -> Generator[None, None, T]:
    """What is kept under a key, or made in steps and kept when it is whole."""
    if key not in memo:
        made = yield from make()
        memo[key] = made
    found: T = memo[key]
    return found


def let_go(found: list[Any]) -> Iterator[None]:
    """Let go of objects, and of all that only they hold, some at a time: what is known of a large program takes a tenth of a second to free."""
    while found:
        for _ in range(min(MANY, len(found))):
            one = found.pop()
            # Nobody else has it: here, and as what is asked about.
            if is_tracked(one) and getrefcount(one) <= _OURS:
                found += get_referents(one)
        yield


def paced(items: Iterable[T], many: int = MANY) -> Iterator[T | None]:
    """Items, with a None behind so many of them: there the work can be left."""
    for number, item in enumerate(items, 1):
        yield item
        if not number % many:
            yield None
