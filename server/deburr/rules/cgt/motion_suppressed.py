"""Position that another word's bracket holds back.

A bracket inside another one is looked at only if the outer one is output. So a changed position
is not output while the outer word stays the same, and the machine does not move there.

Source: spec/cgt.md §5.2

Bad:

    < #CYCLE <X#XPOS>>
               ^^^^^
    < #CYCLE <X#XPOS>>< Y#YPOS>
               ^^^^^
    < #CYCLE <X#XPOS <Y#YPOS>>>
               ^^^^^
                       ^^^^^
    <#MOV#IF(#V1>3)<Z#ZPOS>>
                     ^^^^^

Good:

    <#CYCLE><X#XPOS><Y#YPOS>
    <#CYCLE X#XPOS>
    <X#XPOS<Y#YPOS>>
    <#CYCLE<S#SPEED>>
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.brackets import tests_of
from deburr.templates.items import Body, Item
from deburr.templates.symbols import POSITIONS
from deburr.templates.template import Placed


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the position."""
    known: dict[tuple[int, str], Item | None] = {}
    yield from parted(template_of(analysis).of("word"), partial(_of_words, known))


def _of_words(known: dict[tuple[int, str], Item | None], words: Sequence[Placed]) -> Iterator[Report]:
    for item, _, body in words:
        if item.name in POSITIONS:
            holder = _holder(body, item.name, known)
            if holder is not None:
                message = f"a changed `{item.text}` is not output while `{holder.text}` stays the same; give it a bracket of its own"
                note = Note(holder.line, holder.span, f"only a change of `{holder.text}` opens the outer bracket")
                yield Report(item.span, message, item.line, (note,))


def _holder(body: Body, name: str, known: dict[tuple[int, str], Item | None]) -> Item | None:
    """The word of the innermost body around that holds the name back; each body is asked once."""
    passed, holder = [], None
    for outer in body.around():
        if (id(outer), name) in known:
            holder = known[id(outer), name]
            break
        passed.append(outer)
    for outer in reversed(passed):
        holder = known[id(outer), name] = _holds(outer, name) or holder
    return holder


def _holds(body: Body, name: str) -> Item | None:
    """The word on which a bracket depends that is no position; None if the position is tested there too."""
    tested = tests_of(body).tested if body.kind == "bracket" else ()
    if any(item.name == name for item in tested):
        return None
    return next((item for item in tested if item.name not in POSITIONS), None)
