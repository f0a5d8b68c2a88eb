"""Event of the toolpath that the template has no section for.

Nothing is output for it: without `@RAP`, `@ARC` or `@HELIX` moves are lost and the tool goes straight to
the next point, without `@TOOLCHG` the wrong tool cuts on. It is said once for each sort of event, at
the first one.

Source: spec/cgt.md §5.5, §6

Bad (input=sample.cl):

    M08
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    DELAY/2
    ^^^^^^^
    CIRCLE/5,0,0,0,0,1,4
    GOTO/9,0,1
    ^^^^^^^^^^
    DELAY/3
    FINI

Good (input=sample.cl):

    M08
    -- sample.cl --
    LOADTL/1
    FEDRAT/200
    RAPID
    GOTO/1,0,0
    GOTO/2,0,0
    CIRCLE/5,0,0,0,0,1,3
    GOTO/8,0,0
    FINI
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the statement in the toolpath."""
    yield Report(fault.span, fault.message)
