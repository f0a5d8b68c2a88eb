"""Directive that does not exist.

A line whose first sign is `#` and a letter is a directive, and there are five: `#FILE`, `#IF`,
`#ENDIF`, `#LOOP` and `#ENDLOOP`. There is no else and no while. As G-code the line would mean
nothing to the control, so nothing is built.

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

Good:

    #1=3
    #<depth>=#1
    ##2=1
    # FILE
"""

import re
from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.suggest import suggestion
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_RUN = re.compile(r"#[A-Za-z]+[^ \t|]*")
_KEYWORDS = ("#FILE", "#IF", "#ENDIF", "#LOOP", "#ENDLOOP")
_HINTS = {
    "#FILE": "; `#FILE` is followed by a blank and the name",
    "#ELSE": "; there is no else, write a second `#IF` with the opposite operator",
    "#ELSEIF": "; there is no else, write a second `#IF`",
    "#WHILE": "; repeat lines with `#LOOP`",
    "#FOR": "; repeat lines with `#LOOP`",
    "#REPEAT": "; repeat lines with `#LOOP`",
}


@rule(Severity.ERROR, Nodes(("unknown",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    run = _RUN.match(line.text, node.start)
    assert run is not None
    yield Report(Span(*run.span()), f"`{run[0]}` is no directive{_hint(line.said(node.children[0]).upper())}")


def _hint(said: str) -> str:
    return (
        _HINTS.get(said)
        or suggestion(said, _KEYWORDS)
        or "; there are `#FILE`, `#IF`, `#ENDIF`, `#LOOP` and `#ENDLOOP`"
    )
