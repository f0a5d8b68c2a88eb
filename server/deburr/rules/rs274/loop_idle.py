"""Loop that makes no pass.

Its condition does not hold when the program comes to it, or its count is 0 or less, on every way and whatever the program is
called with: what stands in it is never run. So is the condition of a `do` that never holds: it makes one pass only.
Nothing is said of what hangs on a parameter that is set at one place only, because that is a switch.

Source: spec/rs274.md §6

Bad:

    #<z>=0
    o1 while [#<z> GT 20]
             ^^^^^^^^^^^^
      #<z>=[#<z>+2]
      G0 Z#<z>
    o1 endwhile

Bad:

    #<n>=4
    o1 while [#<n> GT 0]
      #<n>=[#<n>-1]
    o1 endwhile
    o2 repeat [#<n>]
              ^^^^^^
      G0 X#<n>
    o2 endrepeat

Good:

    #<z>=0
    o1 while [#<z> LT 20]
      #<z>=[#<z>+2]
      G0 Z#<z>
    o1 endwhile
    #<holes>=0
    o2 repeat [#<holes>]
      G0 X1
    o2 endrepeat
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the condition or the count."""
    yield Report(proof.span, proof.message)
