"""Block that is opened in one file and closed in another.

Snippets are put in as text before blocks are looked at, so this works. But neither file can be read
by itself, and a change of one breaks the other. In a snippet, each end of which the other one is
not there is reported: whoever includes it must supply that.

Source: spec/metagcode.md §4, §6

Bad:

    #IF1 |a| equalto 1 n
    G0 X1
    #FILE close.txt
    ^^^^^^^^^^^^^^^
    -- Snippets/close.txt --
    #ENDIF1

Bad:

    #FILE open.txt
    ^^^^^^^^^^^^^^
    G0 X1
    #ENDIF1
    -- Snippets/open.txt --
    #IF1 |a| equalto 1 n

Good:

    #IF1 |a| equalto 1 n
    #FILE body.txt
    #ENDIF1
    -- Snippets/body.txt --
    #IF1 |b| equalto 1 n
    G0 X1
    #ENDIF1
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.metagcode._gathered import Foreign, Gathered, gathered, ready, said
from deburr.rules.metagcode._matching import Pair
from deburr_grammar.structure import Fault


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the line that brings an end in; in a snippet, also the ends that stand alone."""
    blocks = gathered(analysis)
    yield from parted(blocks.pairs, partial(_across, blocks))
    yield from _alone(blocks)


def _across(blocks: Gathered, pairs: Sequence[Pair]) -> Iterator[Report]:
    for opener, closer, _ in pairs:
        foreign = [end for end in (closer, opener) if isinstance(end.bracket, Foreign)]
        if foreign:
            line, span = blocks.place(foreign[0])
            message = f"the block `{said(opener.bracket)}` is opened in one file and closed in another; neither can be read by itself"
            yield Report(span, message, line, (blocks.note(opener), blocks.note(closer)))


def _alone(blocks: Gathered) -> Iterator[Report]:
    """The ends in a snippet whose other ends must be in the files that include it."""
    for fault in blocks.faults:
        if fault.fault not in (Fault.UNOPENED, Fault.UNCLOSED) or fault.other is not None or not blocks.library.inside:
            continue
        line, span = blocks.place(fault.at)
        does = "closes" if fault.fault is Fault.UNOPENED else "opens"
        other = "opened" if fault.fault is Fault.UNOPENED else "closed"
        yield Report(
            span,
            f"`{said(fault.at.bracket)}` {does} a block that must be {other} by whoever includes this snippet",
            line,
        )
