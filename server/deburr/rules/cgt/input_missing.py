"""Template without a toolpath to run it.

A template only says how elements of a toolpath are output. To see what it makes of one, name CL text
(`.cl`) or a list of events (`.jsonl`): `--input FILE`, or `input` in the configuration.

`check` looks at the template alone and does not report it; `expand` refuses.

Source: spec/cgt.md §6, §11

Bad (whole):

    @START
    ^^^^^^
    %
    @
    @LINE
    <#MOV>< X#XPOS>
    @
    @END
    M30
    @

Good (input=sample.cl, whole):

    @START
    %
    @
    @LINE
    <#MOV>< X#XPOS>
    @
    @END
    M30
    @
    -- sample.cl --
    GOTO/1,0,0
    FINI
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the template at its first line."""
    yield Report(fault.span, fault.message)
