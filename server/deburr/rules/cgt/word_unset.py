"""Word that nothing has set.

What it would print is not known: a guess could be a feed of 0 or the speed of another tool. The
toolpath sets words by its statements, a `.jsonl` event by `set`, a template by `#EVAL`, and `-D NAME=VALUE`
for one run. Tests whether a word has changed do not read it.

`check` cannot know which toolpaths the template will meet and does not report it; `expand` refuses.

Source: spec/cgt.md §11, *Words*

Bad (input=sample.cl):

    S#SPEED M03
     ^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/0,0,5
    FINI

Bad (input=sample.cl):

    #EVAL(#V1=2*#SPEED)
                ^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/0,0,5
    FINI

Bad (input=sample.cl):

    #UPDATE(#DCOMP)
            ^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/0,0,5
    FINI

Bad (input=sample.cl):

    #EVAL(#V1=JOS(DIA))
              ^^^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/0,0,5
    FINI

Good (input=sample.cl):

    #IFCHG(#SPEED)<#RESET(#SPEED)>#ELSE<S#SPEED>
    F#FEED
    -- sample.cl --
    FEDRAT/200
    GOTO/0,0,5
    FINI
"""

from collections.abc import Iterator

from deburr.fault import Fault
from deburr.rule import Ran, Report, Severity, rule


@rule(Severity.ERROR, Ran(), input=True)
def check(fault: Fault) -> Iterator[Report]:
    """Report the word where it is read."""
    yield Report(fault.span, fault.message)
