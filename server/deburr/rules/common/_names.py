"""Names of rules in comments that allow them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.suppress import comment_pattern, in_line

if TYPE_CHECKING:
    from collections.abc import Iterator


def name_left_out(broken: Broken, *, safe: bool = False) -> Iterator[Fix]:
    """The comment without the name that the fault marks; of a comment that names nothing else, nothing is left."""
    names = [each.span for each in in_line(broken.text, broken.document.dialect)]
    start, end = broken.span
    if len(names) > 1 and broken.span in names:
        after = re.match(r"\s*,\s*", broken.text[end:])
        before = re.search(r"\s*,\s*$", broken.text[:start])
        start = before.start() if before is not None and after is None else start
        end += after.end() if after is not None else 0
        yield Fix(f"Take `{broken.said}` out", (broken.edit(start, end, ""),), safe)
        return
    comment = re.compile(comment_pattern(broken.document.dialect.comments, "deburr:{}*"))
    around = next((each for each in comment.finditer(broken.text) if each.start() <= start < each.end()), None)
    if around is not None:
        alone = around[0] == broken.text.strip()
        edit = broken.without_line() if alone else broken.edit(*around.span(), "")
        # Where a program reads the numbers of its lines, a line less is another program.
        yield Fix(f"Delete `{around[0]}`", (edit,), safe and not (alone and broken.counts_lines))
