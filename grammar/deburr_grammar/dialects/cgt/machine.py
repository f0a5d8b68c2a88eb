"""Which sections are tables because a machine file says so (spec/cgt.md §11, *Words*). Never opens a file, never reports anything."""

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

from deburr_grammar.dialects.cgt.outline import SECTIONS


def table_words(settings: Mapping[str, Any], read: Callable[[str], str | None]) -> frozenset[str]:
    """The words of type `table` in the machine file: a section of such a name holds rows."""
    path = settings.get("machine")
    return _in(read(path) or "") if path else frozenset()


@lru_cache(maxsize=8)
def _in(text: str) -> frozenset[str]:
    import tomllib

    try:
        words = tomllib.loads(text).get("words")
    except (tomllib.TOMLDecodeError, RecursionError):
        return frozenset()
    named = words.items() if isinstance(words, dict) else ()
    return frozenset(name for name, kind in named if kind == "table") - SECTIONS
