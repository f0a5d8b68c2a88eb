"""Programs in the memory of the control, which here is a folder or the sections of a file (spec/z32.md §6.4)."""

import re
from collections.abc import Set as AbstractSet

from deburr.host import Host

_SECTION = re.compile(r"(?m)^[ \t]*/?[ \t]*:[ \t]*([0-9]+)")
_NUMBERED = re.compile(r"([0-9]+)(?:\.[^.]*)?")


def sections_in(text: str) -> AbstractSet[int]:
    """The numbers of the sections of a file."""
    return {int(number) for number in _SECTION.findall(text.replace("\r", "\n")) if len(number) <= 9}


def programs(host: Host, folder: str) -> AbstractSet[int]:
    """The numbers of the programs in a folder: files named so, and sections of the files there."""
    found: set[int] = set()
    for name in host.names(folder):
        if match := _NUMBERED.fullmatch(name):
            found.add(int(match[1]))
        found |= sections_in(host.read(f"{folder}/{name}") or "")
    return found
