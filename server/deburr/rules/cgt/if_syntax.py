"""`#IF` or `#IFSTR` that is no test with a body.

A test compares: `#IF(#V1>3)`, with `= <> > >= < <=`; `#IFSTR` compares a word with a word or with
unquoted text, with `=` or `<>`. Tests are joined by `,#AND` and `,#OR`. The body's `<` follows the
parenthesis directly.

Source: spec/cgt.md §3, §5.4, §11

Bad:

    #IF(#V1)<..>
    ^^^^^^^^
    #IF(#V1>3)
    ^^^^^^^^^^
    #IF(#V1>3) <M08>
    ^^^^^^^^^^
    #IF #V1=3<M08>
    ^^^
    #IF(#V1>3,#V2>3)<M08>
              ^^^
    #IF(#V1=M08)<M08>
    ^^^^^^^^^^^^
    #IF(1<#V1<3)<M08>
             ^
    #IFSTR(#S1)<M08>
    ^^^^^^^^^^^
    #IFSTR(#S1>G00)<M08>
              ^
    #IFSTR(G00=#S1)<M08>
           ^^^
    #IFCHG(#XPOS)
    ^^^^^^^^^^^^^

Good:

    #IF(#V1>3)<M08>#ELSE<M09>
    #IF((#V1+1)*2<>-3,#AND #V2<=3)<M08>
    #IFSTR(#S1=G00 X5)<M08>
    #IFSTR(#S1<>#S2,#OR#S1=)<M08>
    #IFCHG(#XPOS)<M08>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what does not fit."""
    said = line.said(problem)
    what = "is no complete test" if said.upper().startswith("#IF") else "does not fit into the test"
    yield Report(whole(problem), f"`{said}` {what}{expected(problem)}")
