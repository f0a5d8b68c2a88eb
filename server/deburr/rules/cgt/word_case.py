"""System word in lower case.

The words and commands of the generator are written in upper case, and names of your own are
told from them by it.

Source: spec/cgt.md §2, §11, *Words*

Bad:

    #xpos
    ^^^^^
    <X#XPOS#and Y#YPOS>
           ^^^^
    #if(#v1>3)<M08>#Else<M09>
    ^^^
        ^^^
                   ^^^^^

Good:

    #XPOS
    #EVAL(#V1=sqr(2))
"""

import re
from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import Use
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

_LOWER = re.compile("#[A-Za-z]*[a-z]")
_NOT_COMMANDS = ("WORD", "TEXT", "COMMENT", "CHARS", "STRING", "TAG", "LABEL", "ROW_TEXT")


@rule(Severity.INFO, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the word or command."""
    template = template_of(analysis)
    yield from parted(template.uses, _of_uses)
    yield from parted(template.lines, _on_lines)


def _of_uses(uses: Sequence[Use]) -> Iterator[Report]:
    for use in uses:
        said, name = use.said[: len(use.said) - len(use.spelled.rest)], use.spelled.name
        if use.role not in ("declared", "macro") and use.spelled.kind == "word" and said != name:
            yield Report(use.span, f"`#{said}` is the system word `#{name}`; write it in capitals", use.line)


def _on_lines(lines: Sequence[tuple[int, LineNode]]) -> Iterator[Report]:
    for line, node in lines:
        for token in tokens(node.tree) if _LOWER.search(node.text) and node.reading.start == "template" else ():
            said = node.text[token.start : token.end]
            if token.kind not in _NOT_COMMANDS and said.startswith("#") and said != said.upper():
                message = f"`{said}` is the command `{said.upper()}`; write it in capitals"
                yield Report(Span(token.start, token.end), message, line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write it as it is read."""
    yield broken.replaced(broken.quoted[1], safe=True)
