"""Code that is not possible while cutter compensation is on.

Between `G41` or `G42` and `G40` the control refuses another plane, origin, tool or tool offset,
canned cycles, probing, splines, overrides, outputs and inputs, a `G10` of the coordinate system in force, and
compensation cannot be switched on twice. Compensation exists in G17 and G18 only. The control stops, as with "Cannot change planes
with cutter radius compensation on".

Source: spec/rs274.md §5

Bad:

    G41 D1
    G55
    ^^^

Bad:

    G41 D1
    G42 D1
    ^^^

Bad:

    G41.1 D5
    G28 X0
    ^^^

Bad:

    G41 D1
    G10 L20 P0 X0
    ^^^

Bad:

    G19
    G41 D1
    ^^^

Good:

    G41 D1
    G10 L2 P3 X50
    G40
    G55
"""

from collections.abc import Iterator

from deburr.fixers import line_before
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._moves import SYSTEMS, active_system
from deburr.rules.rs274._words import Words, governs, in_force, motion, report, said, values, words
from deburr_grammar.dialects.rs274.modality import AXES

_ON = frozenset(("G41", "G41.1", "G42", "G42.1"))
_REFUSED_CODES = (
    "G5 G5.1 G28 G28.1 G30 G30.1 G38.2 G38.3 G38.4 G38.5 G43 G43.1 G43.2 G49 G52 G53 G54 G55 G56 G57 G58"
    " G59 G59.1 G59.2 G59.3 G61 G61.1 G64 G71 G71.1 G71.2 G72 G72.1 G72.2 G73 G74 G76 G81 G82 G83 G84 G85"
    " G86 G87 G88 G89 G92 G98 G99 M6 M48 M49 M50 M51 M52 M53 M62 M63 M64 M65 M66 M67 M68"
)
_REFUSED = _ON | frozenset(_REFUSED_CODES.split())
_PLANES = frozenset(("G17", "G18", "G19"))


def _may(line: Line, state: State) -> bool:
    found = words(line)
    return any(True for _ in _of_codes(line, found, state)) or ("G10" in found.has and _behind(found, state) in _ON)


@rule(Severity.ERROR, Modal(("word",), where=_may))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the code."""
    found = words(line)
    yield from _of_codes(line, found, state)
    if found.clear and _behind(found, state) in _ON and _sets_active(line, found, state):
        at = found.first("G10")
        yield report(
            line,
            at,
            f"`{said(line, at)}` sets the coordinate system in force while cutter compensation is on; write `G40` before it",
        )


def _of_codes(line: Line, found: Words, state: State) -> Iterator[Report]:
    if not found.clear:
        return
    codes = [(at, code) for at, code in enumerate(found.codes) if code]
    made = motion(found, state)
    if made not in found.has and found.axes:
        codes.append((found.first(*AXES), made))
    before = in_force(state, "cutter-compensation")
    behind = _behind(found, state)
    for at, code in codes:
        # The M codes and the plane come before compensation is switched on or off, all else comes behind.
        first = code[:1] == "M" or code in _ON | _PLANES
        if (before if first else behind) in _ON and (code in _REFUSED or _is_other_plane(code, state)):
            yield report(
                line, at, f"`{said(line, at)}` is not possible while cutter compensation is on; write `G40` before it"
            )
        elif code in _ON and governs(found, state, "plane") not in ("G17", "G18", None):
            yield report(
                line, at, f"`{said(line, at)}` is possible in `G17` and `G18` only; another plane is in force here"
            )


def _behind(found: Words, state: State) -> str | None:
    return governs(found, state, "cutter-compensation")


def _sets_active(line: Line, found: Words, state: State) -> bool:
    """Whether it is certain that a G10 sets the system in force."""
    if "G10" not in found.has:
        return False
    numbers = values(line)
    kind, number = numbers.get("L"), numbers.get("P")
    if kind is None or number is None or round(kind) not in (2, 20) or round(number) not in range(10):
        return False
    return round(number) == 0 or SYSTEMS[round(number) - 1] == active_system(state)


def _is_other_plane(code: str, state: State) -> bool:
    return code in _PLANES and in_force(state, "plane") not in (None, code)


fix = line_before
