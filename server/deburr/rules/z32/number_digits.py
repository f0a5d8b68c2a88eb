"""Number with more than nine digits.

The control keeps nine significant digits and refuses more. Leading zeros do not count, all other
digits that are written do.

Source: spec/z32.md §2, §11

Bad:

    X1234567.12345
     ^^^^^^^^^^^^^
    X-0.1234567890
      ^^^^^^^^^^^^
    !HA=100000.0000!
        ^^^^^^^^^^^

Good:

    X12345.6789 Y-0.000000001 Z000012345.678
    !HA=100000.000!
"""

from collections.abc import Iterator
from decimal import ROUND_HALF_UP, Decimal

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

DIGITS = 9


@rule(Severity.ERROR, Text(r"[0-9][0-9.,]{9}"))
def check(line: Line) -> Iterator[Report]:
    """Report the numbers."""
    for token in tokens(line.node.tree):
        if token.kind in ("NUMBER", "LOOSE"):
            digits = line.said(token).replace(".", "").replace(",", "").lstrip("0")
            if len(digits) > DIGITS:
                message = f"`{line.said(token)}` has {len(digits)} significant digits; the control takes {DIGITS}"
                yield Report(Span(token.start, token.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """The number as far as the control takes it, rounded; nothing for one whose whole part is too long."""
    sign = "," if "," in broken.said else "."
    whole, _, fraction = broken.said.partition(sign)
    left = DIGITS - len(whole.lstrip("0"))
    if not whole.lstrip("0"):
        left += len(fraction) - len(fraction.lstrip("0"))
    if left >= 0 and (whole + fraction).isdigit():
        exact = Decimal(f"{whole}.{fraction}")
        rounded = exact.quantize(Decimal(1).scaleb(-left), ROUND_HALF_UP)
        yield broken.replaced(f"{rounded:f}".replace(".", sign), safe=rounded == exact)
