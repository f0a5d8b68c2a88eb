"""Word that is not known.

SmartCAM has more words than its public pages list, so a name in capitals may be right; what it
prints is not known, and the template cannot be expanded. A machine file's `[words]` makes it known.

Source: spec/cgt.md §11, *Words*

Bad:

    A#AANGLE
     ^^^^^^^
    <X#XPSO>
      ^^^^^
    #EVAL(#V1=#XPOSY)
              ^^^^^^
    #RESET(#MOV,#AND)
                ^^^^

Good:

    X#XPOS
    #100=5

Good (machine=mill.toml):

    <W#WPOS>
    -- mill.toml --
    [words]
    WPOS = "decimal"
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.symbols import commands, format_classes
from deburr.templates.template import Template, Use


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the word."""
    template = template_of(analysis)
    yield from parted(template.uses, partial(_of, template))


def _of(template: Template, uses: Sequence[Use]) -> Iterator[Report]:
    machine = template.machine
    for use in uses:
        if use.role in ("macro", "declared"):
            continue
        if use.spelled.kind == "unknown":
            if machine.lost or use.said in machine.doubtful:
                continue
            hint = template.symbols.similar(use.said, format_classes() if use.role == "format" else commands())
            yield Report(
                use.span, f"`#{use.said}` is no known word, so the template cannot be expanded{hint}", use.line
            )
        elif use.spelled.kind == "command" and use.role in ("argument", "format"):
            yield Report(use.span, f"`#{use.said}` is a command and has no value", use.line)


fix = did_you_mean
