"""Block number that nothing marks.

`#GETBLK(n)` outputs the number of the block that `#SETBLK(n)` marks. Without that there is no
number to output.

Source: spec/cgt.md §4, §7

Bad:

    GOTO #GETBLK(0)
         ^^^^^^^^^^
    #SETBLK(1)

Bad (input=sample.cl):

    GOTO #GETBLK(#V1)
         ^^^^^^^^^^^^
    #SETBLK(#V1+1)
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    GOTO #GETBLK(0)
    #SETBLK(0)
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.cgt import constant
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Item
from deburr.templates.template import Template


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the command."""
    template = template_of(analysis)
    blocks = [item for item, _, _ in template.of("block")]
    marked = {_number(item, template) for item in blocks if item.name == "SETBLK"}
    for item in blocks:
        number = _number(item, template)
        if item.name == "GETBLK" and number is not None and not marked & {number, None}:
            yield Report(
                item.span, f"no `#SETBLK({number:g})` marks a block, so `{item.text}` has no number", item.line
            )


def _number(item: Item, template: Template) -> float | None:
    assert item.node is not None
    value = constant(template.text(item.line), item.node.children[2])
    return value if isinstance(value, float) else None
