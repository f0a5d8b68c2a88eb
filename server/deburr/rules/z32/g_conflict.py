"""Two G codes of one group in a block.

They contradict each other, and the last one wins; the first does nothing. A move meant as a rapid
is then made at feed, or the other way round.

Source: spec/z32.md §2

Bad:

    G0 G1 X1
    ^^
    G2 X1 G00 Y2 G01
    ^^    ^^^
    G0 X1 G1 Y2
    ^^

Good:

    G0 G90 X1
    G1 G01 X1
"""

from collections.abc import Iterator
from itertools import pairwise

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import parted
from deburr.rule import Line, Report, Severity, Text, rule, whole
from deburr_grammar.codes import code_number
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Text(r"[Gg][ \t]*[0-9][^\n(;!]*[Gg][ \t]*[0-9]"))
def check(line: Line) -> Iterator[Report]:
    """Report the codes that are overridden."""
    words = sorted(_grouped(line), key=lambda word: word[0])
    for (group, code, word), (next_group, next_code, next_word) in pairwise(words):
        if group == next_group and code != next_code:
            message = f"`{line.said(word)}` is overridden by `{line.said(next_word)}` behind it and does nothing"
            yield Report(whole(word), message)


def _grouped(line: Line) -> Iterator[tuple[str, str, Node]]:
    """The G codes of the line that the tables know: group, code, word."""
    for word in line.node.find("g_word"):
        code = code_number(line.said(word))
        entry = line.node.dialect.codes.entry("code", code)
        if entry is not None:
            yield str(entry.more.get("group")), code, word


def fix(broken: Broken) -> Iterator[Fix]:
    """Split the line before the code that wins, where both have axis words of their own. Which of two was meant otherwise, nobody knows."""
    line = Line(broken.node, broken.analysis.settings)
    starts = [word.start for word in broken.node.find("word", "g_word")]
    words = [(broken.text[start].upper(), start) for start in starts]
    grouped = sorted(_grouped(line), key=lambda word: word[0])
    for (group, _, word), (next_group, _, next_word) in pairwise(grouped):
        if group == next_group and word.start == broken.span.start:
            yield from parted(broken, words, starts.index(word.start), starts.index(next_word.start))
