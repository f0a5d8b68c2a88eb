"""Which ends of blocks belong together, and which mistake explains an end that has no other. Never looks at files.

An end that does not fit the innermost open block has a wrong word or number, is one too many,
comes before the end of a block inside, or shows that such an end is missing. What leaves the
brackets behind it the most sensible is taken, so that one mistake is one fault and the blocks
around it stay known (`spec/metagcode.md` §4).
"""

from collections.abc import Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import islice
from typing import NamedTuple

from deburr.rules.metagcode._words import keyword_meant
from deburr.steps import MANY
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.metagcode.outline import UNKNOWN
from deburr_grammar.structure import Fault, Placed, StructureFault

_AHEAD = 60
"""How many ends behind one that does not fit are looked at, and how far outward its opener is looked for."""
ENDS = ("#ENDIF", "#ENDLOOP")
"""What a bare `#END` may be."""
_TRIED = 200
"""After so many ends that do not fit, words and numbers say nothing any more."""


@dataclass(frozen=True, slots=True)
class Meant(Bracket):
    """A bracket that a misspelt directive was to be; another rule speaks of it."""


class Visit(NamedTuple):
    """A bracket on the way through the text, and the blocks that are open before it, outermost first."""

    placed: Placed
    around: Sequence[Placed]


class Pair(NamedTuple):
    """A block that is opened and closed, and in how many others it stands."""

    opener: Placed
    closer: Placed
    depth: int


class _Why(Enum):
    MISLABELLED = "it was to close the innermost block"
    LEFT_OUT = "the blocks inside the one that it closes have no end"
    CROSSED = "a block inside the one that it closes ends later"
    SURPLUS = "it closes nothing"


class _Remedy(NamedTuple):
    """What is wrong with an end, and how far inside the block lies that it closes: the innermost is -1."""

    why: _Why
    depth: int = -1


def ties(opener: Bracket, closer: Bracket) -> bool:
    """Whether two ends belong together; a missing label fits any."""
    return opener.kind == closer.kind and (opener.label == closer.label or None in (opener.label, closer.label))


def meant(bracket: Bracket, end: str) -> Bracket:
    """A directive that does not exist as the one that was meant, `#END` as ``end``; any other as it is."""
    if bracket.kind != UNKNOWN:
        return bracket
    word = end if bracket.word == "#END" else keyword_meant(bracket.word)
    if word is None or word == "#FILE":
        return bracket
    closes = word.startswith("#END")
    kind = word.removeprefix("#END").removeprefix("#").lower()
    return Meant(Role.CLOSE if closes else Role.OPEN, kind, word, bracket.label, bracket.span)


def matching(brackets: Sequence[tuple[int, Bracket]]) -> "Generator[None, None, Matching]":
    """The blocks of brackets in reading order, matched in steps."""
    found = Matching(brackets)
    yield from found.match()
    return found


class Matching:
    """The blocks of brackets in reading order, once they are matched."""

    def __init__(self, brackets: Sequence[tuple[int, Bracket]]) -> None:
        self._brackets = brackets
        self._remedies: dict[int, _Remedy] = {}
        self._faults: list[StructureFault] = []
        self.pairs: list[Pair] = []
        """The blocks whose ends belong together, in the order of their ends."""

    @property
    def faults(self) -> list[StructureFault]:
        """The ends without another, in the order of their lines."""
        return sorted(self._faults, key=lambda fault: (fault.at.line, fault.at.bracket.span))

    def visits(self) -> Iterator[Visit]:
        """Every bracket in order. The blocks around it are only to be looked at before the next one is asked for."""
        around: list[Placed] = []
        for at, (line, bracket) in enumerate(self._brackets):
            placed = Placed(line, bracket)
            yield Visit(placed, around)
            if bracket.role is Role.OPEN:
                around.append(placed)
            elif bracket.role is Role.CLOSE:
                _close(around, self._remedies.get(at))

    def match(self) -> Iterator[None]:
        """Match them, in steps."""
        around: list[Placed] = []
        for at, (line, bracket) in enumerate(self._brackets):
            if at and not at % MANY:
                yield
            if bracket.role is Role.OPEN:
                around.append(Placed(line, bracket))
            elif bracket.role is Role.CLOSE:
                closer = Placed(line, bracket)
                if around and ties(around[-1].bracket, bracket):
                    self.pairs.append(Pair(around[-1], closer, len(around) - 1))
                else:
                    remedy = self._remedies[at] = self._remedy(at, around)
                    self._faults += _faults(remedy, closer, around)
                _close(around, self._remedies.get(at))
        self._faults += [StructureFault(Fault.UNCLOSED, opener) for opener in around]

    def _remedy(self, at: int, around: Sequence[Placed]) -> _Remedy:
        """The remedy that leaves the fewest faults behind it."""
        if not around:
            return _Remedy(_Why.SURPLUS)
        if len(self._remedies) >= _TRIED:
            return _Remedy(_Why.MISLABELLED)
        open_ = [placed.bracket for placed in around[-_AHEAD:]]
        ahead = [bracket for _, bracket in self._brackets[at + 1 : at + 1 + 2 * _AHEAD] if bracket.role in _BLOCKS]
        whole = at + 1 + 2 * _AHEAD >= len(self._brackets)

        def cost(remedy: _Remedy) -> int:
            left = list(open_)
            _close(left, remedy)
            own = -remedy.depth - 1 if remedy.why is _Why.LEFT_OUT else 1
            return own + _mismatches(left, ahead, whole)

        return min(_remedies(open_, self._brackets[at][1]), key=cost)


_BLOCKS = (Role.OPEN, Role.CLOSE)


def _remedies(around: Sequence[Bracket], closer: Bracket) -> Iterator[_Remedy]:
    """What may be wrong with an end, the likeliest first."""
    yield _Remedy(_Why.MISLABELLED)
    fitting = (-up for up, opener in enumerate(reversed(around), 1) if ties(opener, closer))
    for depth in islice(fitting, 1):
        yield _Remedy(_Why.LEFT_OUT, depth)
        yield _Remedy(_Why.CROSSED, depth)
    yield _Remedy(_Why.SURPLUS)


def _close(around: list[Placed] | list[Bracket], remedy: _Remedy | None) -> None:
    """Take away what an end closes; None: it fits."""
    if remedy is None or remedy.why is _Why.MISLABELLED:
        around.pop()
    elif remedy.why is _Why.LEFT_OUT:
        del around[remedy.depth :]
    elif remedy.why is _Why.CROSSED:
        del around[remedy.depth]


def _faults(remedy: _Remedy, closer: Placed, around: Sequence[Placed]) -> list[StructureFault]:
    match remedy.why:
        case _Why.MISLABELLED:
            return [StructureFault(Fault.MISMATCH, closer, around[-1])]
        case _Why.LEFT_OUT:
            return [StructureFault(Fault.UNCLOSED, opener, closer) for opener in around[remedy.depth + 1 :]]
        case _Why.CROSSED:
            return [StructureFault(Fault.CROSSED, closer, around[-1])]
        case _Why.SURPLUS:
            return [StructureFault(Fault.UNOPENED, closer)]


def _mismatches(around: list[Bracket], ahead: Iterable[Bracket], whole: bool) -> int:
    """How many ends fit badly by depth alone; ``whole``: nothing follows, so what is left open counts too."""
    found = 0
    for bracket in ahead:
        if bracket.role is Role.OPEN:
            around.append(bracket)
        elif not around or not ties(around.pop(), bracket):
            found += 1
    return found + (len(around) if whole else 0)
