"""`#AND`, `#OR` or `#EXC` where nothing is tested.

The operators join the tested words of a conditional bracket. With no word before them they join
nothing, and the bodies of `#IF`, `#ELSE` and `#REPEAT` are not tested at all.

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

Good:

    < X#XPOS#AND Y#YPOS >
    < #MOV,#AND X#XPOS >
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._brackets import tests_of
from deburr.rules.cgt._template import Body, template_of


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the operator."""
    for body in dict.fromkeys(placed.body for placed in template_of(analysis).of("operator")):
        yield from _in(body)


def _in(body: Body) -> Iterator[Report]:
    if body.kind == "bracket":
        tests = tests_of(body)
        for item in tests.early:
            if item.name != "EXC" or not (tests.tested or tests.excluded):
                yield Report(
                    item.span, f"no word stands before `{item.text}` in this bracket, so it joins nothing", item.line
                )
    elif body.kind != "unknown":
        for item in body.items():
            if item.kind == "operator":
                yield Report(
                    item.span,
                    f"`{item.text}` stands where no word is tested; it belongs into a conditional bracket",
                    item.line,
                )
