"""Words taken out of the lists that declare them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken

if TYPE_CHECKING:
    from collections.abc import Iterator


def undeclared(broken: Broken) -> Iterator[Fix]:
    """The list without the word that the fault marks; a list of nothing else goes with its line."""
    start, end = broken.span
    before = re.search(r"\s*,\s*$", broken.text[:start])
    after = re.match(r"\s*,\s*", broken.text[end:])
    title = f"Take `{broken.said}` out"
    if before is not None:
        yield Fix(title, (broken.edit(before.start(), end, ""),))
    elif after is not None:
        yield Fix(title, (broken.edit(start, end + after.end(), ""),))
    elif not broken.text[end:].strip():
        yield Fix(title, (broken.without_line(),))
