"""Where the keys of a TOML file stand: the library that reads it tells places only of faults in the syntax. Never decides what a key means."""

import re

_PART = r"""(?:"[^"]*"|'[^']*'|[\w-]+)"""
_KEY = re.compile(rf"\s*({_PART}(?:\s*\.\s*{_PART})*)\s*=")


def line_of(text: str, path: tuple[str, ...]) -> int | None:
    """The line on which a key of a TOML file stands, as far as it is spelled plainly; else that of the table around it."""
    table: tuple[str, ...] = ()
    best = (0, 0)
    for number, line in enumerate(text.split("\n"), 1):
        if header := re.match(r"\s*\[\[?([^\[\]]+)\]", line):
            here = table = _keys(header[1])
        elif key := _KEY.match(line):
            here = (*table, *_keys(key[1]))
        else:
            continue
        if path[: len(here)] == here and len(here) > best[0]:
            best = (len(here), number)
    return best[1] or None


def _keys(said: str) -> tuple[str, ...]:
    return tuple(match[0].strip("\"'") for match in re.finditer(_PART, said))
