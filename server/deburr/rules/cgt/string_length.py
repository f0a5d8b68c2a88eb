"""Text that is too long for a word.

A text word holds up to 254 characters; what is beyond would be lost.

Source: spec/cgt.md §5.1, §8

Bad:

    #EVAL(#S1=AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA)
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^

Bad (input=sample.cl):

    #EVAL(#S1=#FILE)
    ^^^^^^^^^^^^^^^^
    -- sample.cl --
    PARTNO AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #EVAL(#S1=AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA)
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.templates.types import value_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

LONGEST = 254
_BEHIND = {"eval": "EQUAL", "macro": "EQUAL", "returned": "OPEN"}


@rule(Severity.ERROR, Nodes(("eval", "macro", "returned")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the text."""
    value = value_of(node, _BEHIND[node.kind])
    if value is None:
        return
    said = line.said(value).strip(" \t")
    to_text = value.kind == "CHARS" or (line.said(node.children[2])[1:2] in ("S", "s") and value.kind == "NUMBER")
    if to_text and len(said) > LONGEST:
        span = Span(value.start, value.start + len(said))
        yield Report(span, f"this text has {len(said)} characters; a word holds {LONGEST}")
