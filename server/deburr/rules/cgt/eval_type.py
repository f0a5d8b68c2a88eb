"""Text where a number belongs, or the other way round.

A number word takes a number. A text word takes a word, a text function or unquoted text; words
inside unquoted text are not replaced by their values.

A text in a numeric `#IF` must hold a number.

Source: spec/cgt.md §5.4, §5.8

Bad:

    #EVAL(#V1=M03)
              ^^^
    #EVAL(#V1=)
    ^^^^^^^^^^^
    #EVAL(#V1=#S1)
              ^^^
    #EVAL(#V1=2*#DATE)
                ^^^^^
    #EVAL(#V1=STRSUB(#S1,1,2))
              ^^^^^^^^^^^^^^^
    #EVAL(#V1=JOS_STR(NAME))
              ^^^^^^^^^^^^^
    #EVAL(#V1=STRLEN(#V2))
                     ^^^
    #EVAL(#V1=SQR(#S2))
                  ^^^
    #EVAL(#S1=SQR(4))
              ^^^^^^
    #EVAL(#S1=#S2+#S3)
              ^^^^^^^
    #EVAL(#S1=G0 X#V1)
              ^^^^^^^
    #EVMD(#x=M03)
             ^^^
    #EVMI(#x=#S1)
             ^^^

Bad (input=sample.cl):

    #EVAL(#S1=2X)
    #IF(#S1>3)<M08> // deburr: allow cgt.if-string
        ^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #EVAL(#V1=STRLEN(#S1)+1)
    #EVAL(#V1=JOS(DIA))
    #EVAL(#S1=STRSUB(#S2, 1, #V2))
    #EVAL(#S1=#V1)
    #EVAL(#S1=12.5-3)
    #EVAL(#S1=jos(NAME))
    #EVMS(#x=M03)
"""

import re
from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Item
from deburr.templates.symbols import Symbols, functions, missing_sign
from deburr.templates.template import Placed, Template
from deburr.templates.types import is_plain, misfits, no_numbers, value_of
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

_BEHIND = {"eval": "EQUAL", "macro": "EQUAL", "returned": "OPEN"}


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the value."""
    template = template_of(analysis)
    yield from parted(template.of(*_BEHIND), partial(_of_items, template))


def _of_items(template: Template, items: Sequence[Placed]) -> Iterator[Report]:
    for item, _, _ in items:
        text = template.text(item.line)
        if (is_text := _wants_text(item, template.symbols, text)) is not None:
            yield from _of(item, is_text, template.symbols, text)


def _wants_text(item: Item, symbols: Symbols, text: str) -> bool | None:
    """Whether a text is assigned or returned; None where nobody knows."""
    if item.kind != "eval":
        return item.name in ("EVMS", "RETSTR")
    assert item.node is not None
    target = item.node.children[2]
    word = symbols.find(text[target.start + 1 : target.end]) if target.kind == "WORD" else None
    return word.is_text if word is not None else None


def _of(item: Item, is_text: bool, symbols: Symbols, text: str) -> Iterator[Report]:
    assert item.node is not None
    value = value_of(item.node, _BEHIND[item.kind])
    if value is None:
        if not is_text:
            yield Report(item.span, f"`{item.text}` gives a number word no number; write 0 to clear it", item.line)
        return
    for part, why in _text_faults(value, symbols, text) if is_text else _number_faults(value, symbols, text):
        yield Report(Span(part.start, part.end), f"`{text[part.start : part.end]}` {why}", item.line)


def _number_faults(value: Node | Token, symbols: Symbols, text: str) -> Iterator[tuple[Node | Token, str]]:
    for part in no_numbers(symbols, text, value):
        said = text[part.start : part.end]
        word = symbols.find(said[1:]) if part.kind == "WORD" else None
        if word and not word.is_text:
            yield part, "is a number, and the function takes a text"
        else:
            yield part, f"is a text where a number is needed{_meant(said) if part.kind == 'CHARS' else ''}"


def _meant(said: str) -> str:
    """What a text may be meant for: a function without its parentheses, a word without its sign, or indeed a text."""
    if said.startswith("="):
        return "; one `=` assigns"
    if "[" in said:
        return "; a calculation is grouped by `(` and `)`"
    names = re.findall(r"(?<![#A-Za-z0-9_])[A-Za-z][A-Za-z0-9_]*", said)
    if name := next((name.upper() for name in names if name.upper() in functions()), ""):
        return f"; write `{name}(...)`"
    hints = map(missing_sign, names)
    return next((hint for hint in hints if hint), "; text is held by `#S` words and by words of type `#STR`")


def _text_faults(value: Node | Token, symbols: Symbols, text: str) -> Iterator[tuple[Node | Token, str]]:
    if value.kind == "CHARS":
        if "#" in text[value.start : value.end] and symbols_in(text[value.start : value.end]):
            yield value, "is taken as it stands; words in a text are not replaced by their values"
    elif value.kind == "function" and isinstance(value, Node):
        if text[value.start : value.children[0].end].upper() != "STRSUB":
            yield value, "is a number where a text is needed"
        else:
            yield from ((part, "is not of the type that the function takes") for part in misfits(symbols, text, value))
    elif value.kind not in ("WORD", "job") and not is_plain(value):
        yield value, "is no text; a text is one word, one text function or unquoted text"


def symbols_in(said: str) -> bool:
    """Whether a text holds something that is written like a word."""
    return any(piece[:1].isascii() and piece[:1].isalpha() for piece in said.split("#")[1:])


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the 0 that clears a number."""
    if "write 0 to clear it" in broken.finding.message:
        yield broken.inserted(broken.span.end - 1, "0")
