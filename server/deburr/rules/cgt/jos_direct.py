"""Job data outside `#EVAL`.

`JOS` and `JOS_STR` work only inside `#EVAL`. Anywhere else the generator outputs them as plain text,
and the control gets words that it does not know.

Source: spec/cgt.md §5.8, §7

Bad:

    T#JOS(TOOL_NO)
     ^^^^
    (LENGTH JOS_STR(length))
            ^^^^^^^
    #IF(jos(DIA)>3)<M08>
        ^^^

Good:

    #EVAL(#V1=jos(length))
    #V1 // JOS(length)
"""

import re
from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

_CALL = re.compile(r"(?i)#?\bJOS(?:_STR)?(?=\()")


@rule(Severity.ERROR, Text(r"(?i)jos(?:_str)?\("))
def check(line: Line) -> Iterator[Report]:
    """Report the name."""
    if line.node.reading.start != "template":
        return
    inside = [Span(node.start, node.end) for node in line.node.find("eval", "macro", "returned")]
    for match in _CALL.finditer(line.text):
        plain = any(
            t.start <= match.start() < t.end for t in tokens(line.node.tree) if t.kind in ("TEXT", "WORD", "JOB")
        )
        if plain and not any(span.start <= match.start() < span.end for span in inside):
            message = f"`{match[0]}` works only inside `#EVAL`; assign it to a word and use that"
            yield Report(Span(match.start(), match.end()), message)
