"""Blank that is output even if nothing else is.

Blanks outside the brackets are always output. If none of the brackets on the line is, or the line
holds only commands, a line of blanks is left. Put the blanks into the brackets.

Source: spec/cgt.md §5.2, §5.3

Bad:

    <X#XPOS> <Y#YPOS>
            ^
      <X#XPOS>
    ^^
    #EVAL(#V1=1) #EVAL(#V2=2)
                ^

Good:

    <X#XPOS>< Y#YPOS>
    G01 <X#XPOS> <Y#YPOS>
    #EVAL(#V1=1) // a blank before a comment
      // a comment
    #IF(#V1>3)< <X#XPOS> M08>
"""

from collections.abc import Iterator, Sequence, Set
from functools import partial

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Item
from deburr.templates.template import Placed, Template


@rule(Severity.INFO, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first blank of each such line."""
    template = template_of(analysis)
    lines: dict[int, list[tuple[Item, bool]]] = {}

    def take(items: Sequence[Placed]) -> None:
        for item, section, body in items:
            if section.reading != "declare" and item.line not in template.faulty_lines:
                inside = body.opener is not None and body.opener.line == item.line
                lines.setdefault(item.line, []).append((item, inside))

    yield from parted(template.items, take)
    yield from parted(lines.items(), partial(_on_lines, _openers(template)))


def _on_lines(openers: Set[int], lines: Sequence[tuple[int, list[tuple[Item, bool]]]]) -> Iterator[Report]:
    for line, items in lines:
        blank = _lonely(items, line in openers)
        if blank is not None:
            yield Report(
                blank.span, "this blank is output even if nothing else on the line is; put it into a bracket", line
            )


def _lonely(items: list[tuple[Item, bool]], opens: bool) -> Item | None:
    outside = [item for item, inside in items if not inside]
    if outside and outside[-1].kind == "comment":
        outside = outside[:-2] if len(outside) > 1 and outside[-2].blank else outside[:-1]
    blanks = [item for at, item in enumerate(outside) if item.blank and not _beside_else(outside, at)]
    if any(item.printed for item in outside) or not (opens or len(blanks) < len(outside)):
        return None
    return blanks[0] if blanks else None


def _beside_else(items: list[Item], at: int) -> bool:
    """Whether a blank parts an `#ELSE` from what it belongs to, which is another fault."""
    return any(item.kind == "else" and items[at].line == item.line for item in items[max(0, at - 1) : at + 2])


def _openers(template: Template) -> set[int]:
    return {body.opener.line for body in template.bodies if body.opener}


def fix(broken: Broken) -> Iterator[Fix]:
    """Put the blank into the bracket behind it; before anything else leave it out."""
    start, end = broken.span
    if broken.text[end : end + 1] == "<":
        yield Fix("Put it into the bracket", (broken.edit(start, end + 1, f"<{broken.said}"),))
    else:
        yield Fix("Delete the blank", (broken.edit(start, end, ""),))
