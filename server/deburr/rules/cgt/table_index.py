"""Row that the table does not have.

Rows count from 0. Nothing could be output for it, and a missing G or M code leaves the machine in
the state it was in.

Source: spec/cgt.md §5.7

Bad:

    (COOLANT #TABLE(levels, 4))
                            ^
    #TABLE(levels,-1)#TABLE(levels,1.5)
                  ^^
                                   ^^^
    @
    @levels
    0,Off
    1,Low

    2,Med // the blank line is no row
    3,High

Bad (input=sample.cl):

    #EVAL(#V1=2*#XPOS)
    #TABLE(levels,#V1)
                  ^^^
    @
    @levels
    0,Off
    1,Low
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Bad (input=sample.cl):

    #EVAL(#COOLNT=3)
    #COOLNT
    ^^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    (COOLANT #TABLE(levels, 0))
    #TABLE(levels, 3)#TABLE(levels,#V1)
    @
    @levels
    0,Off
    1,Low
    2,Med
    3,High
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.cgt import constant
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import target
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the row number."""
    template = template_of(analysis)
    for item, _, _ in template.of("lookup"):
        section = template.by_name.get(target(item)[0])
        if section is None or not section.is_table:
            continue
        assert item.node is not None
        index = item.node.children[-2]
        value = constant(template.text(item.line), index)
        if isinstance(value, float) and value not in range(len(section.rows)):
            said = template.text(item.line)[index.start : index.end]
            rows = f"rows 0 to {len(section.rows) - 1}" if section.rows else "no rows"
            message = f"`@{section.name}` has no row `{said}`; it has {rows}"
            yield Report(Span(index.start, index.end), message, item.line)
