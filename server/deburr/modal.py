"""Modal state along the text of a program: which code of each group is in force. Never guesses: where runs may differ, it is unknown.

A textual fold is not a run. In a block that may be a loop nothing is known that the block has not
set itself, behind a block only what its writes have left alone or all its branches agree in; in
a region (a subprogram, a section) and behind a call nothing is known. States are objects that
are made once for each combination, and remember where each line's effect leads them, so a long
program costs two look-ups a line.
"""

from __future__ import annotations

from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from deburr_grammar.dialect import Bracket, Dialect, Effect, Modality, Reading, Role
from deburr_grammar.line import LineNode, Shape

if TYPE_CHECKING:
    from collections.abc import Hashable, Iterable, Mapping, Sequence

UNKNOWN = "?"
"""The value of a group of which two runs may think differently."""
UNSET = ""
"""The value of a group that the program has not touched yet."""
_DEEPEST = 64
_LIMIT = 50_000
T = TypeVar("T")


class Modes:
    """A value for each group: a code, UNKNOWN or UNSET. Equal ones are one object, so identity is equality."""

    __slots__ = ("others", "values")

    def __init__(self, values: Mapping[str, str], others: str) -> None:
        self.values = values
        self.others = others

    def __getitem__(self, group: str) -> str:
        return self.values.get(group, self.others)


class _Block(NamedTuple):
    """A block that is open: what held before it, what its finished branches left (None: there is none yet), the groups written in it."""

    kind: str
    before: Modes
    left: Modes | None
    written: frozenset[str]
    everything: bool


class State:
    """What holds between two lines. Equal ones are one object."""

    __slots__ = ("after", "blocks", "modes", "outside", "too_deep")

    def __init__(self, modes: Modes, blocks: tuple[_Block, ...], too_deep: int, outside: State | None) -> None:
        self.modes = modes
        self.blocks = blocks
        self.too_deep = too_deep
        self.outside = outside
        self.after: dict[Effect, State] = {}

    def code(self, group: str) -> str | None:
        """The code of a group that is in force; None where that is not certain or none is."""
        return self.modes[group] if self.modes[group] not in (UNKNOWN, UNSET) else None

    def untouched(self, group: str) -> bool:
        """Whether it is certain that the program has not set the group yet."""
        return self.modes[group] == UNSET


class Modal:
    """The fold of one dialect: make one with `modal_of`. States are kept under it."""

    only_brackets = False

    def __init__(self, dialect: Dialect, modality: Modality) -> None:
        self._dialect = dialect
        self._modality = modality
        self._known: dict[Hashable, Any] = {}
        self._none = self._modes({}, UNKNOWN)
        self.start = self._state(self._modes({}, UNSET), (), 0, None)

    def plain(self, state: State, reading: Reading, shape: Shape) -> State:
        """The state behind a line without brackets."""
        effect = shape.memo.get((self, reading.name))
        if effect is None:
            effect = shape.memo[self, reading.name] = self._effect(reading, shape)
        if effect is _NO_EFFECT:
            return state
        assert isinstance(effect, Effect)
        found = state.after.get(effect)
        if found is None:
            found = state.after[effect] = self._then(state, effect)
        return found

    def marked(self, state: State, line: LineNode, brackets: Sequence[Bracket]) -> State:
        """The state behind a line that may open or close blocks and regions."""
        state = self.plain(state, line.reading, line.shape)
        for bracket in brackets:
            state = self._through(state, bracket)
        return state

    @cached_property
    def _groups(self) -> Mapping[str, str | None]:
        """The group of each code; None of one that is in force on its own line alone."""
        codes = self._dialect.codes
        modal = {entry.name for entry in codes.table("group") if entry.more.get("modal", True)}
        lasting = (entry for entry in codes.table("code") if entry.more.get("modal", True))
        return {entry.name: group for entry in lasting if (group := entry.more.get("group")) in modal}

    def _effect(self, reading: Reading, shape: Shape) -> Effect:
        if reading.start is None:
            return _NO_EFFECT
        found = self._modality.effect(LineNode(shape.text, reading, shape))
        found = found._replace(codes=tuple(code for code in found.codes if code.isalpha() or code in self._groups))
        return found if found != _NO_EFFECT else _NO_EFFECT

    def _then(self, state: State, effect: Effect) -> State:
        before = self._none if effect.arrives else state.modes
        pairs = dict.fromkeys(effect.unsets, UNSET) | dict(self._pair(code) for code in effect.codes)
        modes = self._modes({**before.values, **pairs}, before.others)
        if effect.maybe:
            modes = self._joined(before, modes)
        everything = effect.arrives or effect.leaves
        return self._wrote(self._with(state, self._none if effect.leaves else modes), pairs, everything)

    def _pair(self, code: str) -> tuple[str, str]:
        """The group that a code writes, and what it then holds; the letter of a word is a group of its own."""
        return self._groups.get(code) or code, code

    def _through(self, state: State, bracket: Bracket) -> State:
        match bracket.role:
            case Role.OPEN:
                return self._opened(state, bracket.kind)
            case Role.CLOSE:
                return self._closed(state)
            case Role.MIDDLE:
                return self._branched(state, bracket.kind)
            case Role.REGION:
                return self._state(self._none, (), 0, state.outside or state)
            case Role.END_REGION:
                return state.outside or state

    def _opened(self, state: State, kind: str) -> State:
        if len(state.blocks) >= _DEEPEST:
            return self._wrote(self._state(self._none, state.blocks, state.too_deep + 1, state.outside), (), True)
        block = _Block(kind, state.modes, None, frozenset(), False)
        modes = state.modes if kind in self._modality.once else self._none
        return self._state(modes, (*state.blocks, block), state.too_deep, state.outside)

    def _closed(self, state: State) -> State:
        if state.too_deep:
            return self._state(state.modes, state.blocks, state.too_deep - 1, state.outside)
        if not state.blocks:
            return state
        *outer, block = state.blocks
        if block.everything:
            modes = self._none
        elif block.kind in self._modality.once:
            modes = self._joined(self._joined(block.before, block.left or block.before), state.modes)
        else:
            # It may have run never, once or often, and may have been left in its middle.
            modes = self._modes({**block.before.values, **dict.fromkeys(block.written, UNKNOWN)}, block.before.others)
        behind = self._state(modes, tuple(outer), 0, state.outside)
        return self._wrote(behind, block.written, block.everything)

    def _branched(self, state: State, kind: str) -> State:
        """Another branch begins, from what held before the block."""
        if state.too_deep or not state.blocks or state.blocks[-1].kind != kind or kind not in self._modality.once:
            return state
        *outer, block = state.blocks
        left = self._joined(block.left, state.modes) if block.left is not None else state.modes
        return self._state(block.before, (*outer, block._replace(left=left)), 0, state.outside)

    def _wrote(self, state: State, groups: Iterable[str], everything: bool) -> State:
        if not state.blocks:
            return state
        *outer, block = state.blocks
        block = block._replace(written=block.written.union(groups), everything=block.everything or everything)
        return self._state(state.modes, (*outer, block), state.too_deep, state.outside)

    def _joined(self, one: Modes, two: Modes) -> Modes:
        """What holds where two ways meet."""
        if one is two:
            return one
        others = one.others if one.others == two.others else UNKNOWN
        groups = {*one.values, *two.values}
        return self._modes({group: one[group] if one[group] == two[group] else UNKNOWN for group in groups}, others)

    def _with(self, state: State, modes: Modes) -> State:
        return self._state(modes, state.blocks, state.too_deep, state.outside)

    def _modes(self, values: Mapping[str, str], others: str) -> Modes:
        values = {group: value for group, value in values.items() if value != others}
        return self._once((frozenset(values.items()), others), Modes(values, others))

    def _state(self, modes: Modes, blocks: tuple[_Block, ...], too_deep: int, outside: State | None) -> State:
        return self._once((modes, blocks, too_deep, outside), State(modes, blocks, too_deep, outside))

    def _once(self, key: Hashable, new: T) -> T:
        """The one object for a key. Forgotten when there are too many: then equal states may be two, and folds run on further."""
        if len(self._known) >= _LIMIT:
            self._forget()
        found: T = self._known.setdefault(key, new)
        return found

    def _forget(self) -> None:
        for known in self._known.values():
            if isinstance(known, State):
                known.after.clear()
        self._known.clear()


_NO_EFFECT = Effect()


@cache
def modal_of(dialect: Dialect) -> Modal | None:
    """The fold of a dialect; None where it does not say what its lines do."""
    return Modal(dialect, dialect.modality) if dialect.modality is not None else None
