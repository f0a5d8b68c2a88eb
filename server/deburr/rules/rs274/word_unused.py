"""Word that no code on the line uses.

The words D, E, H, I, J, K, L, P, Q, R and $ mean something only together with a code that takes
them. Without one the control stops, as with "P word with no G2 G3 G4 ... to use it". A motion in
force takes its words only on a line with axis words; an arc also takes I, J and K alone. `1e3` is
the number 1 and an E word.

Source: spec/rs274.md §5

Bad:

    P1
    ^^
    G0 X1 I1
          ^^
    G54 H1
        ^^
    G0 X1e2
         ^^

Bad:

    G17 F100
    G2 X1 I0.5
    P2
    ^^

Bad:

    F100
    G81 X1 Z-1 R1
    X2 Q1
       ^^

Good:

    F100
    G2 X1 I0.5 P1
    I1
    G43 H1
    G81 X1 Z-1 R1
    X2 R2
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import UNKNOWN, motion, node, report, said, users, value, words

_LETTERS = frozenset("DEHIJKLPQR$")


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report each word without a code that takes it."""
    found = words(line)
    if _LETTERS.isdisjoint(found.has) or not found.clear:
        return
    made = motion(found, state)
    for at, letter in enumerate(found.letters):
        if letter in _LETTERS and not _is_used(line, letter, found.has, made) and not _passed(line, at, letter):
            yield report(line, at, f"nothing on this line uses `{said(line, at)}`{_hint(line, letter, made)}")


def _is_used(line: Line, letter: str, has: frozenset[str], made: str) -> bool:
    takers = users(line.node.dialect, letter)
    if not takers.isdisjoint(has) or made in takers or (letter == "$" and "S" in has):
        return True
    return made == UNKNOWN and any(taker[0] == "G" for taker in takers)


def _passed(line: Line, at: int, letter: str) -> bool:
    """Whether the interpreter may take the word for none: it tells by a Q of -1 that there is no Q word."""
    return letter == "Q" and value(line, node(line, at)) in (None, -1)


def _hint(line: Line, letter: str, made: str) -> str:
    """Which codes take the word, the motion that does not first."""
    takers = sorted(users(line.node.dialect, letter), key=lambda code: (code[0], float(code[1:].partition("-")[0])))
    not_by = f"; `{made}` does not" if made and made != UNKNOWN else ""
    return f"{not_by}; {letter} belongs to {', '.join(takers)}; the control stops here"
