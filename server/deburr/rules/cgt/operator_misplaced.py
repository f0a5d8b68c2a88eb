"""`#AND`, `#OR` or `#EXC` where nothing is tested.

The operators join the tested words of a conditional bracket. With no word before them, none behind
them, or behind an `#EXC`, they join nothing, and the bracket tests something else than it seems to. The bodies
of `#IF`, `#ELSE` and `#REPEAT` are not tested at all.

Source: spec/cgt.md §11, *Brackets*

Bad:

    <#AND X#XPOS>
     ^^^^

Bad:

    #IF(#V1>3)<X#XPOS#AND Y#YPOS>
                     ^^^^
    X#XPOS,#OR Y#YPOS
           ^^^
    <T#TOOL>#ELSE<T#NTOOL#EXC S#SPEED>
                         ^^^^

Bad:

    <X#XPOS#AND>
           ^^^^
    <#MOV#AND#OR X#XPOS>
         ^^^^
    <#DCOMP#EXC D#DOFF#AND S#SPEED>
                      ^^^^
    <S#SPEED#AND<#SPNDL>>
            ^^^^

Good:

    < X#XPOS#AND Y#YPOS >
    < #MOV,#AND X#XPOS >
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import deleted
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.brackets import Tests, read_brackets, tests_of
from deburr.templates.items import Body, Item


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the operator."""
    template = template_of(analysis)
    whole: set[Body] = set()
    yield from parted(read_brackets(template), whole.update)
    for body in dict.fromkeys(placed.body for placed in template.of("operator")):
        for item, why in _in(body, body in whole):
            yield Report(item.span, why, item.line)


def _in(body: Body, whole: bool) -> Iterator[tuple[Item, str]]:
    """The operators that join nothing, and why; what is missing behind one is known only of a bracket that could be read to its end."""
    if body.kind == "bracket":
        tests = tests_of(body)
        for item in tests.early:
            if item.name != "EXC" or not (tests.tested or tests.excluded):
                yield item, f"no word stands before `{item.text}` in this bracket, so it joins nothing"
        for item in tests.late if whole else ():
            yield item, f"`{item.text}` joins nothing: {_missing(item, tests)}"
    elif body.kind != "unknown":
        for item in body.items():
            if item.kind == "operator":
                yield item, f"`{item.text}` stands where no word is tested; it belongs into a conditional bracket"


def _missing(item: Item, tests: Tests) -> str:
    if any((word.line, word.start) < (item.line, item.start) for word in tests.excluded):
        return "no word behind `#EXC` is tested"
    return "no word follows it directly in this bracket before the next operator or the end"


fix = deleted
