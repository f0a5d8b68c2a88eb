"""Program that stops itself.

`(ABORT,...)` ends the program with its text as the error. It stands where the program has found that
its values cannot be right; with the values that are given it is reached.

Source: spec/rs274.md §1.5

Bad:

    #<depth>=12
    o1 if [#<depth> GT 10]
      (ABORT,too deep: #<depth>)
      ^^^^^^^^^^^^^^^^^^^^^^^^^^
    o1 endif

Good:

    #<depth>=8
    o1 if [#<depth> GT 10]
      (ABORT,too deep: #<depth>)
    o1 endif
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran())
def check(fault: Fault) -> Iterator[Report]:
    """Report the place at which the run meets it."""
    yield Report(fault.span, fault.message)
