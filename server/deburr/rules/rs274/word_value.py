"""Word with a value that its code does not take.

What a word may be hangs on the code that uses it: the turns P of an arc are a whole number from 1,
a peck Q is above 0, a cycle is repeated L times, at least once, and begins above its depth, the L of `G10` is one of
0, 1, 2, 10, 11 and 20. The control stops, as with "Negative or zero q value used".

Source: spec/rs274.md §5

Bad:

    F100
    G2 X1 I0.5 P0
               ^^
    G2 X0 I-0.5 P1.5
                ^^^^
    G83 X1 Z-1 R1 Q0
                  ^^
    G81 X1 Z-1 R1 L0
                  ^^
    G81 X1 Z-1 R-2
               ^^^

Bad:

    G10 L3 P1 X0
        ^^
    G10 L2 P10 X0
           ^^^
    G10 L1 P0 Z5
           ^^
    M19 R400
        ^^^^
    M19 R90 P3
            ^^
    M66 P1 L3 Q0
              ^^
    M66 E1 L3 Q1
           ^^
    M61 Q-2
        ^^^
    M67 E-1 Q1
        ^^^

Bad:

    G41 D1.5
        ^^^^

Bad (whole):

    G18
    S100 M3
    G76 Z-10 P1 I0 J0.1 K1
                ^^
    G76 Z-10 P1 I-1 J2 K1
                       ^^
    M2

Good:

    F100
    G2 X1 I0.5 P1
    G83 X1 Z-1 R1 Q0.1 L1
    G10 L2 P9 X0
    G10 L20 P0 X0
    M19 R360
    M66 P1 L3 Q0.5
"""

from collections.abc import Iterator
from math import floor

from deburr.fixers import advised
from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import ARCS, CYCLES, Words, governs, motion, report, said, starts, values, words

_LETTERS = frozenset("DEIJKLPQRXYZ")
_NONE = -1.0
"""By this value the interpreter tells that there is no such word (spec/rs274-experiments.md)."""
_DWELLS = frozenset(("G82", "G86", "G88", "G89"))
_KINDS = (0, 1, 2, 10, 11, 20)
_DEPTH = {"G17": "Z", "G18": "Y", "G19": "X"}
Wrong = tuple[str, str]
"""A letter, and why its value is refused."""
Numbers = dict[str, float]


def _may(line: Line, state: State) -> bool:
    found = words(line)
    if not found.clear or _LETTERS.isdisjoint(found.has):
        return False
    made = motion(found, state)
    if made in ARCS:
        return "P" in found.has
    asking = {"G10", "M19", "M61", "M66", "M67", "M68", "G41", "G42", "G76"}
    return made in CYCLES or made == "G76" or not asking.isdisjoint(found.has)


@rule(Severity.ERROR, Modal(("word",), where=_may))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the word."""
    found = words(line)
    numbers = {letter: number for letter, number in values(line).items() if number is not None}
    for letter, why in _wrong(found, motion(found, state), numbers, state):
        at = found.first(letter)
        yield report(line, at, f"`{said(line, at)}` {why}; the control stops here")


def _wrong(found: Words, made: str, numbers: Numbers, state: State) -> Iterator[Wrong]:
    if made in ARCS and "P" in numbers and (not _whole(numbers["P"], 1e-3) or round(numbers["P"]) < 1):
        yield "P", "is the number of turns of the arc: it must be a whole number from 1"
    if made in CYCLES:
        yield from _of_cycle(found, made, numbers, state)
    if made == "G76":
        yield from _of_thread(numbers)
    if "M19" in found.has:
        yield from _of_orientation(numbers)
    if "G10" in found.has:
        yield from _of_setting(numbers)
    if "M66" in found.has:
        yield from _of_input(found, numbers)
    if "M61" in found.has and numbers.get("Q", 0) < -0.5:
        yield "Q", "is the number of a tool and cannot be negative"
    if not found.has.isdisjoint(("M67", "M68")) and numbers.get("E", 0) < -0.5:
        yield "E", "is the number of an output and cannot be negative"
    if (
        not found.has.isdisjoint(("G41", "G42"))
        and "D" in numbers
        and (numbers["D"] < 0 or not _whole(numbers["D"], 2e-4))
    ):
        yield "D", "is the number of a tool: it must be a whole number; a diameter is written with `G41.1` or `G42.1`"


def _of_cycle(found: Words, made: str, numbers: Numbers, state: State) -> Iterator[Wrong]:
    # To a cycle that goes on, a Q of -1 is no Q word, and the peck stays as it was.
    passed = numbers.get("Q") == _NONE and not starts(found, state, made)
    if made in ("G73", "G83") and "Q" in numbers and numbers["Q"] <= 0 and not passed:
        yield "Q", "is the depth of a peck: it must be above 0"
    if numbers.get("L") == 0:
        yield "L", "repeats the cycle no times at all; leave the line out, or write `L1`"
    if made in _DWELLS and numbers.get("P") == _NONE:
        yield "P", "is the time of the dwell and cannot be negative"
    depth = _DEPTH.get(governs(found, state, "plane") or "", "")
    if (
        governs(found, state, "distance") == "G90"
        and "R" in numbers
        and numbers.get(depth, numbers["R"]) > numbers["R"]
    ):
        yield "R", f"lies below the depth {depth}: the cycle must begin above it"


def _of_thread(numbers: Numbers) -> Iterator[Wrong]:
    if numbers.get("P") == _NONE:
        yield "P", "is the pitch of the thread and cannot be negative"
    if numbers.get("I") == 0:
        yield "I", "is where the crest of the thread lies from the start: it cannot be 0"
    if numbers.get("J", 1) <= 0:
        yield "J", "is the depth of the first cut: it must be above 0"
    elif "K" in numbers and "J" in numbers and numbers["K"] <= numbers["J"]:
        yield "K", "is the full depth of the thread: it must be more than the first cut J"


def _of_orientation(numbers: Numbers) -> Iterator[Wrong]:
    if "R" in numbers and not 0 <= numbers["R"] <= 360:
        yield "R", "is an angle of the spindle: it must be 0 to 360"
    if "P" in numbers and (not _whole(numbers["P"], 1e-3) or not 0 <= round(numbers["P"]) <= 2):
        yield "P", "says which way the spindle turns: it must be 0, 1 or 2"
    if "Q" in numbers and numbers["Q"] <= 0 and numbers["Q"] != _NONE:
        yield "Q", "is a time limit: it must be above 0"


def _of_setting(numbers: Numbers) -> Iterator[Wrong]:
    kind = numbers.get("L")
    # A fraction is another fault.
    if kind is not None and _whole(kind, 1e-4) and round(kind) not in _KINDS:
        yield "L", "is nothing that `G10` sets: L is 0, 1, 2, 10, 11 or 20"
    if kind is None or "P" not in numbers:
        return
    number = floor(numbers["P"] + 0.5) if numbers["P"] >= 0 else -floor(0.5 - numbers["P"])
    if kind in (2, 20) and not 0 <= number <= 9:
        yield "P", "is the number of a coordinate system: 0 for the active one, 1 to 9 for G54 to G59.3"
    elif kind in (1, 10, 11) and number < 1:
        yield "P", "is the number of a tool: it must be 1 or more"
    elif kind in (1, 10, 11) and not _is_orientation(numbers.get("Q", 0)):
        yield "Q", "is how a lathe tool points: it must be a whole number, 0 to 9"


def _of_input(found: Words, numbers: Numbers) -> Iterator[Wrong]:
    for letter in "PE":
        if letter in numbers and numbers[letter] < -0.5 and not {"P", "E"} <= found.has:
            yield letter, "is the number of an input and cannot be negative"
    waits = numbers.get("L", 0) >= 0.5
    if waits and "E" in found.has and "P" not in found.has:
        yield "L", "waits for a digital input; an analog one (E) can only be read at once: `L0`"
    elif waits and ("Q" not in found.has or numbers.get("Q", 1) <= 0):
        yield "Q" if "Q" in found.has else "L", "waits, and needs a limit Q above 0, in seconds"


def _is_orientation(number: float) -> bool:
    return number == _NONE or (_whole(number, 2e-4) and 0 <= round(number) <= 9)


def _whole(number: float, near: float) -> bool:
    return abs(number - round(number)) <= near


fix = advised
