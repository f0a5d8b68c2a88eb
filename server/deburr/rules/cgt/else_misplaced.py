"""`#ELSE` that follows no test.

`#ELSE<...>` belongs to the bracket or the `#IF` directly before it: nothing may stand between
`>` and `#ELSE`, nor between `#ELSE` and its `<`, not even a blank or a line's end. The bodies of
`#REPEAT` and of another `#ELSE` are no tests.

Source: spec/cgt.md §5.2, §11, *Lines*

Bad:

    #ELSE<T0>
    ^^^^^

Bad:

    <T#NTOOL> #ELSE<T0>
              ^^^^^
    <T#NTOOL>#ELSE <T0>
             ^^^^^
    <T#NTOOL>#ELSE T0
             ^^^^^
    #REPEAT(2)<M08>#ELSE<M09>
                   ^^^^^
    <T#NTOOL>#ELSE<T0>#ELSE<T1>
                      ^^^^^

Bad:

    #IF(#V1>3)<M08>
    #ELSE<M09>
    ^^^^^

Good:

    <T#NTOOL>#ELSE< T0>
    #IF(#V1>3)<
    M08
    >#ELSE<
    M09
    >
"""

from collections.abc import Iterator, Sequence, Set
from functools import partial

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import blanks_left_out
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Body, Item


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the command."""
    template = template_of(analysis)
    bodies = {id(body): body for _, _, body in template.of("else")}
    # A section may hold thousands of them: all are found in one walk along its parts.
    yield from parted(
        ((body, at) for body in bodies.values() for at in range(len(body.parts))),
        partial(_of_parts, template.faulty_lines),
    )


def _of_parts(faulty: Set[int], parts: Sequence[tuple[Body, int]]) -> Iterator[Report]:
    for body, at in parts:
        item = body.parts[at]
        if isinstance(item, Item) and item.kind == "else" and item.line not in faulty:
            yield from _of(item, body.parts[at - 1] if at else None, body.parts[at + 1 : at + 2])


def _of(item: Item, before: Item | Body | None, behind: list[Item | Body]) -> Iterator[Report]:
    closer = before.closer if isinstance(before, Body) and before.kind in ("bracket", "if", "unknown") else None
    if closer is None or (closer.line, closer.end) != (item.line, item.start):
        yield Report(
            item.span,
            f"`{item.text}` does not directly follow a bracket or an `#IF`, so it belongs to no test",
            item.line,
        )
        return
    opener = behind[0].opener if behind and isinstance(behind[0], Body) else None
    if opener is None or (opener.line, opener.start) != (item.line, item.end):
        yield Report(item.span, f"`{item.text}` has no body; `<` must follow it directly", item.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave out the blanks that keep it apart from its bracket."""
    before = broken.text[: broken.span.start]
    if "must follow it directly" in broken.finding.message:
        yield from blanks_left_out(broken, "<")
    elif before.rstrip().endswith(">") and before != before.rstrip():
        yield Fix("Delete the blanks", (broken.edit(len(before.rstrip()), len(before), ""),))
