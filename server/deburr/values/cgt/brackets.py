"""What the tests of conditional brackets and `#IFCHG` ask of what was output last (spec/cgt.md §5.2, §11). Knows no flow."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.values.cgt.conditions import Ways
from deburr.values.cgt.outcomes import tracked
from deburr.values.domain import NO, YES

if TYPE_CHECKING:
    from deburr.templates.items import Body
    from deburr.templates.symbols import Word
    from deburr.values.cgt.words import Shown, Vocabulary
    from deburr.values.graph import Env


class Changed(NamedTuple):
    """The words that are tested, each with whether it must have changed, too; None: one that changes by itself."""

    words: tuple[tuple[bool, Shown | None], ...]
    computed: tuple[Word, ...]

    @property
    def keys(self) -> tuple[Shown, ...]:
        """The keys that are asked."""
        return tuple(key for _, key in self.words if key is not None)

    def ways(self, env: Env) -> Ways:
        """Where the test holds and where it does not. A bracket without words is always output."""
        if not self.words:
            return Ways(env, None)
        known = self._known(env)
        then = env if known is not False else None
        otherwise = env if known is not True else None
        if then is not None and len(self.words) == 1:
            then = {**then, **dict.fromkeys(self.keys, NO)}
        if otherwise is not None and not any(both for both, _ in self.words[1:]):
            otherwise = {**otherwise, **dict.fromkeys(self.keys, YES)}
        return Ways(then, otherwise)

    def _known(self, env: Env) -> bool | None:
        found: bool | None = None
        for at, (both, key) in enumerate(self.words):
            value = env.get(key) if key is not None else None
            changed = None if value is None or value not in (YES, NO) else value == NO
            found = changed if at == 0 else _joined(both, found, changed)
        return found


def tested(body: Body, words: Vocabulary) -> Changed:
    """What a bracket tests."""
    found: list[tuple[bool, Shown | None]] = []
    computed: list[Word] = []
    both = False
    for item in body.items():
        if item.kind == "operator":
            if item.name == "EXC":
                break
            both = item.name == "AND"
        elif item.kind == "word":
            word = words.find(item.name) if item.name else None
            found.append((both, tracked(word, words)))
            if word is not None and words.computes(word):
                computed.append(word)
    return Changed(tuple(found), tuple(dict.fromkeys(computed)))


def _joined(both: bool, one: bool | None, two: bool | None) -> bool | None:
    decisive = not both
    if one is decisive or two is decisive:
        return decisive
    return None if one is None or two is None else both
