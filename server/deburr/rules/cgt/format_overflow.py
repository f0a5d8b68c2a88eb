"""Number that is too large for its format.

A format has so many digits before the point. A coordinate without its first digit would send the
tool somewhere else, so nothing is cut off: the run ends. Wanted are more digits in `#FMT` or in the
machine file. `#V` and `#U` words without a format of their own print all their digits.

Source: spec/cgt.md §5.1, §7

Bad (input=sample.cl):

    #EVAL(#XPOS=12345)
    #FMT(#XPOS,D3.4)
    R#XPOS
     ^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Bad (input=sample.cl, machine=mill.toml):

    #EVAL(#TOOL=99.96)
    M#TOOL
     ^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI
    -- mill.toml --
    [formats]
    F_Integer = "T2.1"
    F_Decimal = "D4.4"

Good (input=sample.cl):

    #EVAL(#XPOS=999.9999)
    #FMT(#XPOS,D3.4)
    R#XPOS
    #EVAL(#V1=123456789)
    (#V1)
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the word where it is output."""
    yield Report(fault.span, fault.message)
