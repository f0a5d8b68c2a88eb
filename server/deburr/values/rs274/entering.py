"""RS274's calls as nodes: of subprograms with arguments, and of programs by their number (spec/rs274.md §6). Enters nothing itself."""

from __future__ import annotations

from collections.abc import Hashable

from deburr.values.domain import NO
from deburr.values.graph import Calls, Env, Flows
from deburr.values.rs274.expressions import ARGUMENTS
from deburr.values.rs274.keys import ANYTHING, is_shared
from deburr.values.rs274.lines import UNSEEN
from deburr.values.rs274.made import Made, Torn

_NO_ARGUMENTS: Env = dict.fromkeys(range(1, ARGUMENTS + 1), NO)


class Entering(Made):
    """A line that calls."""

    def call(self) -> None:
        """A call with its arguments."""
        o_line = self._compiled.o_line
        if o_line is None or o_line.find("CALL") is None or "DELETE" in self._line.node.kinds:
            raise Torn
        label, arguments = self._compiled.label, self._compiled.arguments
        expressions, behind = self._compiled.expressions, self._builder.behind(self._at)
        self._builder.callees.add(label if label is not None else UNSEEN)

        def called(env: Env, calls: Calls) -> Flows:
            passed = arguments.of(env)
            values: Env = {**_NO_ARGUMENTS, **dict(enumerate(passed, 1))}
            shared = {key: value for key, value in env.items() if is_shared(key)}
            expressions.doubtful = True
            found = calls.call(label if label is not None else UNSEEN, values, shared)
            if found is None:
                return ((behind, {key: value for key, value in env.items() if not is_shared(key)}),)
            if found.env is None:
                return ()
            written = found.written
            left = {k: v for k, v in env.items() if not is_shared(k) or (written is not None and k not in written)}
            return ((behind, {**left, **{k: v for k, v in found.env.items() if is_shared(k)}}),)

        self._builder.add(2 * self._at, self._at, called, expressions, callee=label, calls=True)

    def enter(self) -> None:
        """A line that runs a program by its number, with which it shares all but names of its own, or that may do anything."""
        expressions, behind, label = self._compiled.expressions, self._builder.behind(self._at), self._line.enters
        own = {expressions.name(param) for param in self._compiled.settings}
        is_known, is_unseen = label in self._builder.numbered, label == UNSEEN

        def entered(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            if not is_known:
                calls.call(UNSEEN, {}, {})
            kept = {} if is_unseen else {key: value for key, value in env.items() if _is_own(key) and key not in own}
            return ((behind, kept),)

        self._builder.callees.add(UNSEEN)
        sets = (None, ANYTHING) if is_unseen else (None, *own)
        self._builder.add(2 * self._at, self._at, entered, expressions, sets, calls=True)


def _is_own(key: Hashable) -> bool:
    """Whether a parameter is a name that no other program can set."""
    return isinstance(key, str) and not is_shared(key)
