"""Directive that does not exist.

A line whose first sign is `#` and a letter is a directive, and there are five: `#FILE`, `#IF`,
`#ENDIF`, `#LOOP` and `#ENDLOOP`. There is no else and no while. As G-code the line would mean
nothing to the control, so nothing is built. A misspelt end is taken for the end that was meant, so
that the block around it is not reported as well.

Source: spec/metagcode.md §2, §6

Bad:

    #WHILE1 |a| lessthan 3 n
    ^^^^^^^
    #FILES drill.txt
    ^^^^^^
    #FILE1 drill.txt
    ^^^^^^
    #ifx1 |a| equalto 1 n
    ^^^^^

Bad:

    #LOOP1 |Depth| 2 c
    G1 Z-|Depth|
    #ENDLOP1
    ^^^^^^^^

Bad:

    #IF1 |Mat| equalto Steel a
    S800
    #ELSE1
    ^^^^^^
    S2400
    #ENDIF1

Good:

    #1=3
    #<depth>=#1
    ##2=1
    # FILE
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import did_you_mean
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.metagcode._words import FOREIGN, keyword_meant
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_RUN = re.compile(r"(#[A-Za-z]+)([0-9]*)[^ \t|]*")


@rule(Severity.ERROR, Nodes(("unknown",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    run = _RUN.match(line.text, node.start)
    assert run is not None
    yield Report(Span(*run.span()), f"`{run[0]}` is no directive; {_hint(run[1].upper(), run[2])}")


def _hint(word: str, label: str) -> str:
    if word in FOREIGN:
        return FOREIGN[word]
    meant = keyword_meant(word)
    if meant is None:
        return "there are `#FILE`, `#IF`, `#ENDIF`, `#LOOP` and `#ENDLOOP`"
    return f"did you mean `{meant}{'' if meant == '#FILE' else label}`?"


def fix(broken: Broken) -> Iterator[Fix]:
    """Spell it as it is meant; `#FILE` takes no number."""
    if "takes no number" in broken.finding.message:
        yield broken.replaced("#FILE")
    else:
        yield from did_you_mean(broken)
