"""The words of a flat line: letters and numbers. Knows no meaning."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

_WORD = re.compile(r"([A-Z@^])([-+]*(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
_COMMENT = re.compile(r"\([^()]*\)|;.*")
_SETTING = re.compile(r"#([0-9]+)=([-+]?[0-9.]+)")
_PARAMETER = re.compile(r"#([0-9]+)")
_REST = re.compile(r"[^/%\s]+")
_BLANKS = {ord(" "): None, ord("\t"): None}

Said = list[tuple[str, str]]


class Words(NamedTuple):
    """What a line holds: words as letter and number, parameters that it sets, and what is neither."""

    words: Said
    settings: Said
    rest: str


def plain(text: str) -> Said | None:
    """The words of a line that holds nothing else; None if it may hold more. Blanks count for nothing."""
    if " " in text:
        text = text.replace(" ", "")
    found: Said = _WORD.findall(text)
    return found if len("".join(map("".join, found))) == len(text) else None


def all_of(text: str, values: Mapping[int, float]) -> Words:
    """All of a line. Letters are read as capitals; comments stand in parentheses, or behind `;`. ``values``: of numbered parameters that stand in it."""
    text = _COMMENT.sub(" ", text).upper().translate(_BLANKS)
    settings = _SETTING.findall(text)
    text = _SETTING.sub(" ", text)
    if "#" in text:
        text = _PARAMETER.sub(lambda found: _value(found, values), text)
    return Words(_WORD.findall(text), settings, " ".join(_REST.findall(_WORD.sub(" ", text))))


def _value(found: re.Match[str], values: Mapping[int, float]) -> str:
    value = values.get(int(found[1]))
    return found[0] if value is None else f"{value:.17f}"


def number(said: str) -> float:
    """The value of a number; several signs may stand before it."""
    try:
        return float(said)
    except ValueError:
        bare = said.lstrip("+-")
        return -float(bare) if said.count("-") % 2 else float(bare)
