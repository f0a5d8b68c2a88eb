"""Variable that the configured file gives no value.

A variable without a value is never taken for empty text: an empty coordinate or a bar on the
machine is not safe, so nothing is generated. Names count as they are written, upper and lower case
included. It is reported only where a file of values is configured, and only on lines that are
generated with them; a use in a snippet is reported at the line that includes it.

Source: spec/metagcode.md §2, §5.2, §6, §10

Bad (variables=part.vars):

    G0 X|Length| Y|width|
                  ^^^^^^^
    #LOOP1 |Dpeth| 2 c
           ^^^^^^^
    G1 Z-|Dpeth|
    #ENDLOOP1
    #IF1 |Length| greaterthan 100 n
    G1 F|Slow|
        ^^^^^^
    #ENDIF1
    -- part.vars --
    Length=120.5
    Width=40
    Depth=6

Bad (variables=part.json):

    G0 X0 (|Customer|)
           ^^^^^^^^^^
    #FILE start.txt
    ^^^^^^^^^^^^^^^
    -- part.json --
    {"Tool": 4, "Name": "plate"}
    -- Snippets/start.txt --
    T|Tool| M6
    S|Speed| M3

Good (variables=part.vars):

    #IF1 |Coolant| equalto flood a
    G1 F|Slow|
    #ENDIF1
    #LOOP1 |Depth| 2 c
    G1 Z-|Depth|
    #ENDLOOP1
    -- part.vars --
    Coolant=mist
    Depth=6

Good:

    G0 X|Length|
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._generated import undefined
from deburr.rules.metagcode._variables import configured
from deburr.rules.metagcode._words import HINTED, nearest


@rule(Severity.ERROR, Whole(), input=True)
def check(analysis: Analysis) -> Iterator[Report]:
    """Report each use. Where the file itself is at fault, that is said instead."""
    found = configured(analysis)
    if found is None or found.read is None or not found.read.whole:
        return
    hints: dict[str, str] = {}
    known = found.given(analysis.inputs.define)
    for use in undefined(analysis, known):
        if use.name not in hints and len(hints) < HINTED:
            hints[use.name] = nearest(use.name, known)
        message = f"`|{use.name}|` has no value in `{found.name}`{hints.get(use.name, '')}"
        yield Report(use.span, message, use.line, use.related)


fix = did_you_mean
