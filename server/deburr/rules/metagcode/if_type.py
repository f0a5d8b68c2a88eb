"""Comparison type that is neither alpha nor numeric.

The type decides whether `10` is greater than `9`: as numbers it is, as text it is not. It is `a` or
`n`, and letters may follow. Anything else leaves the comparison open, so nothing is built.

Source: spec/metagcode.md §3, §6, §10

Bad:

    #IF1 |a| equalto 1 text
                       ^^^^
    #ENDIF1
    #IF1 |a| equalto 1 n1
                       ^^
    #ENDIF1
    #IF1 |a| equalto 1 |t|
                       ^^^
    #ENDIF1
    #IF1 |Peck| greaterthan n 5
                              ^
    #ENDIF1

Good:

    #IF1 |a| equalto 1 Numeric
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._letters import lettered
from deburr_grammar.dialects.metagcode.forms import condition
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_LETTERS = ("a", "A", "n", "N")


@rule(Severity.ERROR, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what stands in the type's place."""
    items = condition(node)
    if items.type.kind != "TYPE":
        said, right = line.said(items.type), line.said(items.right)
        hint = "write `a` to compare as text or `n` to compare as numbers"
        if right in _LETTERS:
            hint = f"value and type have changed places, write `{said} {right}`"
        yield Report(Span(items.type.start, items.type.end), f"`{said}` is no type; {hint}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the type that its first letter says, or let the two items change places."""
    yield from lettered(broken, "an")
