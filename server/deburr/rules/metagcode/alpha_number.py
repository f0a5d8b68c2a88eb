"""Numbers that are compared as text.

As text `9` is greater than `10`, because the first characters decide, and `1.0` does not equal `1`.
Numbers are compared as such with the type `n`.

Source: spec/metagcode.md §6

Bad:

    #IF1 9 greaterthan 10 a
         ^^^^^^^^^^^^^^^^
    #ENDIF1

Bad (variables=part.vars):

    #IF1 |Dia| lessthan 10 a
         ^^^^^^^^^^^^^^^^^
    S3000
    #ENDIF1
    -- part.vars --
    Dia=9.5

Good:

    #IF1 9 greaterthan 10 n
    #ENDIF1
    #IF1 |Tool| equalto 10 a
    #ENDIF1
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.dialects.metagcode.forms import condition, is_numeric, number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.INFO, Nodes(("condition",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the two values."""
    left, _, right, type_ = condition(node)
    if type_.kind != "TYPE" or is_numeric(line.said(type_)):
        return
    one, two = line.said(left), line.said(right)
    if number(one) is not None and number(two) is not None:
        yield Report(
            Span(left.start, right.end),
            f"`{one}` and `{two}` are compared as text, character by character; write `n` to compare numbers",
        )


def fix(broken: Broken) -> Iterator[Fix]:
    """Compare numbers."""
    kind = re.search(r"\S+\s*$", broken.text)
    if kind is not None and kind.start() >= broken.span.end:
        yield Fix("Compare as numbers, `n`", (broken.edit(kind.start(), len(broken.text.rstrip()), "n"),))
