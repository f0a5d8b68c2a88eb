"""Text in `@DECLARE`, or in a section that computes a word.

`@DECLARE` runs before the program starts, to declare words and formats; a section `@$name` runs to
give `#name` its value. Nothing is output there, so the text is lost.

Source: spec/cgt.md §7

Bad:

    @DECLARE
    G90 G21
    ^^^^^^^
    #V1
    ^^^

Bad:

    @DECLARE
    #INT #passes #depth
                 ^^^^^^
    @
    @DWELL
    #REPEAT(#passes)<G04 P#depth>

Bad:

    @DECLARE
    #CALCDEC #side
    @
    @$side
    SIDE #RETNUM(2*#V1)
    ^^^^^
    @
    @DWELL
    #side

Good:

    @DECLARE
    #FMT(#F_Decimal,D3.4)
    #EVAL(#V1=1)  // first pass
"""

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._sections import computed
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Section
from deburr.templates.template import Placed, Use, target


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first text of each line."""
    template = template_of(analysis)
    unknown: set[tuple[int, int]] = set()

    def take(uses: Sequence[Use]) -> None:
        unknown.update([(use.line, use.span.start) for use in uses if use.spelled.kind == "unknown"])

    yield from parted(template.uses, take)
    declared = {each.line: each for each in template.declarations}
    computing = computed(template) - {target(call)[0] for call, _ in template.calls()}
    seen = set[int]()

    def of(items: Sequence[Placed]) -> Iterator[Report]:
        for item, section, _ in items:
            if _silent(section, computing) and item.printed and item.line not in seen:
                seen.add(item.line)
                if (item.line, item.start) in unknown:
                    continue
                hint = "; a comma is missing before it" if item.kind == "word" and item.line in declared else ""
                message = f"`{item.text.strip()}` stands in `@{section.name}`, where nothing is output{hint}"
                yield Report(item.span, message, item.line)

    yield from parted(template.items, of)


def _silent(section: Section, computing: frozenset[str]) -> bool:
    return section.reading == "declare" or section.name in computing


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the comma."""
    if "a comma is missing" in broken.finding.message:
        yield broken.inserted(len(broken.text[: broken.span.start].rstrip()), ",")
