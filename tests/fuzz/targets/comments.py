"""Comments that speak to deburr: which rules they allow, which language they name, which lines they keep as they are."""

from __future__ import annotations

from collections.abc import Iterator

from deburr.check import check
from deburr.detect import Hints, detect
from deburr.formatting.switches import Switches
from deburr.ruleset import RuleSet
from deburr.source import NotAProgram, read
from deburr.suppress import allows
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from fuzz.choices import Choices, joined
from fuzz.stock import numbered
from fuzz.targets.checker import ruleset
from support.places import check_finding, check_span

_FILES = ("", "/a.ngc", "/a.nc", "/a.txt", "a.z32", "/a.")


def run(data: bytes) -> None:
    """A dialect, a file's name, and its bytes."""
    choices = Choices(data)
    dialect, file = by_name(choices.pick(NAMES)), choices.pick(_FILES)
    source = read(choices.rest())
    if isinstance(source, NotAProgram):
        return
    answer = detect(file, source.text, Hints())
    assert answer.reason and (answer.dialect is None or answer.dialect in NAMES)
    document = Document.parse(source.text, dialect, 64)
    lines = [document.line(number) for number in range(document.line_count)]
    for line, names in allows(document).items():
        for each in names:
            check_span(line, each.span, lines)
            assert each.name in ("", lines[line][each.span.start : each.span.end])
    switches = Switches(document)
    assert all(switches.off(number) in (True, False) for number in range(len(lines)))
    rules: RuleSet = ruleset(dialect, False)
    for finding in check(source, dialect, rules):
        check_finding(finding, source.lines)


def seeds() -> Iterator[bytes]:
    """Comments of all sorts in the signs of each dialect."""
    said = (
        "deburr: allow {}.limit -- why",
        "deburr: dialect={}",
        "deburr ignore {}.limit",
        "deburr: format off",
        "deburr: allow",
        "DEBURR: allow {}, cgt.",
        "deburr: format on",
    )
    for number, dialect in numbered():
        texts = [each.format(dialect.name) for each in said]
        for at, (start, end) in enumerate(dialect.comments):
            yield joined((number, at), "\n".join(f"G0 X1 {start}{text}{end}\n{start}{text}{end}" for text in texts))
