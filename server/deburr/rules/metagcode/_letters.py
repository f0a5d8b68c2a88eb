"""Items of directives that are one letter."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.finding import Fix

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.fix import Broken


def lettered(broken: Broken, letters: str) -> Iterator[Fix]:
    """The letter that the item begins with, or two items that change places."""
    swapped = re.search(r"changed places, write `([^`]+)`", broken.finding.message)
    if swapped is not None:
        items = re.search(rf"\S+\s+{re.escape(broken.said)}$", broken.text[: broken.span.end])
        if items is not None:
            yield Fix(f"Change to `{swapped[1]}`", (broken.edit(items.start(), broken.span.end, swapped[1]),))
    elif broken.said[:1].lower() in letters:
        yield broken.replaced(broken.said[0].lower())
