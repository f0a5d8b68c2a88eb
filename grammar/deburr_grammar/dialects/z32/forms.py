"""Forms that can be read off a line's text: block numbers, starts of sections, paths of files. Never judges them."""

import re
from collections.abc import Sequence

NUMBERED = re.compile(r"[ \t]*/?[ \t]*([Nn][ \t]*([0-9]+(?:[.,][0-9]*)?|[.,][0-9]+))(?![ \t]*[0-9.,])")
"""A block number at the start of a line: the word and its value."""
_SECTION = re.compile(r"(?m)^[ \t]*/?[ \t]*:[ \t]*([0-9]+)(?![0-9]|[.,][0-9])")
_DIGITS = 9


def number(text: str) -> float:
    """A written number: the decimal sign is a point or a comma."""
    return float(text.replace(",", "."))


def number_of(text: str) -> float | None:
    """The block number of a line; None if it has none."""
    match = NUMBERED.match(text)
    return number(match[2]) if match else None


def section_number(line: str) -> int | None:
    """The number of the section that a line starts; None if it starts none."""
    match = _SECTION.match(line)
    return int(match[1]) if match and len(match[1]) <= _DIGITS else None


def sections_in(text: str) -> frozenset[int]:
    """The numbers of the sections of a file."""
    found = _SECTION.findall(text.replace("\r", "\n"))
    return frozenset(int(each) for each in found if len(each) <= _DIGITS)


def parts(said: str) -> Sequence[str]:
    """The parts of a path; `\\` and `/` are the same."""
    return [part for part in said.replace("\\", "/").split("/") if part not in ("", ".")]
