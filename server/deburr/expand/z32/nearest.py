"""The block numbers that may have been meant where there is none of a number: one mistyped digit, or the neighbours."""

from bisect import bisect_left
from collections.abc import Iterator, Sequence

from deburr.arithmetic.z32 import shown


def meant(numbers: Sequence[float], target: float) -> str:
    """The end of a message on a block number that does not exist. ``numbers``: those that there are, in order."""
    if not numbers:
        return "; no block has a number"
    slips = (float(variant) for variant in _slips(shown(target)))
    slip = next((variant for variant in slips if _is_in(numbers, variant)), None)
    at = bisect_left(numbers, target)
    near = [f"N{shown(number)}" for number in numbers[max(at - 1, 0) : at + 1] if number != slip]
    said = f" {'the nearest are' if len(near) == 2 else 'the nearest is'} {' and '.join(near)}" if near else ""
    return f";{said}" if slip is None else f"; did you mean N{shown(slip)}?{said}"


def _is_in(numbers: Sequence[float], number: float) -> bool:
    at = bisect_left(numbers, number)
    return at < len(numbers) and numbers[at] == number


def _slips(digits: str) -> Iterator[str]:
    """The number with two digits the other way round, or with a zero or a doubled digit too many or too few."""
    if not digits.isdigit():
        return
    cuts = [(digits[:at], digits[at:]) for at in range(len(digits))]
    yield from (left + right[1] + right[0] + right[2:] for left, right in cuts if right[1:] and right[0] != right[1])
    yield from (
        left + right[1:]
        for left, right in cuts
        if right[0] in (right[1:2], *(() if right[1:] else "0")) and left + right[1:]
    )
    yield from (left + right[0] + right for left, right in cuts)
    yield digits + "0"
