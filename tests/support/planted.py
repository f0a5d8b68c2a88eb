"""Random RS274 programs with garbage in branches that never run. Never runs one."""

from random import Random

from support.programs import Generated, generated

_PASSED = (
    "foo $$ [", ")", "G0 X1 X2", "G0 G1 X1", "#1=[1/0]", "#[[=2", "G0 X#<never set>", "/bar", "%", "G12.34", "o9001 call 5",
    "o9001 call [1/0]", "o9002 if", "o9003 repeat #1", "o9004 while [1]", "o9005 do", "o9006 endif", "M3 M4 M5", "X1.2.3", "#<open=1",
    "(ABORT,never)", "N5 N6",
)  # fmt: skip
"""What the control does not see where it passes over it."""
_SEEN = ("(a (b) c)", "G0 (open", "o9007 foo", "o1.5 if [1]", "N-5 G0")
"""What it stops at all the same."""
_SIGNS = "GXYZFMSTabc0123456789.#[]<>=+-*/$&@!'^{}%"
_HEADS = (("o{0} if [0]",), ("o{0} if [0 GT #1*0]",), ("o{0} if [1]", "o{0} else"), ("o{0} if [1]", "o{0} elseif [1]"))
_FIRST = 8_000
"""The first label that no generated program has."""


def planted(seed: int) -> Generated:
    """The program of a seed, with one to three branches of garbage somewhere between its lines."""
    rng, program = Random(seed), generated(seed)
    lines = program.text.rstrip("\n").split("\n")
    first = 1 + (lines[0].strip() == "%")
    for number in range(rng.randint(1, 3)):
        at, label = rng.randint(first, len(lines)), _FIRST + number
        head = [line.format(label) for line in rng.choice(_HEADS)]
        lines[at:at] = [*head, *(_garbage(rng) for _ in range(rng.randint(1, 3))), f"o{label} endif"]
    return Generated("\n".join(lines) + "\n", program.files, program.used, program.misuse)


def _garbage(rng: Random) -> str:
    if rng.random() < 0.04:
        return rng.choice(_SEEN)
    if rng.random() < 0.5:
        return rng.choice(_PASSED)
    text = "".join(rng.choice(_SIGNS) for _ in range(rng.randint(1, 20)))
    # Neither a line number nor an O-word, which it does see.
    return "G" + text
