"""Instruction that never runs.

A jump, a call and EB end the advanced line, and a call comes back to the next block; what
stands behind them runs only if an IF before them leads past. An EB behind a jump or a call is not
needed and does no harm.

Source: spec/z32.md §6.2

Bad:

    !GOP1;HA=2!
          ^^^^
    !IF HA>1; EB; HB=2! HA=0!
                  ^^^^

Good:

    !IF HA>1; GOP1! HA=2!
    !IF HA>1; GOP1; EB! HA=2!
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import STOPS, groups
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the first field of each stretch that never runs."""
    reached, skips, stopped = True, False, ""
    for group in groups(node):
        reached, skips = reached or skips, False
        for field in group:
            if not reached:
                if field.kind == "stop":
                    continue
                if stopped:
                    yield Report(whole(field), f"`{line.said(field)}` never runs: `{stopped}` ends the line before it")
                stopped = ""
                continue
            skips = skips or field.kind == "if"
            if field.kind in STOPS:
                reached, stopped = False, line.said(field)


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave it out, with the separator before it."""
    before = re.search(r"\s*;\s*$", broken.text[: broken.span.start])
    if before is not None:
        yield Fix(f"Delete `{broken.said}`", (broken.edit(before.start(), broken.span.end, ""),))
