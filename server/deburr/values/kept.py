"""What was found for some lines, kept by what they say: bounded by the lines in all, since that is what its memory hangs on."""

from __future__ import annotations

from collections import OrderedDict
from functools import lru_cache
from typing import TYPE_CHECKING, Generic, TypeVar

from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from collections.abc import Hashable

    from deburr_grammar.dialect import Reading
    from deburr_grammar.document import Piece
    from deburr_grammar.line import Shape

T = TypeVar("T")
LINES = 1_000
"""Lines of all that is kept in one place: a graph and its values take some hundred bytes to some kilobytes for each of them."""


class Kept(Generic[T]):
    """The last things used, by their keys. What was added last is kept however large it is: someone works on it."""

    def __init__(self, lines: int = LINES) -> None:
        self._least = self._most = lines
        self._found: OrderedDict[Hashable, tuple[int, T]] = OrderedDict()
        self.lines = 0
        """Lines of all that is kept; each thing counts for one at least."""

    def __len__(self) -> int:
        return len(self._found)

    def fit(self, lines: int) -> None:
        """Make room for things of so many lines, the ones before the last edit beside the ones behind it: all of one program are asked for in turn."""
        self._most = max(self._least, 2 * lines)

    def get(self, key: Hashable) -> T | None:
        """What is kept, which is thereby the last used."""
        found = self._found.get(key)
        if found is None:
            return None
        self._found.move_to_end(key)
        return found[1]

    def add(self, key: Hashable, value: T, lines: int) -> T:
        """Keep a thing of so many lines, and let go of those that were not used for longest."""
        old = self._found.pop(key, None)
        weight = max(lines, 1)
        self.lines += weight - (old[0] if old is not None else 0)
        self._found[key] = weight, value
        while self.lines > self._most and len(self._found) > 1:
            self.lines -= self._found.popitem(last=False)[1][0]
        return value


def line_of(piece: Piece, index: int) -> LineNode:
    """A line of a piece: one that says the same as before is the same, so that what hangs on it need not be found again."""
    return _line(piece.chunk.line(index), piece.outlined.reading(index), piece.chunk.shapes[index])


@lru_cache(maxsize=LINES)
def _line(text: str, reading: Reading, shape: Shape) -> LineNode:
    return LineNode(text, reading, shape)
