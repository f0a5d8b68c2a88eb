"""Random RS274 programs of loops that a counter, a branch or nothing ends. Never runs one."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random


def generated(seed: int) -> str:
    """The program of a seed: one to three loops behind each other, some of them in others."""
    rng = Random(seed)
    lines = ["G21 G90 G17 F100", *(f"#{at}={rng.randint(-2, 3)}" for at in range(1, 5))]
    for label in range(100, 100 + 10 * rng.randint(1, 3), 10):
        lines += _loop(rng, label, 2)
    return "\n".join([*lines, "M2"]) + "\n"


def _loop(rng: Random, label: int, depth: int) -> Iterator[str]:
    counter = rng.randint(1, 3)
    step = rng.choice(("+1", "+1", "+2", "-1", "*1", "+0", "+#4"))
    condition = f"#{counter} {rng.choice(('LT', 'LT', 'LE', 'NE', 'GT'))} {rng.randint(-3, 8)}"
    condition = rng.choice((condition, condition, condition, "1", f"[#4 GT 0] AND [{condition}]"))
    body = [f"#{counter}=[#{counter}{step}]", *_body(rng, label, counter, depth)]
    if rng.random() < 0.3:
        body.reverse() if len(body) == 2 else body.append(f"#{counter}={rng.randint(0, 2)}")
    yield f"#{counter}={rng.randint(-1, 5)}" if rng.random() < 0.7 else "G0 X1"
    if rng.random() < 0.7:
        yield from (f"o{label} while [{condition}]", *body, f"o{label} endwhile")
    else:
        yield from (f"o{label} do", *body, f"o{label} while [{condition}]")


def _body(rng: Random, label: int, counter: int, depth: int) -> Iterator[str]:
    sort = rng.random()
    if sort < 0.3:
        asked = f"#{rng.choice((counter, 4))} {rng.choice(('GT', 'LT', 'EQ'))} {rng.randint(-4, 20)}"
        then = rng.choice((f"o{label} break", "M2", f"#{counter}=[#{counter}+1]", f"#{counter}=-50", "#4=[#4-1]"))
        yield from (f"o{label + 1} if [{asked}]", then, f"o{label + 1} endif")
    elif sort < 0.45 and depth:
        yield from _loop(rng, label + 5 - depth, depth - 1)
    else:
        yield f"G0 X#{rng.randint(1, 4)}"
