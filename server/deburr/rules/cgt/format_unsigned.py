"""Negative number in a format that prints no sign.

`!` in a format leaves out the minus. The control then moves to the other side of zero, unless the
letter before the word says which way is meant.

Source: spec/cgt.md §5.1, §7

Bad (input=sample.cl):

    #FMT(#V1,D!3.4)
    #EVAL(#V1=-2.5)
    Q#V1
     ^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good (input=sample.cl):

    #FMT(#V1,D!3.4)
    #EVAL(#V1=2.5)
    Q#V1
    #EVAL(#V1=-0.00004)
    Q#V1
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.WARNING, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the word where it is output."""
    yield Report(fault.span, fault.message)
