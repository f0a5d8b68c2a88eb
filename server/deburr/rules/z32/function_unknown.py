"""Function that Z32 does not have.

It has SN, CS, TAN, AT, ABS, INT, NEI and RQ; the control refuses any other name before `(`.

Source: spec/z32.md §3, §4

Bad:

    HA<SQ(2)>
       ^^
    HA<1+SIN(30)>
         ^^^
    !HA=ROUND(HB)!
        ^^^^^

Good:

    HA<RQ(2)>
    HA<1+SN(30)>
    !HA=NEI(HB)!
"""

from collections.abc import Iterator
from difflib import get_close_matches

from deburr.fixers import did_you_mean
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem

_ELSEWHERE = {
    "SIN": "SN", "SEN": "SN", "COS": "CS", "TG": "TAN", "ATAN": "AT", "ATG": "AT", "ARCTAN": "AT",
    "SQRT": "RQ", "SQR": "RQ", "SQ": "RQ", "RAD": "RQ", "FIX": "INT", "TRUNC": "INT", "ROUND": "NEI",
}  # fmt: skip
"""What other controls call them."""


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the name."""
    name = line.said(problem).upper()
    names = [entry.name for entry in line.node.dialect.codes.table("function") if not entry.more.get("constant")]
    near = _ELSEWHERE.get(name) or next(iter(get_close_matches(name, names, 1)), None)
    hint = f"did you mean `{near}`?" if near else f"it has {', '.join(names)}"
    yield Report(whole(problem), f"`{line.said(problem)}` is no function of the control; {hint}")


fix = did_you_mean
