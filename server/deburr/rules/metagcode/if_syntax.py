"""Condition with missing or extra items.

`#IF` takes four items, set off by blanks: a value, an operator, a value, a type. A value with a
blank in it can only come out of a variable, since there are no quotes. `#ENDIF` takes nothing.
Which item was meant for what cannot be told, so nothing is built.

Source: spec/metagcode.md §3, §4, §6

Bad:

    #IF1 |a| equalto 1
    ^^^^^^^^^^^^^^^^^^
    #ENDIF1 |a|
            ^^^

Bad:

    #IF1 |Mat| equalto Mild Steel a
                                  ^
    #ENDIF1

Bad:

    #IF1 |Depth| greater than 20 n
                 ^^^^^^^^^^^^
    #ENDIF1
    #IF1 |Mat| equalto Steel a and |Dia| lessthan 6 n
                               ^^^^^^^^^^^^^^^^^^^^^^
    #ENDIF1

Bad:

    #IF1|a| equalto 1 n
        ^^^
      #IF2
      ^^^^
      #ENDIF2x
             ^
    #ENDIF1

Bad:

    #IF1 |a|equalto 1 n
            ^^^^^^^
    #ENDIF1

Good:

    #IF1 |a|   equalto	1 n
    #ENDIF1
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import advised
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._items import misfit, surplus
from deburr_grammar.tree import Node

_ITEMS = ("a value", "an operator", "a second value", "a type (`a` for text, `n` for numbers)")


@rule(Severity.ERROR, Nodes(("if", "endif"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what does not fit."""
    found = surplus(line, node) if node.kind == "endif" else misfit(line, node, "condition", _ITEMS)
    if found is not None:
        yield Report(*found)


def fix(broken: Broken) -> Iterator[Fix]:
    """Set items off by blanks, write one word, leave out what is too much, add the type."""
    message, end = broken.finding.message, len(broken.text.rstrip())
    if "must be set off" in message:
        yield broken.inserted(broken.span.start, " ")
    elif "takes nothing" in message:
        yield broken.deleted(*broken.span)
    elif "lacks a type" in message:
        number = re.fullmatch(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)", broken.text.split()[-1])
        yield broken.inserted(end, " n" if number else " a")
    else:
        yield from advised(broken)
