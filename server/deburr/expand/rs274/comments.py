"""Comments that act: what `(DEBUG,..)`, `(PRINT,..)`, `(LOG,..)` and `(ABORT,..)` come to (spec/rs274.md §1.5)."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr_grammar.dialects.rs274.names import name_of

if TYPE_CHECKING:
    from deburr.expand.rs274.source import Spot
    from deburr.expand.rs274.state import State
    from deburr.fault import Halt

_ACTIVE = re.compile(r"\([ \t]*(debug|print|log|abort)[ \t]*,", re.I)
_PART = re.compile(r"%(?:d|f|\.([0-9])f|(?=\.))|#(?:<([^<>]*)>|([0-9]+))")
"""A format (a lone `%` before a point is swallowed), or a parameter."""
_SWITCH = 5599
"""The parameter that turns DEBUG off."""
_LONGEST = 29
"""Characters of a value that the control has room for."""
_NEAR_ZERO = 1e-4
_UNKNOWN = "######"
"""What it shows for the rest."""
_NONE = "#<no value>"
_FLAT = {"debug": "(MSG,{})", "print": "(PRINT,{})", "log": "(LOG,{})"}


class Comment:
    """The last comment of a line. ``plain`` ones are copied."""

    def __init__(self, state: State, spot: Spot) -> None:
        self._state = state
        self._spot = spot
        self._text = text = spot.source.said(spot.part)
        match = _ACTIVE.match(text)
        self._kind = match[1].lower() if match is not None else ""
        self._said = text[match.end() :].removesuffix(")") if match is not None else ""
        self.plain = match is None

    def flat(self) -> str:
        """The comment with values in place of parameters; nothing if it shows nothing."""
        if self.plain:
            return self._text
        if self._kind == "debug" and self._state.params[_SWITCH] <= 0:
            return ""
        said = self._filled()
        if self._kind == "abort":
            raise self._aborted(said)
        return _FLAT[self._kind].format(said)

    def _aborted(self, said: str) -> Halt:
        source, part = self._spot
        return self._state.fault(
            "abort", source.file, source.row, source.span(part), f"the program stops itself here: {said.strip()}"
        )

    def _filled(self) -> str:
        """Formats hold until the next one on the line (spec/rs274.md §1.5)."""
        form, found, at = "%.6f", [], 0
        for match in _PART.finditer(self._said):
            found.append(self._said[at : match.start()])
            at = match.end()
            if match[0] == "%d":
                form = "%.0f"
            elif match[0][0] == "#":
                found.append(self._shown(form, match))
            elif match[0] != "%":
                form = f"%.{match[1] or 4}f"
        return "".join(found) + self._said[at:]

    def _shown(self, form: str, match: re.Match[str]) -> str:
        value = self._value(match[2], match[3])
        # What counts as equal to zero is shown as zero, with however many decimals.
        said = form % (0.0 if abs(value) < _NEAR_ZERO else value) if value is not None else ""
        if said and len(said) <= _LONGEST:
            return said
        # The flat program has no such parameter either: there it is shown in the same way.
        return _UNKNOWN if self._kind == "debug" else _NONE

    def _value(self, name: str | None, number: str | None) -> float | None:
        state = self._state
        if name is not None:
            known = name_of(name)
            if (predefined := state.machine.named(known)) is not None:
                return predefined(self._spot)
            return (state.globals if known.startswith("_") else state.locals).get(known)
        at = int(number or 0)
        if at > state.last:
            return None
        return state.machine.number(at, self._spot) if at in state.machine.special else state.params[at]
