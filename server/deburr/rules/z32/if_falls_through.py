"""Both branches of an IF run.

Behind the `!` stands what runs when the condition does not hold. It also runs when the condition
holds, unless EB, a jump or a call ends the line before the `!`. That may be meant, but it is no ELSE.

Source: spec/z32.md §6.2

Bad:

    !IF HA>1; HA=1! HA=0!
     ^^^^^^^
    !IF HA>1; IF HB>1; HA=1; HB=0! HA=0!
              ^^^^^^^

Good:

    !IF HA>1; HA=1; EB! HA=0!
    !IF HA>1; GON10! HA=0!
    N10 G0 X1
"""

from collections.abc import Iterator
from itertools import pairwise

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import STOPS, groups, terminated
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the last condition of a group that runs into the next."""
    found = [group for group in groups(node) if group] if terminated(node) else []
    for group, behind in pairwise(found):
        kinds = [field.kind for field in group]
        if "if" in kinds and kinds[-1] != "if" and not any(kind in STOPS for kind in kinds):
            condition = next(field for field in reversed(group) if field.kind == "if")
            message = f"`{line.said(behind[0])}` behind the `!` runs whether `{line.said(condition)}` holds or not"
            yield Report(whole(condition), f"{message}; `EB` before the `!` makes it the other branch")


def fix(broken: Broken) -> Iterator[Fix]:
    """End the block in the first branch."""
    end = broken.text.find("!", broken.span.end)
    if end >= 0:
        yield broken.inserted(len(broken.text[:end].rstrip()), "; EB")
