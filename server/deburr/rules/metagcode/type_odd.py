"""Comparison type that only begins like one.

Only the first letter of the type counts, so `never` compares as numbers and `always` as text. What
was meant may be something else.

Source: spec/metagcode.md §6

Bad:

    #IF1 |a| equalto 1 never
                       ^^^^^
    #ENDIF1
    #IF1 |a| equalto 1 ALWAYS
                       ^^^^^^
    #ENDIF1

Good:

    #IF1 |a| equalto 1 NUM
    #ENDIF1
    #IF1 |a| equalto 1 alpha
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import condition, is_numeric
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the type."""
    type_ = condition(node).type
    said = line.said(type_)
    meant = "numeric" if is_numeric(said) else "alpha"
    if type_.kind == "TYPE" and not meant.startswith(said.lower()):
        yield Report(Span(type_.start, type_.end), f"`{said}` is read as `{meant}`, since only its first letter counts")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the letter that counts."""
    yield broken.replaced(broken.said[0].lower(), safe=True)
