"""Statement of the toolpath that is not read.

CL text holds much that is for a post-processor: colours, user commands, options of a tool. What is
not known here is left out, which matters if the template counts on it. Each word is reported once.

Source: spec/cgt.md §6, §11

Bad (input=sample.cl):

    -- sample.cl --
    PAINT/COLOR,3
    ^^^^^
    LOADTL/1,LENGTH,120.5
             ^^^^^^^^^^^^
    RAPDI
    ^^^^^
    GOTO/0,0,5
    PAINT/COLOR,4
    FINI
    what stands behind the end is not read

Good (input=sample.cl):

    -- sample.cl --
    PARTNO SQUARE
    PPRINT/FIRST SIDE
    LOADTL/1
    CYCLE/DRILL,DEPTH,10,CLEAR,2
    CYCLE/OFF
    GOTO/0,0,5
    FINI
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import configured, ready
from deburr.templates.beside import toolpath_faults


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the statement or the values."""
    file = configured(analysis, "input")
    for fault in toolpath_faults(file):
        if fault.ignored:
            yield Report(fault.span, fault.message, fault.line, (), file.path)
