"""What copied lines do to modes and position. Of a stretch of absolute straight moves and arcs only the last words count. Emits nothing."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.words import codes_of, values, words_of
from deburr_grammar.line import shapes_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deburr.expand.rs274.machine import Machine
    from deburr.expand.rs274.words import Word
    from deburr_grammar.line import Shape

_MOTIONS = {"G0": 0, "G1": 10, "G2": 20, "G3": 30}
_COMMENT = re.compile(r"\([^()]*\)|;.*")
_LETTERS = frozenset((*AXES, *"FSIJKRG"))


def follow(machine: Machine, lines: Sequence[str], shapes: Sequence[Shape]) -> None:
    """Let the machine do some plain lines."""
    easy = bytes(map({shape: is_easy(shape) for shape in set(shapes)}.__getitem__, shapes))
    at = 0
    while at < len(lines):
        end = easy.find(0, at) if machine.is_straight or _motion(shapes[at]) is not None else at
        end = len(lines) if end < 0 else end
        if end > at and machine.is_absolute:
            machine.moved(*_last(lines, shapes, at, end))
            at = end
        else:
            _one(machine, lines[at], shapes[at])
            at += 1


def is_easy(shape: Shape) -> bool:
    """Whether lines of a shape do nothing but move along lines and arcs, and set feed and speed."""
    found = shape.memo.get("rs274 easy")
    if found is None:
        words = words_of(shape)
        found = shape.memo["rs274 easy"] = (
            words is not None
            and _LETTERS.issuperset(word.letter for word in words)
            and codes_of(shape) <= _MOTIONS.keys()
        )
    return bool(found)


def _motion(shape: Shape) -> int | None:
    """The motion that a line of the shape chooses."""
    if "rs274 motion" not in shape.memo:
        shape.memo["rs274 motion"] = next((_MOTIONS[code] for code in codes_of(shape) if code in _MOTIONS), None)
    found = shape.memo["rs274 motion"]
    assert found is None or isinstance(found, int)
    return found


def _last(lines: Sequence[str], shapes: Sequence[Shape], first: int, end: int) -> tuple[int | None, dict[str, float]]:
    """The last motion and the last value of each letter in easy lines."""
    distinct = set(shapes[first:end])
    wanted = {word.letter for shape in distinct for word in _words(shape) if word.letter != "G"}
    motion, found = None, dict[str, float]()
    moves = any(_motion(shape) is not None for shape in distinct)
    for at in range(end - 1, first - 1, -1):
        words = _words(shapes[at])
        if not wanted.isdisjoint(word.letter for word in words):
            said = {word.letter: value for word, value in zip(words, values(lines[at], words)) if word.letter in wanted}
            found.update(said)
            wanted -= said.keys()
        if moves and motion is None:
            motion = _motion(shapes[at])
        if not wanted and (motion is not None or not moves):
            break
    return motion, found


def _one(machine: Machine, text: str, shape: Shape) -> None:
    words = words_of(shape)
    if words is None:
        # A comment between words: its digits are none of theirs.
        text = _COMMENT.sub(" ", text)
        words = words_of(shapes_of(shape.dialect).read(text)[0]) or ()
    machine.block([word.letter for word in words], values(text, words), False)


def _words(shape: Shape) -> tuple[Word, ...]:
    return words_of(shape) or ()
