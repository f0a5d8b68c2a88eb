"""IF with nothing to do.

If the condition holds, the fields up to the next `!` run; here there are none, so the IF decides
nothing. Most often a `!` was typed for the `;` behind the condition.

Source: spec/z32.md §6.2

Bad:

    !IF HA>1!
     ^^^^^^^
    !IF HA>1! HA=0!
     ^^^^^^^

Good:

    !IF HA>1; HA=0!
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._fields import groups, terminated
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the condition."""
    for group in groups(node) if terminated(node) else ():
        if group and group[-1].kind == "if":
            yield Report(
                whole(group[-1]), f"`{line.said(group[-1])}` decides nothing: no instruction follows before `!`"
            )
